// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_points.h"
#include "command_line/report.h"
#include "command_line/tool.h"
#include "meshes/mesh_measures.h"
#include "meshes/smoothing_error.h"

using namespace pcl_normal_smoothing;

namespace
{
class SmoothingErrorTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe (
        "Compares a smoothed cloud with the clean mesh: point i of the cloud is vertex i of the mesh, or (-samples) "
        "any points of the surface.",
        {"clean_mesh.ply|off|obj|stl", "smoothed.pcd|ply"});
    options.add ("-noisy", "noisy.pcd|ply", "the cloud before smoothing, for p2s_ratio: 1 = nothing gained", "none",
                 [this] (const std::string& path) { noisy_ = path; });
    options.add ("-samples", "0|1", "1: the points are any points of the surface, as many as there are: distances only",
                 "0", tools::switchOption ([this] (bool samples) { samples_ = samples; }));
    options.add ("-json", "0|1", "1: one line of JSON", "0",
                 tools::switchOption ([this] (bool json) { json_ = json; }));
  }

  void
  work (const tools::Options& options) override
  {
    const tools::Mesh mesh = tools::loadMesh (options.file (0));
    const tools::CloudFile file = tools::loadCloud (options.file (1));
    const tools::Points points = pointsOf (file, mesh);
    tools::Report report;
    report.add ("n", static_cast<double> (points.size ()), "points");
    report.add ("mean_edge", tools::meanEdgeLength (mesh), "mean edge length of the clean mesh");
    if (!samples_)
      addVertexErrors (points, mesh, report);
    const tools::SurfaceDistance distance = tools::distanceToMesh (points, mesh);
    report.add ("p2s_mean", distance.mean, "distance to the mesh, mean");
    report.add ("p2s_rms", distance.rms, "distance to the mesh, root mean square");
    report.add ("p2s_max", distance.max, "distance to the mesh, largest");
    if (!noisy_.empty ()) {
      const tools::Points noisy = pointsOf (tools::loadCloud (noisy_), mesh);
      report.add ("p2s_ratio", distance.mean / tools::distanceToMesh (noisy, mesh).mean,
                  "p2s_mean over that of the noisy cloud");
    }
    if (const auto normals = samples_ ? std::nullopt : tools::normalsOf (file))
      report.add ("angle_mean_deg", tools::meanAngle (*normals, mesh),
                  "angle to the mesh's vertex normals, mean, degrees");
    report.print (json_);
  }

  tools::Points
  pointsOf (const tools::CloudFile& file, const tools::Mesh& mesh) const
  {
    return samples_ ? tools::finitePointsOf (file) : tools::verticesOf (file, mesh);
  }

  static void
  addVertexErrors (const tools::Points& points, const tools::Mesh& mesh, tools::Report& report)
  {
    report.add ("E_A", tools::areaError (points, mesh), "relative error of the area");
    for (const unsigned k : {7u, 15u, 21u})
      report.add ("E_k" + std::to_string (k), tools::variationError (points, mesh.vertices, k),
                  "mean error of the surface variation, k = " + std::to_string (k));
  }

  std::string noisy_;
  bool samples_ = false;
  bool json_ = false;
};
} // namespace

int
main (int argc, char** argv)
{
  SmoothingErrorTool tool;
  return tools::runTool (argc, argv, tool);
}
