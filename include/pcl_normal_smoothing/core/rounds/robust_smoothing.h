// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/moving_surface.h>
#include <pcl_normal_smoothing/core/noise/noise_estimate.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Smoothing in rounds. Each fits a robust quadric to every neighbourhood and takes its normal, proposes the
  * compensated step of UpdateRule::COMPENSATED with weights that see by its height that a neighbour lies on another
  * sheet, and takes as much of the step as an estimate of the risk allows. At the end points that came close to each
  * other move apart along the surface. The noise decides all else. doc/robust_smoothing.md derives it. */
struct RobustSmoothingOptions
{
  /** Of the cloud; sigma 0 leaves it as it is. The weights and the estimate of the risk go by sigma at each place. */
  NoiseEstimate noise;
  /** Rounds, at most six. */
  int rounds = 6;
  /** Fewer solves and averages a round: SmoothingPreset::FAST. */
  bool fast = false;
  /** Normals point to the same side everywhere: neighbours with opposite normals do not count. */
  bool oriented = false;
  /** A neighbour that is farther than this from the mean of both tangent planes may lie on another sheet: see
    * core/sheets/sheet_separation.h. In the unit of the positions; infinity: all lie on one. */
  float sheet_distance = std::numeric_limits<float>::infinity ();
  /** No point ends farther from where it began, in the unit of the positions. */
  float max_displacement = std::numeric_limits<float>::infinity ();
  /** The points are those of a depth camera at the origin, and end on the rays on which they began. */
  bool along_rays = false;
};

/** \throw Error where an option is out of range */
void
check (const RobustSmoothingOptions& options);

/** Normals for the rounds to start from: WPCA (eq. 1) over the \a k nearest, in float; NaN where there are fewer than
  * 3. Of 3 it is any normal across the line of the other two, or NaN. */
Vectors
startNormals (const NeighborGraph& graph, const Positions& positions, const Execution& execution, std::size_t k = 12);

/** \param[in,out] surface with the normals to start from; on return those of the last round */
void
smoothRobustly (const NeighborGraph& graph,
                const RobustSmoothingOptions& options,
                const Execution& execution,
                MovingSurface& surface);
} // namespace core
} // namespace pcl_normal_smoothing
