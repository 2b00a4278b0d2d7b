// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measures/hinted_mesh_distance.h"
#include "measures/neighborhoods.h"
#include "models/model.h"

#include <limits>

namespace pcl_normal_smoothing::evaluation
{

/** How good a smoothed cloud is; lengths in mean edge lengths of the clean mesh, NaN where there is no value. */
struct Measures
{
  static constexpr double none = std::numeric_limits<double>::quiet_NaN ();

  /** E_A of the paper: |A1 - A0| / A0, where A1 is the area of the mesh with its vertices moved to the points, and A0
    * that of the clean mesh. */
  double area_error = none;
  /** E_k of the paper: mean absolute difference of the surface variation, where k counts the point itself and the
    * neighbours are searched in each cloud separately. */
  double variation_error_7 = none, variation_error_15 = none, variation_error_21 = none;
  /** Distance of the points to the clean mesh. */
  double p2s_mean = none, p2s_rms = none, p2s_max = none;
  /** The mean relative to that of the noisy cloud: 1 = nothing gained. */
  double p2s_ratio = none;
  /** Distance of the points to the vertices that they stem from, and its mean relative to that of the noisy cloud. */
  double p2p_mean = none, p2p_ratio = none;
  /** Mean angle, in degrees and regardless of sign, between the points' PCA normals (k 15) and the normals of the clean
    * mesh's vertices. Computed alike for every method, whether or not it has normals of its own. */
  double normal_angle = none;
  /** For the points whose vertices are within half a mean edge length of a sharp edge (more than 30 degrees): mean
    * distance to the mesh, and the share farther from it than 0.1. */
  double edge_error = none, edge_fraction = none;
  /** 1st percentile of the distances to the nearest other point, relative to that of the noisy cloud: below 1 where
    * points clump. */
  double spacing_p01 = none;
  /** Distance to the exact surface of a made model, and its mean relative to that of the noisy cloud. */
  double exact_mean = none, exact_ratio = none;
  /** As normal_angle, but for the method's own normals. */
  double own_normal_angle = none;
};

enum class MeasureSet
{
  PAPER, //!< the paper's alone, E_A and E_k
  ALL
};

/** Measures clouds in which point i stems from vertex i of one model. */
class Evaluator
{
public:
  /** \param[in] model must outlive the evaluator */
  explicit Evaluator (const Model& model);

  /** Sets the noisy cloud that all others are compared with from now on. */
  void
  setNoisy (const tools::Points& noisy);

  /** \param[in] points finite, as many as the model has vertices \throw core::Error otherwise
    * \param[in] normals the method's own, zero where a point has none; may be empty */
  Measures
  measure (const tools::Points& points, const tools::Points& normals, MeasureSet set) const;

  double
  meanEdge () const
  {
    return mean_edge_;
  }

private:
  void
  check (const tools::Points& points) const;

  /** Sets all distances: to the mesh, also near sharp edges, to the vertices, and to the exact surface if known. */
  void
  measureDistances (const tools::Points& points, Measures& measures) const;

  void
  measureEdges (const std::vector<double>& distances, Measures& measures) const;

  const Model& model_;
  double mean_edge_;
  HintedMeshDistance mesh_distance_;
  tools::Points vertex_normals_;
  Neighborhoods clean_;
  std::vector<std::uint32_t> near_edges_;
  Measures noisy_;
  double noisy_spacing_ = Measures::none;
};

} // namespace pcl_normal_smoothing::evaluation
