// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measures/measures.h"
#include "meshes/surface_noise.h"

#include <string>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** What to study. */
struct StudyOptions
{
  /** Made if it is missing; an interrupted study in it is continued. */
  std::string folder;
  /** Names of made models. */
  std::vector<std::string> models;
  std::vector<std::string> meshes;
  /** How many times to split the edges of each mesh: one number for all, or one per mesh. */
  std::vector<int> subdivisions {0};
  std::vector<tools::NoiseType> noises {tools::NoiseType::GN, tools::NoiseType::GR};
  /** In mean edge lengths. */
  std::vector<double> sigmas {0.2};
  /** Seeds 1 to this. The sweep uses the first only; with the others, each peer runs only its best setting so far. */
  int seeds = 3;
  bool sweep = true;
  /** Measures for the sweep; everything else gets all of them. */
  MeasureSet sweep_measures = MeasureSet::ALL;
  bool peers = true;
  /** Only the peers' defaults. */
  bool small = false;
  /** Time in seconds that a peer may take for one cloud. */
  double time_limit = 120;
  /** Recorded in study.json. */
  std::string command_line;
};

/** Number of rows of each status. */
struct StudyCounts
{
  std::size_t ok = 0, failed = 0, absent = 0;
};

/** Runs the study. Rows that the folder already holds are kept; failed and absent ones are tried again. If a model, a
  * peer or a row fails, a row records the reason, and the study goes on.
  * \throw FileError if the folder cannot be written to, or holds a study that does not match this one */
StudyCounts
runStudy (const StudyOptions& options);

} // namespace pcl_normal_smoothing::evaluation
