// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_vectors.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
constexpr std::size_t max_kept_neighbors = 32;

/** What is read of all neighbours of the lanes' points, kept where there is room: it is needed twice.
  * \tparam Read gives the vectors of the lanes' j-th neighbours */
template <typename Read>
class NeighborVectors
{
public:
  LANES_INLINE
  NeighborVectors (const Read& read, std::size_t length) : read_ (read), kept_ (length <= max_kept_neighbors)
  {
    for (std::size_t j = 0; kept_ && j < length; ++j)
      vectors_[j] = read (j);
  }

  LANES_INLINE Lanes3
  operator() (std::size_t j) const
  {
    return kept_ ? vectors_[j] : read_ (j);
  }

private:
  const Read& read_;
  bool kept_;
  Lanes3 vectors_[max_kept_neighbors];
};
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
