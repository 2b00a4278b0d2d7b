// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_meshes.h"
#include "files/tool_error.h"
#include "meshes/mesh_edges.h"
#include "meshes/mesh_measures.h"
#include "models/mesh_model.h"
#include "models/subdivision.h"
#include "tool_runner.h"

#include <pcl_normal_smoothing/core/error.h>

#include <algorithm>

using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::evaluation;

namespace
{
class MeshModels : public ToolTest
{
protected:
  Model
  load (const tools::Mesh& mesh, int subdivisions = 0)
  {
    writeText (path ("a mesh.off"), asOff (mesh));
    return loadModel (path ("a mesh.off"), subdivisions);
  }
};
} // namespace

TEST_F (MeshModels, AsTheyAre)
{
  const tools::Mesh square = squareMesh (10);
  const Model model = load (square);
  EXPECT_EQ (model.name, "a mesh");
  EXPECT_EQ (model.source, path ("a mesh.off"));
  EXPECT_EQ (model.mesh.vertices, square.vertices);
  EXPECT_EQ (model.mesh.triangles, square.triangles);
  EXPECT_FALSE (model.surface_distance);
}

TEST_F (MeshModels, WithHolesAndBoundaries)
{
  tools::Mesh square = squareMesh (10);
  square.triangles.erase (square.triangles.begin () + 60, square.triangles.begin () + 62);
  EXPECT_EQ (load (square).mesh.vertices.size (), 100u);
}

TEST_F (MeshModels, LoseWhatIsNoSurface)
{
  tools::Mesh square = squareMesh (10);
  const auto expected = square;
  square.vertices.insert (square.vertices.begin () + 3, Eigen::Vector3d (7, 7, 7)); // shifts all later indices by one
  for (auto& t : square.triangles)
    for (std::uint32_t& corner : t)
      corner += corner >= 3 ? 1 : 0;
  square.triangles.push_back ({5, 5, 6});
  square.triangles.push_back ({5, 6, 7}); // three collinear vertices
  const Model model = load (square);
  EXPECT_EQ (model.mesh.vertices, expected.vertices);
  EXPECT_EQ (model.mesh.triangles, expected.triangles);
  EXPECT_NE (model.source.find (", 2 triangles without an area left out, 1 vertices without a triangle left out"),
             std::string::npos)
      << model.source;
}

TEST_F (MeshModels, FarAwayAreMovedToZero)
{
  tools::Mesh square = squareMesh (10);
  for (Eigen::Vector3d& vertex : square.vertices)
    vertex += Eigen::Vector3d (5e6, -4e6, 300);
  const Model model = load (square);
  EXPECT_NE (model.source.find (", moved to zero"), std::string::npos);
  EXPECT_LT ((model.mesh.vertices[0] - Eigen::Vector3d (-0.5, -0.5, 0)).norm (), 1e-8);
}

TEST_F (MeshModels, SplitAtTheMiddlesOfTheEdges)
{
  tools::Mesh square = squareMesh (10);
  const Model model = load (square, 2);
  ASSERT_EQ (model.mesh.vertices.size (), 37u * 37);
  EXPECT_EQ (model.mesh.triangles.size (), 16 * square.triangles.size ());
  EXPECT_NEAR (tools::area (model.mesh), 1, 1e-12);
  EXPECT_TRUE (std::equal (square.vertices.begin (), square.vertices.end (), model.mesh.vertices.begin ()));
  for (const Eigen::Vector3d& normal : tools::vertexNormals (model.mesh))
    EXPECT_GT (normal.z (), 0.999);
}

TEST_F (MeshModels, ThatCannotBeStudied)
{
  writeText (path ("a.off"), "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_THROW (loadModel (path ("a.off"), 0), tools::FileError);
  EXPECT_THROW (loadModel (path ("none.off"), 0), tools::FileError);
  tools::Mesh flat = squareMesh (10);
  for (Eigen::Vector3d& vertex : flat.vertices)
    vertex.y () = 0;
  EXPECT_THROW (load (flat), core::Error); // no triangle remains
  EXPECT_THROW (load (squareMesh (4)), core::Error);
  EXPECT_EQ (load (squareMesh (4), 1).mesh.vertices.size (), 49u);
}
