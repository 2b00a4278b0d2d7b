// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/cases.h"

namespace pcl_normal_smoothing::evaluation
{

/** The rows of each family that a case still lacks: planned first, so that the remaining time can be estimated, then
  * computed. */

/** The noisy cloud itself, and the presets. */
void
planOwn (const StudyOptions& options, const Case& noisy_case, const Results& results, Progress& progress);

void
workOnOwn (const CaseWork& work);

/** The 540 combinations; the clouds with the lowest and the highest error are kept. */
void
planSweep (const StudyOptions& options, const Case& noisy_case, const Results& results, Progress& progress);

void
workOnSweep (const CaseWork& work);

/** The settings of the peers, as many in parallel as there are cores. For each peer, the clouds of the default and of
  * the best setting are kept. */
void
planPeers (const StudyOptions& options, const Case& noisy_case, const Results& results, Progress& progress);

void
workOnPeers (const CaseWork& work);

} // namespace pcl_normal_smoothing::evaluation
