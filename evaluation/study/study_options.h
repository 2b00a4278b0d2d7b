// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line/options.h"
#include "study/study.h"

namespace pcl_normal_smoothing::evaluation
{

/** \param[in,out] study the options write to it; must outlive them */
void
addStudyOptions (tools::Options& options, StudyOptions& study);

/** Sets the folder and the meshes, and what depends on several options, once the command line is parsed.
  * \throw UsageError if options contradict each other */
void
readStudyFiles (const tools::Options& options, StudyOptions& study);

} // namespace pcl_normal_smoothing::evaluation
