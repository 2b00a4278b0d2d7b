// SPDX-License-Identifier: BSD-3-Clause
#include "models/made_models.h"

#include "meshes/double_torus.h"
#include "models/extrusion.h"
#include "models/sheets.h"
#include "models/sphere_meshes.h"

#include <pcl_normal_smoothing/core/error.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
DistanceFunction
numericDistance (const ImplicitSurface& surface)
{
  return [surface] (const Eigen::Vector3d& p) { return distanceTo (surface, p); };
}

Model
extruded (const std::string& name, const std::string& source, const Profile& profile, double height, double spacing)
{
  return {name, source, extrude (profile, height, spacing),
          [=] (const Eigen::Vector3d& p) { return distanceToExtrusion (profile, height, p); }};
}

Profile
rectangle (double width, double depth)
{
  return {{polygon ({{0, 0}, {width, 0}, {width, depth}, {0, depth}})}};
}

Model
doubleTorus (const std::string& name, const std::string& tube, const tools::DoubleTorus& torus)
{
  return {name, "made in code: a smooth surface of genus 2, its tube " + tube, tools::makeDoubleTorus (torus, 4350),
          numericDistance ({torus.value, torus.gradient})};
}

Model
csgPart ()
{
  Loop outline = polygon ({{0, 0}, {1.4, 0}, {1.4, 0.45}, {0.5, 0.45}, {0.5, 1.1}, {0, 1.1}});
  roundCorner (2, 0.15, outline); // the inner corner first: every rounded corner inserts a piece
  roundCorner (1, 0.2, outline);
  return extruded ("csg_part", "made in code: an extruded L with a fillet, a rounded corner and a bore",
                   {{outline, circularHole ({1.0, 0.2}, 0.11)}}, 0.4, 0.026);
}

Model
organic ()
{
  return {"organic", "made in code: bumps on a ball, four times as dense at the top as at the bottom",
          makeUnevenBall (5), numericDistance (bumpyBall ())};
}

/** Two parallel squares, \a spacings point spacings apart. */
Model
sheets (const std::string& name, const std::string& distance, double spacings)
{
  constexpr std::uint32_t side = 50;
  const double gap = spacings / (side - 1);
  return {name, "made in code: two parallel squares, " + distance + " apart (the paper's Fig. 10)",
          makeSheets (side, gap), [gap] (const Eigen::Vector3d& p) { return distanceToSheets (gap, p); }};
}

Model
sphere ()
{
  return {"sphere", "made in code: an icosahedron, five times subdivided", makeSphere (5),
          [] (const Eigen::Vector3d& p) { return std::abs (p.norm () - 1); }};
}

using Maker = Model (*) ();

const std::vector<std::pair<std::string, Maker>>&
makers ()
{
  static const std::vector<std::pair<std::string, Maker>> all {
      {"double_torus",
       [] { return doubleTorus ("double_torus", "two to five spacings thick", tools::figureOfEight ()); }},
      {"double_torus_round",
       [] { return doubleTorus ("double_torus_round", "ten spacings thick", tools::joinedTori ()); }},
      {"csg_part", csgPart},
      {"plate",
       [] {
         return extruded ("plate", "made in code: a plate, about two spacings thick", rectangle (1, 0.75), 0.04, 0.018);
       }},
      {"organic", organic},
      {"two_sheets", [] { return sheets ("two_sheets", "one spacing of their points", 1); }},
      {"two_sheets_apart", [] { return sheets ("two_sheets_apart", "two spacings of their points", 2); }},
      {"cube", [] { return extruded ("cube", "made in code", rectangle (1, 1), 1, 1.0 / 28); }},
      {"sphere", sphere}};
  return all;
}
} // namespace

const std::vector<std::string>&
madeModelNames ()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& maker : makers ())
      all.push_back (maker.first);
    return all;
  }();
  return names;
}

Model
makeModel (const std::string& name)
{
  for (const auto& [known, make] : makers ())
    if (known == name)
      return make ();
  throw core::Error ("there is no made model " + name);
}

} // namespace pcl_normal_smoothing::evaluation
