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

/** The fields x y z. \throw core::Error where the cloud is empty or has none that are all float or all double */
VectorView
positionsOf (const CloudFile& file);

/** Where the fields x y z are. \throw core::Error where there are none that are all float or all double */
VectorLayout
positionLayoutOf (const CloudFile& file);

/** The fields normal_x normal_y normal_z.
  * \param[in] advice what to do where there are none that are all float or all double \throw core::Error then */
VectorLayout
normalLayoutOf (const CloudFile& file, const std::string& advice);

/** What a tool that reads normals says where there are none. */
extern const char* const normals_advice;

/** A note where there are fewer finite points than k. \throw core::Error where there are fewer than 3 */
void
checkPointCount (std::size_t finite_points, std::size_t k);

/** \param[in] query in the cloud's unit */
CloudGraph
searchNeighbors (const CloudFile& file, const core::NeighborQuery& query, const core::Execution& execution);

/** The noise that the neighbourhoods of a cloud show, in its unit: what SurfaceNoiseEstimation tells. */
core::NoiseEstimate
estimateNoise (const CloudFile& file, const core::Execution& execution);

/** What hides the noise, for people; empty for nothing. */
std::string
textOf (core::NoiseHiddenBy hidden_by);

/** Adds the fields of normals that are missing, normal_x normal_y normal_z and \a more, with NaN. */
void
addNormalFields (CloudFile& file, const std::vector<std::string>& more = {});

/** Loads a cloud, and says what of the file is left out. \throw core::Error where it has no positions */
CloudFile
loadInput (const std::string& path);

/** Saves the result, and says so. */
void
saveResult (const CloudFile& file, const std::string& path, FileFormat format);
} // namespace tools
} // namespace pcl_normal_smoothing
