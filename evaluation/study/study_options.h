// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line/options.h"
#include "study/study.h"

namespace pcl_normal_smoothing::evaluation
{

/** \param[in,out] study changed by what the options read; lives as long as they do */
void
addStudyOptions (tools::Options& options, StudyOptions& study);

/** The folder and the meshes, once the command line has been parsed; and what follows from all of it.
  * \throw UsageError where options do not go together */
void
readStudyFiles (const tools::Options& options, StudyOptions& study);

} // namespace pcl_normal_smoothing::evaluation
