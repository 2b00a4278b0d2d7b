// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results/results.h"
#include "study/progress.h"
#include "study/study.h"

namespace pcl_normal_smoothing::evaluation
{

/** One noisy cloud of a study, and what the rows about it have in common. */
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

  /** A row of this case, without a result yet. */
  Row
  row (const std::string& family, const std::string& name, const std::string& parameters) const;

  /** The noisy cloud, rounded to float as in a cloud file. */
  tools::Points
  noisyPoints (double mean_edge) const;

  /** "double_torus_GN_0.2_1" */
  std::string
  name () const;
};

/** What all families of rows share while one case is processed. */
struct CaseWork
{
  const StudyOptions& options;
  const Case& noisy_case;
  const Evaluator& evaluator;
  const tools::Points& noisy;
  Results& results;
  Progress& progress;

  /** Path of a cloud of this case, in the study's folder. */
  std::string
  cloudPath (const std::string& stem) const;

  /** Measures and stores a row; if that fails, stores it as failed, with the reason.
    * \param[in] cloud stem of the cloud's file name; empty if it is not kept */
  void
  answer (Work work,
          Row row,
          const tools::Points& points,
          const tools::Points& normals,
          MeasureSet set = MeasureSet::ALL,
          const std::string& cloud = {}) const;

  /** Stores a row without numbers. */
  void
  refuse (Work work, Row row, const std::string& status, const std::string& reason) const;

  /** Saves a cloud. On failure, reports it and leaves row.cloud empty: the numbers remain valid. */
  void
  keepCloud (const std::string& stem, const tools::Points& points, const tools::Points& normals, Row& row) const;

private:
  void
  progressTo (Work work, const Row& row) const;
};

} // namespace pcl_normal_smoothing::evaluation
