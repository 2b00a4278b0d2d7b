// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds/cloud_points.h"

namespace pcl_normal_smoothing::evaluation
{

/** Writes points as a binary PLY cloud; makes the folder if it is missing.
  * \param[in] normals zero where a point has none; may be empty \throw FileError */
void
savePoints (const tools::Points& points, const tools::Points& normals, const std::string& path);

} // namespace pcl_normal_smoothing::evaluation
