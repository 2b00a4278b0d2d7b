// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_points.h"
#include "report.h"
#include "smoothing_error.h"
#include "tool.h"

using namespace pcl_normal_smoothing;

namespace
{
class SmoothingErrorTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe ("Compares a smoothed cloud with the clean mesh: point i of the cloud is vertex i of the mesh.",
                      {"clean_mesh.ply|off|obj|stl", "smoothed.pcd|ply"});
    options.add ("-noisy", "noisy.pcd|ply", "the cloud before smoothing, for p2s_ratio: 1 = nothing gained", "none",
                 [this] (const std::string& path) { noisy_ = path; });
    options.add ("-json", "0|1", "1: one line of JSON", "0",
                 tools::switchOption ([this] (bool json) { json_ = json; }));
  }

  void
  work (const tools::Options& options) override
  {
    const tools::Mesh mesh = tools::loadMesh (options.file (0));
    const tools::CloudFile file = tools::loadCloud (options.file (1));
    const tools::Points points = tools::verticesOf (file, mesh);
    tools::Report report;
    report.add ("n", static_cast<double> (points.size ()), "points");
    report.add ("mean_edge", tools::meanEdgeLength (mesh), "mean edge length of the clean mesh");
    report.add ("E_A", tools::areaError (points, mesh), "relative error of the area");
    for (const unsigned k : {7u, 15u, 21u})
      report.add ("E_k" + std::to_string (k), tools::variationError (points, mesh.vertices, k),
                  "mean error of the surface variation, k = " + std::to_string (k));
    const tools::SurfaceDistance distance = tools::distanceToMesh (points, mesh);
    report.add ("p2s_mean", distance.mean, "distance to the mesh, mean");
    report.add ("p2s_rms", distance.rms, "distance to the mesh, root mean square");
    report.add ("p2s_max", distance.max, "distance to the mesh, largest");
    if (!noisy_.empty ()) {
      const tools::Points noisy = tools::verticesOf (tools::loadCloud (noisy_), mesh);
      report.add ("p2s_ratio", distance.mean / tools::distanceToMesh (noisy, mesh).mean,
                  "p2s_mean over that of the noisy cloud");
    }
    if (const auto normals = tools::normalsOf (file))
      report.add ("angle_mean_deg", tools::meanAngle (*normals, mesh),
                  "angle to the mesh's vertex normals, mean, degrees");
    report.print (json_);
  }

  std::string noisy_;
  bool json_ = false;
};
} // namespace

int
main (int argc, char** argv)
{
  SmoothingErrorTool tool;
  return tools::runTool (argc, argv, tool);
}
