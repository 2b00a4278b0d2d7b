// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <pcl_normal_smoothing/core/smoothing.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Prints notes on options whose effect may surprise: those of the chain that make it run in place of the rounds
  * although nobody chose it, those of the rounds if the chain runs, and more neighbours than the rounds use.
  * \param[in] k as given; 0 = not given */
void
noteSurprises (const Options& options, const core::SmoothingOptions& method, int k);
} // namespace tools
} // namespace pcl_normal_smoothing
