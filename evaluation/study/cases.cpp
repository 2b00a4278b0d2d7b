// SPDX-License-Identifier: BSD-3-Clause
#include "study/cases.h"

#include "command_line/tool.h"
#include "files/tool_error.h"
#include "study/clouds.h"

#include <charconv>
#include <new>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
std::string
shortest (double number)
{
  char digits[40];
  return {digits, std::to_chars (digits, digits + sizeof digits, number).ptr};
}
} // namespace

Row
Case::row (const std::string& family, const std::string& method, const std::string& parameters) const
{
  Row row;
  row.model = model.name;
  row.points = model.mesh.vertices.size ();
  row.noise = tools::nameOf (noise);
  row.sigma = sigma;
  row.seed = seed;
  row.family = family;
  row.name = method;
  row.parameters = parameters;
  return row;
}

tools::Points
Case::noisyPoints (double mean_edge) const
{
  tools::Points points = tools::noisyVertices (model.mesh, noise, sigma * mean_edge, seed);
  for (Eigen::Vector3d& point : points)
    point = point.cast<float> ().cast<double> ();
  return points;
}

std::string
Case::name () const
{
  return model.name + "_" + tools::nameOf (noise) + "_" + shortest (sigma) + "_" + std::to_string (seed);
}

std::string
CaseWork::cloudPath (const std::string& stem) const
{
  return "clouds/" + noisy_case.name () + "/" + stem + ".ply";
}

void
CaseWork::answer (Work work,
                  Row row,
                  const tools::Points& points,
                  const tools::Points& normals,
                  MeasureSet set,
                  const std::string& cloud) const
{
  try {
    row.measures = evaluator.measure (points, normals, set);
  }
  catch (const std::bad_alloc&) {
    return refuse (work, row, "failed", "there is not enough memory");
  }
  catch (const std::exception& error) {
    return refuse (work, row, "failed", error.what ());
  }
  row.status = "ok";
  row.reason.clear ();
  if (!cloud.empty ())
    keepCloud (cloud, points, normals, row);
  results.put (row);
  progressTo (work, row);
}

void
CaseWork::refuse (Work work, Row row, const std::string& status, const std::string& reason) const
{
  row.status = status;
  row.reason = reason;
  row.measures = {};
  results.put (row);
  progressTo (work, row);
}

void
CaseWork::keepCloud (const std::string& stem, const tools::Points& points, const tools::Points& normals, Row& row) const
{
  const std::string path = cloudPath (stem);
  row.cloud.clear ();
  try {
    savePoints (points, normals, options.folder + "/" + path);
    row.cloud = path;
  }
  catch (const tools::FileError& error) {
    tools::note (std::string (error.what ()) + "; going on without that cloud");
  }
}

void
CaseWork::progressTo (Work work, const Row& row) const
{
  progress.done (work, row.points,
                 noisy_case.name () + ": " + row.name + (row.parameters.empty () ? "" : " ") + row.parameters);
}

} // namespace pcl_normal_smoothing::evaluation
