// SPDX-License-Identifier: BSD-3-Clause
#include "models/profile.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
double
cross (const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return a.x () * b.y () - a.y () * b.x ();
}

Eigen::Vector2d
turnedLeft (const Eigen::Vector2d& v)
{
  return {-v.y (), v.x ()};
}

/** Half the angle that an arc spans. */
double
halfAngle (const Piece& arc)
{
  return std::asin ((arc.to - arc.from).norm () / (2 * std::abs (arc.radius)));
}

/** Whether the point lies between an arc and its chord. */
bool
inSegment (const Piece& arc, const Eigen::Vector2d& point)
{
  const double side = cross (arc.to - arc.from, point - arc.from); // an arc that turns left bulges to the right
  return (point - arc.center ()).norm () < std::abs (arc.radius) && (arc.radius > 0 ? side < 0 : side >= 0);
}
} // namespace

Eigen::Vector2d
Piece::center () const
{
  const Eigen::Vector2d chord = to - from;
  const double height = std::sqrt (std::max (radius * radius - chord.squaredNorm () / 4, 0.0));
  return (from + to) / 2 + (radius > 0 ? height : -height) * turnedLeft (chord).normalized ();
}

double
Piece::length () const
{
  return radius == 0 ? (to - from).norm () : 2 * halfAngle (*this) * std::abs (radius);
}

Eigen::Vector2d
Piece::at (double t) const
{
  if (radius == 0)
    return from + t * (to - from);
  const double angle = 2 * halfAngle (*this) * t;
  return center () + Eigen::Rotation2Dd (radius > 0 ? angle : -angle) * (from - center ());
}

double
Piece::distance (const Eigen::Vector2d& point) const
{
  const double ends = std::min ((point - from).norm (), (point - to).norm ());
  if (radius == 0) {
    const double t = (point - from).dot (to - from) / (to - from).squaredNorm ();
    return t > 0 && t < 1 ? std::abs (cross (to - from, point - from)) / (to - from).norm () : ends;
  }
  const Eigen::Vector2d a = from - center (), b = to - center (), p = point - center ();
  const bool beside = radius > 0 ? cross (a, p) > 0 && cross (p, b) > 0 : cross (a, p) < 0 && cross (p, b) < 0;
  return beside ? std::abs (p.norm () - std::abs (radius)) : ends;
}

double
Profile::distance (const Eigen::Vector2d& point) const
{
  double least = std::numeric_limits<double>::infinity ();
  for (const Loop& loop : loops)
    for (const Piece& piece : loop)
      least = std::min (least, piece.distance (point));
  return least;
}

bool
Profile::contains (const Eigen::Vector2d& point) const
{
  bool inside = false; // first in the polygon of the chords, then inverted for points between a chord and its arc
  for (const Loop& loop : loops)
    for (const Piece& piece : loop) {
      const auto &a = piece.from, &b = piece.to;
      if ((a.y () > point.y ()) != (b.y () > point.y ()) &&
          point.x () < a.x () + (point.y () - a.y ()) / (b.y () - a.y ()) * (b.x () - a.x ()))
        inside = !inside;
      if (piece.radius != 0 && inSegment (piece, point))
        inside = !inside;
    }
  return inside;
}

Loop
polygon (const std::vector<Eigen::Vector2d>& corners)
{
  Loop loop;
  for (std::size_t i = 0; i < corners.size (); ++i)
    loop.push_back ({corners[i], corners[(i + 1) % corners.size ()]});
  return loop;
}

void
roundCorner (std::size_t i, double radius, Loop& loop)
{
  Piece &before = loop[i], &after = loop[(i + 1) % loop.size ()];
  const Eigen::Vector2d in = (before.to - before.from).normalized (), out = (after.to - after.from).normalized ();
  const double turn = std::atan2 (cross (in, out), in.dot (out)), cut = radius * std::tan (std::abs (turn) / 2);
  const Eigen::Vector2d corner = before.to;
  before.to = corner - cut * in;
  after.from = corner + cut * out;
  const Piece arc {before.to, after.from, turn > 0 ? radius : -radius};
  loop.insert (loop.begin () + static_cast<std::ptrdiff_t> (i) + 1, arc);
}

Loop
circularHole (const Eigen::Vector2d& center, double radius)
{
  Loop loop;
  const std::vector<Eigen::Vector2d> ways {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
  for (std::size_t i = 0; i < 4; ++i)
    loop.push_back ({center + radius * ways[i], center + radius * ways[(i + 1) % 4], -radius});
  return loop;
}

} // namespace pcl_normal_smoothing::evaluation
