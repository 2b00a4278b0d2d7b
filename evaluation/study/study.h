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
  /** Made where it is missing; an interrupted study there is gone on with. */
  std::string folder;
  /** Names of made models. */
  std::vector<std::string> models;
  std::vector<std::string> meshes;
  /** How often to split the edges of every mesh; one number for all, or one for each. */
  std::vector<int> subdivisions {0};
  std::vector<tools::NoiseType> noises {tools::NoiseType::GN, tools::NoiseType::GR};
  /** In mean edge lengths. */
  std::vector<double> sigmas {0.2};
  /** Seeds 1 to this. The sweep is for the first alone; of each peer, those behind it get what was best with it. */
  int seeds = 3;
  bool sweep = true;
  /** Of the sweep; everything else is measured whole. */
  MeasureSet sweep_measures = MeasureSet::ALL;
  bool peers = true;
  /** The peers' defaults only. */
  bool small = false;
  /** Seconds that a peer may take for a cloud. */
  double time_limit = 120;
  /** For study.json. */
  std::string command_line;
};

/** How many rows there are of each status. */
struct StudyCounts
{
  std::size_t ok = 0, failed = 0, absent = 0;
};

/** Runs the study: rows that the folder already holds are kept, those that failed or were absent are tried again. A
  * model, a peer or a row that fails is a row that says why, and the study goes on.
  * \throw FileError where the folder cannot be written to, or holds a study that this one does not fit to */
StudyCounts
runStudy (const StudyOptions& options);

} // namespace pcl_normal_smoothing::evaluation
