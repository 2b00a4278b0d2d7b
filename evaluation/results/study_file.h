// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** What the rows of a study are about: study.json. */
struct StudyFile
{
  std::string command_line;
  std::vector<std::string> noises;
  std::vector<double> sigmas;
  std::vector<std::uint64_t> seeds;
};

/** Writes study.json, with the version of the project, and of every model its file, size, mean edge length, source and
  * a fingerprint of its vertices. Models, noises, sigmas and seeds of an earlier study in the folder stay listed, as
  * their rows do.
  * \throw FileError where the earlier study is by another version, or has another model by one of the names: its rows
  * would not fit to those that come; or where the file cannot be written */
void
writeStudyFile (const std::string& folder, const StudyFile& study, const std::vector<Model>& models);

} // namespace pcl_normal_smoothing::evaluation
