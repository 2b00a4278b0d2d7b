// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/tool.h"
#include "files/cloud_io.h"
#include "files/output_file.h"
#include "files/tool_error.h"
#include "meshes/double_torus.h"

#include <cstdio>

using namespace pcl_normal_smoothing;

namespace
{
class MakeDoubleTorusTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe ("Writes a triangle mesh of a double torus, to try the other tools on.", {"output.ply"});
    options.add ("-vertices", "N", "number of vertices", std::to_string (vertices_),
                 tools::integerOption (1000, 100000,
                                       [this] (auto number) { vertices_ = static_cast<std::size_t> (number); }));
    options.add ("-shape", "eight|tori", "a figure of eight with a thin, flat tube, or two round tori that are joined",
                 "eight", tools::choiceOption<bool> ({{"eight", false}, {"tori", true}}, [this] (bool round) {
                   is_round_ = round;
                 }));
  }

  void
  work (const tools::Options& options) override
  {
    if (tools::extensionOf (options.file (0)) != ".ply")
      throw tools::UsageError (options.file (0) + ": the mesh is written as PLY: end the name in .ply");
    tools::checkWritable (options.file (0));
    const tools::Mesh mesh =
        tools::makeDoubleTorus (is_round_ ? tools::joinedTori () : tools::figureOfEight (), vertices_);
    tools::saveMesh (mesh, options.file (0));
    std::printf ("%s: %zu vertices, %zu triangles\n", options.file (0).c_str (), mesh.vertices.size (),
                 mesh.triangles.size ());
  }

  bool is_round_ = false;
  std::size_t vertices_ = 4350; // as in the paper
};
} // namespace

int
main (int argc, char** argv)
{
  MakeDoubleTorusTool tool;
  return tools::runTool (argc, argv, tool);
}
