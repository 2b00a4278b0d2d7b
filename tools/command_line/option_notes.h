// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <pcl_normal_smoothing/core/smoothing.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Notes on options that do something else than they seem to: those of the chain that make it run in place of the
  * rounds, without being told to, those of the rounds where the chain runs, and more neighbours than the rounds use.
  * \param[in] k that is set; 0 = none */
void
noteSurprises (const Options& options, const core::SmoothingOptions& method, int k);
} // namespace tools
} // namespace pcl_normal_smoothing
