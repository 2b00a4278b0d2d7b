// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "study/cases.h"

namespace pcl_normal_smoothing::evaluation
{

/** The rows of each family that a case still lacks: planned, so that the time that is left can be told, and then worked
  * on. */

/** The noisy cloud itself, and the presets. */
void
planOwn (const StudyOptions& options, const Case& noisy_case, const Results& results, Progress& progress);

void
workOnOwn (const CaseWork& work);

/** The 540 combinations; the best and the worst by distance to the mesh are kept as clouds. */
void
planSweep (const StudyOptions& options, const Case& noisy_case, const Results& results, Progress& progress);

void
workOnSweep (const CaseWork& work);

/** The settings of the peers, as many at once as there are cores; of each peer the default and the best are kept as
  * clouds. */
void
planPeers (const StudyOptions& options, const Case& noisy_case, const Results& results, Progress& progress);

void
workOnPeers (const CaseWork& work);

} // namespace pcl_normal_smoothing::evaluation
