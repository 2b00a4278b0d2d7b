// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>

#include <string>

namespace pcl_normal_smoothing::evaluation
{

/** One of the 540 combinations of methods and parameters in the paper. */
struct Combination
{
  NormalSource source = NormalSource::PCA;
  NormalWeight weight = NormalWeight::THRESHOLD;
  int k = 7;
  int normal_iterations = 2;
  int point_iterations = 5;

  /** The paper's name for the method and the neighbourhood: PTU7, WPGU21, HMU15. */
  std::string
  name () const;

  /** The equivalent options of the tool pcl_normal_smoothing. */
  std::string
  parameters () const;

  /** The equivalent options of smooth (), except k. The noise is not estimated, as nothing here needs it. */
  core::SmoothingOptions
  options () const;
};

/** All 540: P, W, H; T, G, M; k 7, 15, 21; 2 to 32 normal iterations; 5 to 40 point iterations. The last varies
  * fastest. */
std::vector<Combination>
allCombinations ();

} // namespace pcl_normal_smoothing::evaluation
