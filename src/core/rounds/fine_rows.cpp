// SPDX-License-Identifier: BSD-3-Clause
#include "fine_rows.h"

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Lower bound on sigma over the spacing. The fine_k nearest then reach 3.8 sigmas.
constexpr float wide_ratio = .6f;

/** The local spacing, from the distance of the farthest of the max_row_length nearest. */
float
spacingIn (const Row& row, const Positions& positions)
{
  const std::size_t size = std::min (row.size (), max_row_length);
  const std::uint32_t own = row[0], farthest = row[size - 1];
  const Eigen::Vector3f reach =
      (positions.base[farthest] - positions.base[own]) + (positions.offset[farthest] - positions.offset[own]);
  return reach.norm () * std::sqrt (static_cast<float> (M_PI) / static_cast<float> (size));
}

/** The mean over the node and its neighbours: a single value scatters by a tenth. */
float
meanIn (const Row& row, const Numbers& spacings)
{
  const std::size_t size = std::min (row.size (), max_row_length);
  float sum = 0;
  for (std::size_t j = 0; j < size; ++j)
    sum += spacings[row[j]];
  return sum / static_cast<float> (size);
}
} // namespace

FineRows::FineRows (const NeighborGraph& graph,
                    const Positions& positions,
                    float sigma,
                    const Numbers& variance_factors,
                    const Execution& execution)
: graph_ (graph), is_wide_ (graph.size ())
{
  Numbers spacings (graph.size ());
  parallelFor (graph.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
      spacings[node] = spacingIn (graph.row (node), positions);
  });
  parallelFor (graph.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      const Row row = graph.row (node);
      const float here = sigma * std::sqrt (variance_factors.empty () ? 1 : variance_factors[node]);
      is_wide_[node] = row.size () > fine_k && here >= wide_ratio * meanIn (row, spacings);
    }
  });
  if (std::find (is_wide_.begin (), is_wide_.end (), 1) == is_wide_.end ())
    std::vector<std::uint8_t> ().swap (is_wide_);
}

BlockRows
FineRows::ofBlock (const BlockRows& rows, Buffer& buffer) const
{
  const std::size_t length = std::min (rows.length, max_row_length);
  const auto isWide = [&] (std::size_t lane) { return is_wide_[rows.neighbors[lane]] != 0; };
  std::size_t wide = 0;
  for (std::size_t lane = 0; lane < block_size && !areAllFine (); ++lane)
    wide += isWide (lane);
  if (wide == 0)
    return {rows.neighbors, std::min (length, fine_k)};
  if (wide == block_size)
    return {rows.neighbors, length};
  for (std::size_t j = 0; j < length; ++j)
    for (std::size_t lane = 0; lane < block_size; ++lane) // a row is padded with the node itself
      buffer.neighbors[j * block_size + lane] =
          rows.neighbors[(j < fine_k || isWide (lane) ? j * block_size : 0) + lane];
  return {buffer.neighbors, length};
}

Numbers
FineRows::scaledWhereWide (const float* factors, float wide_factor) const
{
  Numbers scaled (is_wide_.size ());
  for (std::size_t node = 0; node < scaled.size (); ++node)
    scaled[node] = (factors != nullptr ? factors[node] : 1) * (is_wide_[node] != 0 ? wide_factor : 1);
  return scaled;
}
} // namespace core
} // namespace pcl_normal_smoothing
