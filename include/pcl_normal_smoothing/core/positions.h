// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
using Vectors = std::vector<Eigen::Vector3f>;

/** Points as unevaluated sums base + offset.
  *
  * The base is the input in float, the offset what is added to it: the rest of an input in double, and the
  * displacement. A difference is taken base from base first, which is exact for neighbours however far they lie from
  * the origin; so a cloud at UTM coordinates is smoothed as if it lay at the origin, and in float. */
struct Positions
{
  Vectors base;
  Vectors offset;

  std::size_t
  size () const
  {
    return base.size ();
  }

  /** p_j - p_i */
  Eigen::Vector3f
  difference (std::uint32_t i, std::uint32_t j) const
  {
    return (base[j] - base[i]) + (offset[j] - offset[i]);
  }
};

/** One point's neighbourhood as its kernels see it: the differences p_j - p_i in the order of the row. */
class Neighborhood
{
public:
  Neighborhood (const Positions& surface,
                const Eigen::Vector3f& base,
                const Eigen::Vector3f& offset,
                const std::uint32_t* begin,
                const std::uint32_t* end)
  : surface_ (surface), base_ (base), offset_ (offset), begin_ (begin), end_ (end)
  {}

  std::size_t
  size () const
  {
    return static_cast<std::size_t> (end_ - begin_);
  }

  Eigen::Vector3f
  operator[] (std::size_t j) const
  {
    return (surface_.base[begin_[j]] - base_) + (surface_.offset[begin_[j]] - offset_);
  }

  const Eigen::Vector3f&
  base () const
  {
    return base_;
  }

private:
  const Positions& surface_;
  Eigen::Vector3f base_;
  Eigen::Vector3f offset_;
  const std::uint32_t* begin_;
  const std::uint32_t* end_;
};
} // namespace core
} // namespace pcl_normal_smoothing
