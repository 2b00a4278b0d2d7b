// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** Describes the study that the rows belong to: study.json. */
struct StudyFile
{
  std::string command_line;
  std::vector<std::string> noises;
  std::vector<double> sigmas;
  std::vector<std::uint64_t> seeds;
};

/** Writes study.json, with the version of the project, and for every model its file, size, mean edge length, source and
  * a fingerprint of its vertices and triangles. Models, noises, sigmas and seeds of an earlier study in the folder stay
  * listed, as its rows stay.
  * \throw FileError if the earlier study is by another version, or used another model of the same name, so that its
  * rows would not match the new ones; or if the file cannot be written */
void
writeStudyFile (const std::string& folder, const StudyFile& study, const std::vector<Model>& models);

} // namespace pcl_normal_smoothing::evaluation
