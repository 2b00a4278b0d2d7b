// SPDX-License-Identifier: BSD-3-Clause
//
// The table of the kernels of one instruction set; compiled once for each.
#include "far_rows.h"
#include "keep_apart.h"
#include "nearest.h"
#include "normal_filter.h"
#include "normal_vote.h"
#include "other_sheet.h"
#include "plane_votes.h"
#include "point_update.h"
#include "quadric_fit.h"
#include "quadric_projection.h"
#include "step_control.h"

namespace pcl_normal_smoothing
{
namespace core
{
namespace PCL_NORMAL_SMOOTHING_ISA
{
namespace
{
template <typename Arguments>
using LanesKernel = void (*) (const Arguments&, const BlockRows&, int);

template <typename Arguments>
using BlockKernel = void (*) (const Arguments&, const BlockRows&);

constexpr int lanes_of_block = block_size;
static_assert (lanes_of_block % lane_count == 0);

/** Runs a kernel on all lanes of a block that hold a node of their own: the lanes beyond the last node repeat it,
  * and a kernel that works in place must not process its own result. */
template <typename Arguments, LanesKernel<Arguments> kernel>
void
onBlock (const Arguments& arguments, const BlockRows& rows)
{
  for (int first = 0; first < lanes_of_block && (first == 0 || rows.neighbors[first] != rows.neighbors[first - 1]);
       first += lane_count)
    kernel (arguments, rows, first);
}

/** Whether all nodes of a block have the same number of neighbours. */
bool
rowsAreFull (const BlockRows& rows)
{
  const std::uint32_t* last = rows.neighbors + block_size * (rows.length - 1);
  for (int lane = 0; lane < lanes_of_block; ++lane)
    if (last[lane] == rows.neighbors[lane])
      return false;
  return true;
}

template <bool complete>
void
filterNormalsOfBlock (const NormalFilterStep& step, const BlockRows& rows)
{
  if (step.weight == NormalWeight::THRESHOLD)
    onBlock<NormalFilterStep, filterNormals<NormalWeight::THRESHOLD, complete>> (step, rows);
  else if (step.weight == NormalWeight::GAUSSIAN)
    onBlock<NormalFilterStep, filterNormals<NormalWeight::GAUSSIAN, complete>> (step, rows);
  else
    onBlock<NormalFilterStep, filterNormals<NormalWeight::MIXED, complete>> (step, rows);
}

template <bool complete>
void
updatePointsOfBlock (const PointUpdateStep& step, const BlockRows& rows)
{
  if (step.kind == UpdateKind::ROBUST)
    onBlock<PointUpdateStep, updatePoints<UpdateKind::ROBUST, complete>> (step, rows);
  else if (step.kind == UpdateKind::COMPENSATED)
    onBlock<PointUpdateStep, updatePoints<UpdateKind::COMPENSATED, complete>> (step, rows);
  else
    onBlock<PointUpdateStep, updatePoints<UpdateKind::PAPER, complete>> (step, rows);
}

/** Runs the \a complete kernel where all nodes have normals and the block's rows no gaps, otherwise \a any, which
  * checks for both. */
template <typename Step, BlockKernel<Step> complete, BlockKernel<Step> any>
void
whereComplete (const Step& step, const BlockRows& rows)
{
  (step.all_normals && rowsAreFull (rows) ? complete : any) (step, rows);
}

void
voteAllPlanes (const PlaneVotes& votes)
{
  for (int first = 0; first < lanes_of_block; first += lane_count)
    votePlanes (votes, first);
}

std::size_t
selectNearCandidates (const Candidates& candidates,
                      const CandidateQuery& query,
                      float* sq_dists,
                      std::uint32_t* selected)
{
  return selectNear (candidates, query, sq_dists, selected);
}

bool
rankAllKeys (const float* keys, std::size_t count, std::int32_t* ranks)
{
  return rankKeys (keys, count, ranks);
}
} // namespace

#define PCL_NORMAL_SMOOTHING_STRING(x) #x
#define PCL_NORMAL_SMOOTHING_NAME(x) PCL_NORMAL_SMOOTHING_STRING (x)

extern const Kernels table;
const Kernels table = {PCL_NORMAL_SMOOTHING_NAME (PCL_NORMAL_SMOOTHING_ISA),
                       onBlock<DistanceWeights, distanceWeights>,
                       whereComplete<NormalFilterStep, filterNormalsOfBlock<true>, filterNormalsOfBlock<false>>,
                       whereComplete<PointUpdateStep, updatePointsOfBlock<true>, updatePointsOfBlock<false>>,
                       onBlock<StartNormals, startNormals>,
                       onBlock<NormalVoteStep, electNormals>,
                       onBlock<OtherSheetCount, countOthers>,
                       onBlock<QuadricResiduals, residualVariances>,
                       onBlock<QuadricProjection, projectPoints>,
                       onBlock<QuadricFitStep, fitNormals>,
                       onBlock<StepRisks, stepRisks>,
                       onBlock<AveragingWeights, averagingWeights>,
                       onBlock<RiskAverages, averageRisks>,
                       onBlock<StepsToTake, takeSteps>,
                       onBlock<KeepApartStep, keepApart>,
                       onBlock<FarRowsStep, findFarRows>,
                       voteAllPlanes,
                       selectNearCandidates,
                       rankAllKeys};
} // namespace PCL_NORMAL_SMOOTHING_ISA
} // namespace core
} // namespace pcl_normal_smoothing
