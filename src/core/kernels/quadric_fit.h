// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "local_points.h"
#include "normal_filter.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** The neighbourhoods of the lanes' points as heights over a plane. */
struct HeightField
{
  Lanes u[max_row_length], v[max_row_length], height[max_row_length];

  LANES_INLINE
  HeightField (const LocalPoints& local, const Frame& frame)
  {
    for (std::size_t j = 0; j < local.count; ++j) {
      u[j] = dot (local.at[j], frame.u);
      v[j] = dot (local.at[j], frame.v);
      height[j] = dot (local.at[j], frame.normal);
    }
  }

  LANES_INLINE Lanes
  residual (const Quadric& quadric, std::size_t j) const
  {
    return height[j] - quadric.height (u[j], v[j]);
  }
};

LANES_INLINE Quadric
fitQuadric (const HeightField& field, std::size_t count, const Lanes* weights, float ridge)
{
  Quadric quadric;
  for (std::size_t j = 0; j < count; ++j)
    quadric.add (field.u[j], field.v[j], field.height[j], weights[j]);
  quadric.solve (splat (ridge));
  return quadric;
}

/** The residual variance of an unweighted quadric fit to a neighbourhood, as a variance of noise along the normal:
  * the sum of squared residuals over the degrees of freedom; NaN where the row is too short. */
LANES_INLINE void
residualVariances (const QuadricResiduals& residuals, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const LocalPoints local (residuals.nodes, rows, own);
  Lanes3 normal = weightedPlaneNormal (local);
  Lanes variance = {};
  for (int pass = 0; pass < 2; ++pass) { // the second in the frame of the first one's gradient
    const Frame frame (normal);
    const HeightField field (local, frame);
    const Quadric quadric = fitQuadric (field, local.count, local.one, 0);
    normal = quadric.normal (frame);
    Lanes sum = {};
    for (std::size_t j = 0; j < local.count; ++j)
      sum += local.one[j] * (field.residual (quadric, j) * field.residual (quadric, j));
    variance = sum / quadric.squaredSecant ();
  }
  const Lanes size = local.size ();
  variance *= local.reach * local.reach / (size - 6);
  const Mask valid = (size >= float (min_fit_points)) & (local.reach > 0);
  store1 (residuals.variances, own, valid ? variance : splat (__builtin_nanf ("")));
}

/** The weights of the neighbours apart from their residuals: exp (-d^2 / (2 .5^2)) in units of the reach and, if \a
  * by_normal, exp (-|n_i - n_j|^2 / (2 .4^2)). As exponents. */
LANES_INLINE void
neighborExponents (const QuadricFitStep& step,
                   const LocalPoints& local,
                   const std::uint32_t* own,
                   Lanes3 own_normal,
                   Lanes* exponents)
{
  for (std::size_t j = 0; j < local.count; ++j) {
    exponents[j] = 2 * dot (local.at[j], local.at[j]);
    if (step.by_normal) {
      const Lanes cosine = dot (own_normal, load3 (step.nodes.normals, own + block_size * j));
      const Lanes x = 1 - similarity (cosine, step.oriented);
      exponents[j] += x == x ? x * 6.25f : splat (0);
    }
  }
}

/** Fits a quadric to every neighbourhood repeatedly, in the frame of the point's normal, each time weighting points
  * by their residuals in the previous fit; the normal becomes the quadric's at the point. With too few points it
  * stays. */
LANES_INLINE void
fitNormals (const QuadricFitStep& step, const BlockRows& rows, int first)
{
  const std::uint32_t* own = rows.neighbors + first;
  const LocalPoints local (step.nodes, rows, own);
  const Lanes3 own_normal = load3 (step.nodes.normals, own);
  Lanes exponents[max_row_length], weights[max_row_length];
  neighborExponents (step, local, own, own_normal, exponents);
  for (std::size_t j = 0; j < local.count; ++j)
    weights[j] = local.one[j] * bell (exponents[j]);

  Frame frame (own_normal);
  HeightField field (local, frame);
  Quadric quadric = fitQuadric (field, local.count, weights, step.ridge);
  const Lanes variance_factor = load1OrOne (step.variance_factors, own);
  const Lanes residual_factor = step.residual_factor / variance_factor * (local.reach * local.reach);
  for (int solve = 1; solve < step.solves; ++solve) {
    const Lanes factor = residual_factor / quadric.squaredSecant ();
    for (std::size_t j = 0; j < local.count; ++j) {
      const Lanes residual = field.residual (quadric, j);
      weights[j] = local.one[j] * bell (exponents[j] + residual * residual * factor);
    }
    if (solve == 1 && step.turn_frame) {
      frame = Frame (quadric.normal (frame));
      field = HeightField (local, frame);
    }
    quadric = fitQuadric (field, local.count, weights, step.ridge);
  }
  const Lanes3 fitted = quadric.normal (frame);
  const Mask valid = (local.size () >= float (min_fit_points)) & (dot (fitted, fitted) > 0.5f);
  store3 (step.fitted, own, choose (valid, fitted, own_normal));
}
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
