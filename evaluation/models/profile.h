// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** A line, or an arc of less than half a circle, of the outline of a plane figure. */
struct Piece
{
  Eigen::Vector2d from, to;
  /** Of an arc: above 0 where it turns left, below 0 right; 0 = a line. */
  double radius = 0;

  Eigen::Vector2d
  center () const;

  double
  length () const;

  /** The point at the share \a t of the length. */
  Eigen::Vector2d
  at (double t) const;

  double
  distance (const Eigen::Vector2d& point) const;
};

/** A closed outline; the figure lies at its left. */
using Loop = std::vector<Piece>;

/** A plane figure: an outer loop, counterclockwise, and those of holes, clockwise. */
struct Profile
{
  std::vector<Loop> loops;

  /** Distance to the outline. */
  double
  distance (const Eigen::Vector2d& point) const;

  bool
  contains (const Eigen::Vector2d& point) const;
};

/** Through the points, in order. */
Loop
polygon (const std::vector<Eigen::Vector2d>& corners);

/** Rounds the corner at the end of piece \a i, which and whose next are lines, by an arc that touches both. */
void
roundCorner (std::size_t i, double radius, Loop& loop);

/** Four arcs, clockwise. */
Loop
circularHole (const Eigen::Vector2d& center, double radius);

} // namespace pcl_normal_smoothing::evaluation
