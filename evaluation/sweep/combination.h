// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>

#include <string>

namespace pcl_normal_smoothing::evaluation
{

/** One of the paper's 540 ways to smooth. */
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

  /** Options of the tool pcl_normal_smoothing for the same. */
  std::string
  parameters () const;

  /** What smooth () does; k apart. Noise is not estimated: nothing here needs it. */
  core::SmoothingOptions
  options () const;
};

/** All 540: P, W, H; T, G, M; k 7, 15, 21; 2 to 32 normal iterations; 5 to 40 point iterations. The last change
  * fastest. */
std::vector<Combination>
allCombinations ();

} // namespace pcl_normal_smoothing::evaluation
