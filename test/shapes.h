// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/positions.h>

#include <functional>

namespace test_support
{
using pcl_normal_smoothing::core::Positions;
using pcl_normal_smoothing::core::Vectors;

/** Points exactly on a surface (up to float precision), with its normals: outward ones, if it has an outside. */
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

/** A grid of \a side x \a side points in the plane z = 0. */
Shape
planeGrid (int side, float spacing);

/** A plate with grooves four wide and one deep, one per \a pitch, folded like a sheet of paper on which 10,000 points
  * had been spread evenly, one per unit of area. */
Shape
groovedPlate (double pitch);

/** A Fibonacci lattice: evenly spread points. */
Shape
sphere (int count, double radius);

/** A cylinder around the z axis, open at both ends. */
Shape
cylinder (int around, int along, double radius, double height);

/** The faces of [0, edge]^3, each with \a side x \a side points, none of them on an edge. */
Shape
cube (int side, double edge);

/** A torus around the z axis, its points uniformly distributed at random. */
Shape
torus (int count, double major, double minor);

/** Two planes of \a side x \a side points at z = 0 and z = \a gap, normals down and up. */
Shape
parallelSheets (int side, float spacing, float gap);

/** Uniform in [0, 1): a fixed function of its arguments, the same on every machine. */
double
uniformNoise (std::uint64_t seed, std::uint64_t index);

/** Normally distributed, approximately: the sum of twelve uniform numbers, less 6. */
double
gaussianNoise (std::uint64_t seed, std::uint64_t index);

/** Every coordinate displaced by normally distributed noise. */
Vectors
withNoise (const Vectors& points, double sigma, std::uint64_t seed);

/** Every point displaced along its normal by normally distributed noise. */
Vectors
withNormalNoise (const Shape& shape, double sigma, std::uint64_t seed);

/** The same. \param[in] sigma standard deviation of the noise at a position */
Vectors
withNormalNoise (const Shape& shape, const std::function<double (const Eigen::Vector3f&)>& sigma, std::uint64_t seed);

/** The vectors with random signs, as estimated normals have: about half of them are flipped. */
Vectors
withRandomSigns (Vectors vectors, std::uint64_t seed);

/** A permutation of 0 ... size - 1. */
std::vector<std::uint32_t>
permutation (std::size_t size, std::uint64_t seed);

/** The points in the order of permutation (points.size (), seed). */
Vectors
shuffled (const Vectors& points, std::uint64_t seed);

/** The points as positions with zero offsets. */
Positions
asPositions (const Vectors& points);

/** Diagonal of the bounding box. */
double
diagonal (const Vectors& points);

/** The angle between two directions regardless of their signs, 0 to 90. */
double
lineAngleDegrees (const Eigen::Vector3d& a, const Eigen::Vector3d& b);
} // namespace test_support
