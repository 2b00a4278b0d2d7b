// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** A piece of the outline of a plane figure: a line, or an arc of less than half a circle. */
struct Piece
{
  Eigen::Vector2d from, to;
  /** Radius of an arc: positive if it turns left, negative if right; 0 = a line. */
  double radius = 0;

  Eigen::Vector2d
  center () const;

  double
  length () const;

  /** The point at the fraction \a t of the length. */
  Eigen::Vector2d
  at (double t) const;

  double
  distance (const Eigen::Vector2d& point) const;
};

/** A closed outline; the figure lies to its left. */
using Loop = std::vector<Piece>;

/** A plane figure: a counterclockwise outer loop, and clockwise loops around the holes. */
struct Profile
{
  std::vector<Loop> loops;

  /** Distance to the outline. */
  double
  distance (const Eigen::Vector2d& point) const;

  bool
  contains (const Eigen::Vector2d& point) const;
};

/** The closed polygon through the points, in order. */
Loop
polygon (const std::vector<Eigen::Vector2d>& corners);

/** Rounds the corner between piece \a i and the next, both of them lines, by an arc that is tangent to both. */
void
roundCorner (std::size_t i, double radius, Loop& loop);

/** A circular hole: four arcs, clockwise. */
Loop
circularHole (const Eigen::Vector2d& center, double radius);

} // namespace pcl_normal_smoothing::evaluation
