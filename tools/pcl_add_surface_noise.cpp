// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_graph.h"
#include "clouds/cloud_of_points.h"
#include "command_line/common_options.h"
#include "command_line/tool.h"
#include "meshes/mesh_measures.h"
#include "meshes/surface_noise.h"

using namespace pcl_normal_smoothing;

namespace
{
class AddSurfaceNoiseTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe ("Makes a noisy cloud of the vertices of a mesh, in their order.",
                      {"mesh.ply|off|obj|stl", "output.pcd|ply"});
    const tools::Words<tools::NoiseType> types = tools::namedNoiseTypes ();
    options.add ("-type", tools::wordList (types), "GN: along the normals, GR: along random directions", "GN",
                 tools::choiceOption<tools::NoiseType> (types, [this] (auto type) { type_ = type; }));
    options.add ("-sigma", "S", "standard deviation of the noise, in mean edge lengths of the mesh", "0.2",
                 tools::numberOption (0, 1e30, [this] (double sigma) { sigma_ = sigma; }));
    tools::addSeedOption (options, "1", [this] (std::uint64_t seed) { seed_ = seed; });
    format_.addTo (options);
  }

  void
  work (const tools::Options& options) override
  {
    tools::checkOutput (options.file (1), format_.format);
    const tools::Mesh mesh = tools::loadMesh (options.file (0));
    const double edge = tools::meanEdgeLength (mesh);
    // Coordinates of maps are large: their steps in float must not add noise of their own.
    const auto cloud = tools::cloudOfPoints (tools::noisyVertices (mesh, type_, sigma_ * edge, seed_), edge / 64);
    tools::saveResult (cloud, options.file (1), format_.format);
  }

  tools::NoiseType type_ = tools::NoiseType::GN;
  double sigma_ = 0.2;
  std::uint64_t seed_ = 1;
  tools::FormatOption format_;
};
} // namespace

int
main (int argc, char** argv)
{
  AddSurfaceNoiseTool tool;
  return tools::runTool (argc, argv, tool);
}
