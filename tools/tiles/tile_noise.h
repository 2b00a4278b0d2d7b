// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_writer.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Completes the options of a plan with what is to be estimated, as core::prepareSmoothing does it for a whole cloud.
  * \param[in,out] plan with its tiles written
  * \param[in] sample the points from which the noise is estimated
  * \param[in] sheet_limit of the hashes of those of them by which sheets are looked for */
void
prepare (Plan& plan,
         const std::vector<SamplePoint>& sample,
         std::uint32_t sheet_limit,
         const core::Execution& execution);
} // namespace tools
} // namespace pcl_normal_smoothing
