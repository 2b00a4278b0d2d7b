// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/cloud_io.h"

#include <pcl_normal_smoothing/core/noise/noise_estimate.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>
#include <pcl_normal_smoothing/vector_layout.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A cloud's positions with their neighbourhoods. */
struct CloudGraph
{
  core::NeighborGraph::ConstPtr graph;
  core::Positions nodes; // in the order of the graph
};

/** The fields x y z. \throw core::Error if the cloud is empty, or they are missing or not all float or all double */
VectorView
positionsOf (const CloudFile& file);

/** Layout of the fields x y z. \throw core::Error if they are missing or not all float or all double */
VectorLayout
positionLayoutOf (const CloudFile& file);

/** Layout of the fields normal_x normal_y normal_z.
  * \param[in] advice what to do about the error
  * \throw core::Error if they are missing or not all float or all double */
VectorLayout
normalLayoutOf (const CloudFile& file, const std::string& advice);

/** Advice of a tool that reads normals, if there are none. */
extern const char* const normals_advice;

/** Prints a note if there are fewer finite points than k. \throw core::Error if there are fewer than 3 */
void
checkPointCount (std::size_t finite_points, std::size_t k);

/** \param[in] query in the cloud's unit */
CloudGraph
searchNeighbors (const CloudFile& file, const core::NeighborQuery& query, const core::Execution& execution);

/** Estimates the noise of a cloud from its neighbourhoods, in its unit, as SurfaceNoiseEstimation does. */
core::NoiseEstimate
estimateNoise (const CloudFile& file, const core::Execution& execution);

/** Describes in words what hides the noise; empty for NOTHING. */
std::string
textOf (core::NoiseHiddenBy hidden_by);

/** Adds those of the fields normal_x normal_y normal_z and \a more that are missing, with NaN. */
void
addNormalFields (CloudFile& file, const std::vector<std::string>& more = {});

/** Loads a cloud, and prints a note if it ignores faces. \throw core::Error if it has no positions */
CloudFile
loadInput (const std::string& path);

/** Saves the result, and prints its path and size. */
void
saveResult (const CloudFile& file, const std::string& path, FileFormat format);
} // namespace tools
} // namespace pcl_normal_smoothing
