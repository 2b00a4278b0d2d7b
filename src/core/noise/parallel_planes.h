// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "layer_test.h"

#include <algorithm>
#include <vector>

namespace pcl_normal_smoothing
{
namespace core
{
/** Points that lie in parallel planes with their nearest, and their surroundings. */
class ParallelPlanes
{
public:
  /** \param[in] height of the plane \param[in] is_line whether the nearest lie on a line */
  void
  add (double height, const LayerSurrounding& surrounding, bool is_line)
  {
    heights_.push_back (height);
    if (surrounding.is_off)
      frayed_.push_back ({height, surrounding.to_nearest_off});
    if (surrounding.step > 0) {
      steps_.push_back ({height, surrounding.step});
      lines_ += is_line ? 1 : 0;
    }
  }

  /** The share of the points with others off their plane that see a layer next to theirs. */
  double
  shareStepped () const
  {
    return static_cast<double> (steps_.size ()) / off ();
  }

  /** \param[in] flat number of points in planes, parallel or not */
  bool
  areLayers (double flat)
  {
    const auto all = static_cast<double> (heights_.size ()), stepped = static_cast<double> (steps_.size ());
    return all > min_share_parallel * flat && off () > std::max (min_share_off * flat, min_count_off) &&
           stepped > min_share_stepped * off () && lines_ <= max_share_lines * stepped &&
           lieBetween (steps_, min_share_between);
  }

  /** Whether they are layers, or would be if noise had not frayed them: true of other stacks of planes too. */
  bool
  mayBeFrayedLayers (double flat)
  {
    return static_cast<double> (heights_.size ()) > min_share_parallel_frayed * flat && off () > min_count_off &&
           lieBetween (frayed_, min_share_between_frayed);
  }

private:
  // Share of the flat neighbourhoods that must be parallel; on a slanting table, rows of pixels a step apart are flat
  // too.
  static constexpr double min_share_parallel = .12;
  static constexpr double min_share_off = .1; // share of the flat ones that must have points off their plane nearby
  // Share of those seeing a layer that must lie between two; cameras have .8 and more.
  static constexpr double min_share_between = .5;
  // Upper bound on the share of these with their nearest on a line: above it, the planes are those of a profiler's lines.
  static constexpr double max_share_lines = .6;
  // Noise of more than half a step frays layers so that they lie one through the other and none has an edge. What is flat
  // is then parallel almost without exception, and has planes a step above and below: these are the least shares.
  static constexpr double min_share_parallel_frayed = .9, min_share_between_frayed = .8;

  struct Step
  {
    double height, size;
  };

  double
  off () const
  {
    return static_cast<double> (frayed_.size ());
  }

  /** Whether most have a plane a step above, and one a step below. */
  bool
  lieBetween (const std::vector<Step>& steps, double min_share)
  {
    std::sort (heights_.begin (), heights_.end ());
    const auto between = std::count_if (steps.begin (), steps.end (), [&] (const Step& step) {
      return hasPlane (step.height, step.size) && hasPlane (step.height, -step.size);
    });
    return static_cast<double> (between) > min_share * static_cast<double> (steps.size ());
  }

  /** Whether there is a plane about \a way off \a height. */
  bool
  hasPlane (double height, double way) const
  {
    const auto [low, high] = std::minmax ({height + .6 * way, height + 1.5 * way});
    const auto next = std::lower_bound (heights_.begin (), heights_.end (), low);
    return next != heights_.end () && *next < high;
  }

  std::vector<double> heights_;
  std::vector<Step> steps_;
  std::vector<Step> frayed_; // to the nearest point off the plane, whether a layer begins there or not
  double lines_ = 0;
};
} // namespace core
} // namespace pcl_normal_smoothing
