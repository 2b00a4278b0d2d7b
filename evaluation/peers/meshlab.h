// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "peer.h"
#include "process.h"

/** The MLS projections of MeshLab 2020.09, run by its program without a window. */
namespace pcl_normal_smoothing::evaluation
{

/** Writes the points and a filter script into the folder.
  * \param[in] setting of "APSS" with the values "filter scale" and "spherical parameter", or of "RIMLS" with "filter
  * scale" and "sharpness" \throw std::runtime_error if they cannot be written */
void
writeMeshLabInput (const WorkFolder& folder, const PeerSetting& setting, const std::vector<Eigen::Vector3d>& points);

std::vector<std::string>
meshLabCommand (const WorkFolder& folder, const std::string& meshlabserver);

/** \throw std::runtime_error if there is no output, or it cannot be read */
std::vector<Eigen::Vector3d>
readMeshLabOutput (const WorkFolder& folder);

} // namespace pcl_normal_smoothing::evaluation
