// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/moving_surface.h>
#include <pcl_normal_smoothing/core/noise/noise_estimate.h>
#include <pcl_normal_smoothing/core/search/neighbor_graph.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Smoothing in rounds. Each round fits a robust quadric to every neighbourhood and takes its normal; proposes the
  * step of UpdateRule::COMPENSATED, with weights that recognise a neighbour on another sheet by its height; and
  * takes as much of the step as an estimate of the risk allows. At the end, points that came close to each other
  * move apart along the surface. Everything else follows from the noise. Derived in doc/robust_smoothing.md. */
struct RobustSmoothingOptions
{
  /** Of the cloud; sigma 0 leaves it as it is. Weights and risk are based on the local sigma. */
  NoiseEstimate noise;
  /** Number of rounds, at most six. */
  int count = 6;
  /** Fewer solves and averages per round: SmoothingPreset::FAST. */
  bool fast = false;
  /** Normals are consistently oriented: neighbours with opposite normals do not count. */
  bool oriented = false;
  /** A neighbour farther than this from the mean of both tangent planes may lie on another sheet: see
    * core/sheets/sheet_separation.h. In the unit of the positions; infinity: all lie on one sheet. */
  float sheet_distance = std::numeric_limits<float>::infinity ();
  /** Upper bound on the distance of a point from its start, in the unit of the positions. */
  float max_displacement = std::numeric_limits<float>::infinity ();
  /** The points are from a depth camera at the origin, and must end on the rays on which they started. */
  bool along_rays = false;
};

/** \throw Error if an option is out of range */
void
check (const RobustSmoothingOptions& options);

/** Initial normals for the rounds: WPCA (eq. 1) over the \a k nearest, in float; NaN for fewer than 3. For 3 it is
  * any normal across the line of the other two, or NaN. */
Vectors
startNormals (const NeighborGraph& graph, const Positions& positions, const Execution& execution, std::size_t k = 12);

/** \param[in,out] surface with the initial normals; on return with those of the last round */
void
smoothRobustly (const NeighborGraph& graph,
                const RobustSmoothingOptions& options,
                const Execution& execution,
                MovingSurface& surface);
} // namespace core
} // namespace pcl_normal_smoothing
