// SPDX-License-Identifier: BSD-3-Clause
#include "clouds/cloud_graph.h"
#include "command_line/common_options.h"
#include "command_line/tool.h"
#include "files/field_values.h"
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
    const auto points = tools::noisyVertices (mesh, type_, sigma_ * tools::meanEdgeLength (mesh), seed_);
    tools::CloudFile file;
    file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
    file.cloud->width = static_cast<pcl::uindex_t> (points.size ());
    file.cloud->height = 1;
    tools::addFloatFields (*file.cloud, {"x", "y", "z"});
    const VectorLayout layout = *VectorLayout::find (*file.cloud, {"x", "y", "z"});
    for (std::size_t i = 0; i < points.size (); ++i)
      layout.set (file.cloud->data.data (), i, points[i]);
    tools::saveResult (file, options.file (1), format_.format);
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
