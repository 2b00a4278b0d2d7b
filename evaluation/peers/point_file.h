// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <string>
#include <string_view>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** Writes a file in a run's own folder. Unlike the tools' OutputFile, several threads may use it at once.
  * \throw std::runtime_error if the disk is full */
void
writeBytes (const std::string& path, std::string_view bytes);

/** Writes x, y, z of each point as doubles in this machine's byte order. \throw std::runtime_error */
void
writePoints (const std::string& path, const std::vector<Eigen::Vector3d>& points);

/** \throw std::runtime_error if there is no such file, or it ends within a point */
std::vector<Eigen::Vector3d>
readPoints (const std::string& path);

} // namespace pcl_normal_smoothing::evaluation
