// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lane_vectors.h"

#include "../limits.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
/** What is read for all neighbours of the lanes' points. It is needed twice, and kept if it fits.
  * \tparam Read gives the Value of the lanes' j-th neighbours */
template <typename Value, typename Read>
class NeighborValues
{
public:
  LANES_INLINE
  NeighborValues (const Read& read, std::size_t length) : read_ (read), kept_ (length <= max_row_length)
  {
    for (std::size_t j = 0; kept_ && j < length; ++j)
      values_[j] = read (j);
  }

  LANES_INLINE Value
  operator() (std::size_t j) const
  {
    return kept_ ? values_[j] : read_ (j);
  }

private:
  const Read& read_;
  bool kept_;
  Value values_[max_row_length];
};
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
