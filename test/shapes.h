// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/positions.h>

#include <functional>

namespace test_support
{
using pcl_normal_smoothing::core::Positions;
using pcl_normal_smoothing::core::Vectors;

/** Points that lie exactly (as far as float goes) on a surface, with its normals, outward where there is an outside. */
struct Shape
{
  Vectors points;
  Vectors normals;

  std::size_t
  size () const
  {
    return points.size ();
  }
};

/** z = 0, \a side x \a side points. */
Shape
planeGrid (int side, float spacing);

/** A plate with grooves four wide and one deep, every \a pitch, as if it were paper on which 10,000 points are spread
  * evenly, one on a unit of area, and that was folded then. */
Shape
groovedPlate (double pitch);

/** A Fibonacci lattice, spread evenly. */
Shape
sphere (int count, double radius);

/** The axis is z, open at both ends. */
Shape
cylinder (int around, int along, double radius, double height);

/** The faces of [0, edge]^3, \a side x \a side points in each, none on an edge. */
Shape
cube (int side, double edge);

/** The axis is z, the points spread evenly at random. */
Shape
torus (int count, double major, double minor);

/** Two planes of \a side x \a side points at z = 0 and z = \a gap, normals down and up. */
Shape
parallelSheets (int side, float spacing, float gap);

/** Uniform in [0, 1): a fixed function of its arguments, the same on every machine. */
double
uniformNoise (std::uint64_t seed, std::uint64_t index);

/** Normally distributed: the sum of twelve uniform numbers. */
double
gaussianNoise (std::uint64_t seed, std::uint64_t index);

/** Every coordinate displaced by normally distributed noise. */
Vectors
withNoise (const Vectors& points, double sigma, std::uint64_t seed);

/** Every point displaced along its normal by normally distributed noise. */
Vectors
withNormalNoise (const Shape& shape, double sigma, std::uint64_t seed);

/** The same. \param[in] sigma of the noise at a place */
Vectors
withNormalNoise (const Shape& shape, const std::function<double (const Eigen::Vector3f&)>& sigma, std::uint64_t seed);

/** About half of the vectors turned round, as estimated normals are. */
Vectors
withRandomSigns (Vectors vectors, std::uint64_t seed);

/** A permutation of 0 ... size - 1. */
std::vector<std::uint32_t>
permutation (std::size_t size, std::uint64_t seed);

/** In the order of permutation (points.size (), seed). */
Vectors
shuffled (const Vectors& points, std::uint64_t seed);

/** Offsets are zero. */
Positions
asPositions (const Vectors& points);

/** Diagonal of the bounding box. */
double
diagonal (const Vectors& points);

/** The angle between two directions of any sign, 0 to 90. */
double
lineAngleDegrees (const Eigen::Vector3d& a, const Eigen::Vector3d& b);
} // namespace test_support
