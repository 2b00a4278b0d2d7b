// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/results.h"
#include "study/progress.h"
#include "study/study.h"

namespace pcl_normal_smoothing::evaluation
{

/** One noisy cloud of a study, and what rows about it have in common. */
struct Case
{
  const Model& model;
  tools::NoiseType noise;
  double sigma; // in mean edge lengths
  std::uint64_t seed;

  bool
  isFirst () const
  {
    return seed == 1;
  }

  /** A row of this case, not answered yet. */
  Row
  row (const std::string& family, const std::string& name, const std::string& parameters) const;

  /** The noisy cloud, in float as clouds are kept. */
  tools::Points
  noisyPoints (double mean_edge) const;

  /** "double_torus_GN_0.2_1" */
  std::string
  name () const;
};

std::string
noiseName (tools::NoiseType noise);

/** What the families of rows share while one case is worked on. */
struct CaseWork
{
  const StudyOptions& options;
  const Case& noisy_case;
  const Evaluator& evaluator;
  const tools::Points& noisy;
  Results& results;
  Progress& progress;

  /** Where a cloud of this case goes, in the study's folder. */
  std::string
  cloudPath (const std::string& stem) const;

  /** Measures and puts a row: failed, with the reason, where that cannot be.
    * \param[in] cloud the stem of the cloud's name; empty where it is not kept */
  void
  answer (Work work,
          Row row,
          const tools::Points& points,
          const tools::Points& normals,
          MeasureSet set = MeasureSet::ALL,
          const std::string& cloud = {}) const;

  /** Puts a row that has no numbers. */
  void
  refuse (Work work, Row row, const std::string& status, const std::string& reason) const;

  /** Saves a cloud; on failure says so and leaves row.cloud empty: the numbers are there all the same. */
  void
  keepCloud (const std::string& stem, const tools::Points& points, const tools::Points& normals, Row& row) const;

private:
  void
  progressTo (Work work, const Row& row) const;
};

} // namespace pcl_normal_smoothing::evaluation
