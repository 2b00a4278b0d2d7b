// SPDX-License-Identifier: BSD-3-Clause
//
// The table of the kernels of one instruction set; compiled once for each.
#include "nearest.h"
#include "normal_filter.h"
#include "point_update.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
namespace
{
constexpr int block_size = 16;

void
distanceFactorsOfBlock (const NodeArrays& nodes, const BlockRows& rows, float* factors)
{
  for (int first = 0; first < block_size; first += lane_count)
    distanceFactors (nodes, rows, first, factors);
}

template <int weight_kind>
void
filterBlock (const NormalFilterStep& step, const BlockRows& rows)
{
  for (int first = 0; first < block_size; first += lane_count)
    filterNormals<weight_kind> (step, rows, first);
}

void
filterNormalsOfBlock (const NormalFilterStep& step, const BlockRows& rows)
{
  if (step.weight == 0)
    filterBlock<0> (step, rows);
  else if (step.weight == 1)
    filterBlock<1> (step, rows);
  else
    filterBlock<2> (step, rows);
}

void
updatePointsOfBlock (const PointUpdateStep& step, const BlockRows& rows)
{
  for (int first = 0; first < block_size; first += lane_count)
    if (step.compensated)
      updatePoints<true> (step, rows, first);
    else
      updatePoints<false> (step, rows, first);
}

std::size_t
selectNearCandidates (const Candidates& candidates,
                      const CandidateQuery& query,
                      float* sq_dists,
                      std::uint32_t* selected)
{
  squaredDistances (candidates, query, sq_dists);
  return selectNear (sq_dists, candidates.count, query.sq_bound, selected);
}

void
rankAllKeys (const float* keys, std::size_t count, std::int32_t* ranks)
{
  rankKeys (keys, count, ranks);
}
} // namespace

#define PCL_NORMAL_SMOOTHING_STRING(x) #x
#define PCL_NORMAL_SMOOTHING_NAME(x) PCL_NORMAL_SMOOTHING_STRING (x)

extern const Kernels table;
const Kernels table = {PCL_NORMAL_SMOOTHING_NAME (PCL_NORMAL_SMOOTHING_ISA), distanceFactorsOfBlock,
                       filterNormalsOfBlock, updatePointsOfBlock, selectNearCandidates, rankAllKeys};
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
