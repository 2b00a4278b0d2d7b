// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** Writes a file in a run's own folder. Unlike the tools' OutputFile it may be used by several threads at once.
  * \throw std::runtime_error where the disk is full */
void
writeBytes (const std::string& path, std::string_view bytes);

/** Writes x, y, z of each point as doubles, as this machine holds them. \throw std::runtime_error */
void
writePoints (const std::string& path, const std::vector<Eigen::Vector3d>& points);

/** \throw std::runtime_error where there is no such file, or it does not end with a whole point */
std::vector<Eigen::Vector3d>
readPoints (const std::string& path);

} // namespace pcl_normal_smoothing::evaluation
