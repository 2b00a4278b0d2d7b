// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/padded_allocator.h>

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
using Vectors = PaddedVector<Eigen::Vector3f>;
using Numbers = PaddedVector<float>;
/** A selection of points of a cloud, by their numbers. */
using Elements = PaddedVector<std::uint32_t>;

/** Sums in the same order as FLANN and the kd-tree: Eigen's squaredNorm rounds differently, which could change the
  * order of near ties. */
inline float
squaredLength (const Eigen::Vector3f& difference)
{
  return (difference.x () * difference.x () + difference.y () * difference.y ()) + difference.z () * difference.z ();
}

/** Points as unevaluated sums base + offset.
  *
  * The base is the input in float; the offset is added to it: the remainder of an input in double, and the
  * displacement. Differences subtract the bases first, which is exact for neighbours however far they lie from the
  * origin; so a cloud at UTM coordinates is smoothed in float as if it lay at the origin. */
struct Positions
{
  Vectors base;
  Vectors offset;
  /** Lengths times this are in the cloud's unit. A power of two, so that nothing is rounded: kernels compute fourth
    * powers of lengths in float, so a cloud measured in 1e-30 or 1e30 is converted to another unit. */
  double unit = 1;

  std::size_t
  size () const
  {
    return base.size ();
  }

  /** p_i in the cloud's unit, rounded to float. */
  Eigen::Vector3f
  inCloudUnit (std::size_t i) const
  {
    const Eigen::Vector3f position = base[i] + offset[i];
    return unit == 1 ? position : Eigen::Vector3f ((unit * position.cast<double> ()).cast<float> ());
  }

  /** p_j - p_i */
  Eigen::Vector3f
  difference (std::uint32_t i, std::uint32_t j) const
  {
    return (base[j] - base[i]) + (offset[j] - offset[i]);
  }
};

/** Whether any offset is not zero; those of a cloud in float are all zero until it moves. */
bool
hasOffsets (const Positions& positions);

/** The offsets of points that are about to move; empty if all are zero. */
Vectors
startOf (const Positions& positions);

/** The displacements of points since \a start, as returned by startOf. */
Vectors
displacements (const Vectors& start, const Positions& positions);

/** A hash of one point's coordinates, uniform over 32 bits, independent of the order of the points. */
std::uint32_t
hashOf (const Positions& positions, std::size_t i);

/** A list of points: every \a stride-th number of an array. */
class Row
{
public:
  Row (const std::uint32_t* first, std::size_t size, std::size_t stride)
  : first_ (first), size_ (size), stride_ (stride)
  {}

  std::size_t
  size () const
  {
    return size_;
  }

  std::uint32_t
  operator[] (std::size_t j) const
  {
    return first_[j * stride_];
  }

private:
  const std::uint32_t* first_;
  std::size_t size_;
  std::size_t stride_;
};

/** One point's neighbourhood as an estimator sees it: the differences p_j - p_i in the order of the row. */
class Neighborhood
{
public:
  /** \param[in] base, offset p_i, as in Positions */
  Neighborhood (const Positions& surface, const Eigen::Vector3f& base, const Eigen::Vector3f& offset, const Row& row)
  : surface_ (surface), base_ (base), offset_ (offset), row_ (row)
  {}

  std::size_t
  size () const
  {
    return row_.size ();
  }

  Eigen::Vector3f
  operator[] (std::size_t j) const
  {
    return (surface_.base[row_[j]] - base_) + (surface_.offset[row_[j]] - offset_);
  }

  /** p_i in float. */
  const Eigen::Vector3f&
  base () const
  {
    return base_;
  }

  /** The rest of p_i, beyond float. */
  const Eigen::Vector3f&
  offset () const
  {
    return offset_;
  }

private:
  const Positions& surface_;
  Eigen::Vector3f base_;
  Eigen::Vector3f offset_;
  Row row_;
};
} // namespace core
} // namespace pcl_normal_smoothing
