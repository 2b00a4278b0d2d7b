// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tile_writer.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Estimates what the options of a plan leave open, as core::prepareSmoothing does for a whole cloud.
  * \param[in,out] plan with its tiles written
  * \param[in] sample the points from which the noise is estimated
  * \param[in] sheet_limit limit on the hashes of those points by which sheets are looked for */
void
completeOptions (Plan& plan,
                 const std::vector<SamplePoint>& sample,
                 std::uint32_t sheet_limit,
                 const core::Execution& execution);
} // namespace tools
} // namespace pcl_normal_smoothing
