// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_io.h"

#include "cloud_io.h"
#include "field_values.h"
#include "output_file.h"
#include "ply_format.h"
#include "tool_error.h"

// Of CGAL only the readers, which are LGPL.
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <cstring>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<std::size_t>;

constexpr const char* advice = "give a complete PLY, OFF, OBJ or STL mesh";

/** CGAL takes the memory for as many vertices and faces as a header claims: no more than the file has room for. */
void
checkCounts (const std::string& path, const std::string& bytes)
{
  const std::string extension = extensionOf (path);
  std::string_view text = bytes;
  if (extension == ".ply")
    readPlyHeader (text);
  else if (extension == ".off") {
    std::size_t numbers = 0;
    while (numbers < 2 && !text.empty ()) {
      std::string_view line = nextLine (text);
      for (std::string_view word = nextWord (line); !word.empty () && word[0] != '#'; word = nextWord (line)) {
        std::uint64_t count = 0;
        if (!parseCount (word, count))
          continue; // OFF, COFF, BINARY
        if (++numbers <= 2 && count > bytes.size () / 6) // "0 0 0" and the line end; faces are longer
          throw FormatError ("is truncated, it holds less than the " + std::to_string (count) +
                             " vertices or faces that its header claims");
      }
    }
  }
  else if (extension == ".stl" && bytes.size () >= 84 && bytes.compare (0, 5, "solid") != 0) {
    std::uint32_t count;
    std::memcpy (&count, bytes.data () + 80, sizeof count);
    if (count > (bytes.size () - 84) / 50)
      throw FormatError ("is truncated, it holds less than the " + std::to_string (count) +
                         " triangles that its header claims");
  }
}

/** \throw FormatError where a vertex is not finite or a face has a corner that does not exist */
Mesh
fromSoup (const std::vector<Point>& points, const std::vector<Polygon>& polygons)
{
  Mesh mesh;
  for (const Point& point : points) {
    mesh.vertices.emplace_back (point.x (), point.y (), point.z ());
    if (!mesh.vertices.back ().allFinite ())
      throw FormatError ("vertex " + std::to_string (mesh.vertices.size () - 1) + " is not finite");
  }
  for (const Polygon& polygon : polygons) {
    for (const std::size_t corner : polygon)
      if (corner >= points.size ())
        throw FormatError ("a face has corner " + std::to_string (corner) + ", but there are " +
                           std::to_string (points.size ()) + " vertices");
    for (std::size_t c = 2; c < polygon.size (); ++c)
      mesh.triangles.push_back ({static_cast<std::uint32_t> (polygon[0]), static_cast<std::uint32_t> (polygon[c - 1]),
                                 static_cast<std::uint32_t> (polygon[c])});
  }
  if (mesh.triangles.empty ())
    throw FormatError ("has no faces");
  return mesh;
}
} // namespace

Mesh
loadMesh (const std::string& path)
{
  const std::string extension = extensionOf (path);
  if (extension != ".ply" && extension != ".off" && extension != ".obj" && extension != ".stl")
    throw FileError (path, "is no mesh by its extension", advice);
  try {
    checkCounts (path, readFile (path));
    std::vector<Point> points;
    std::vector<Polygon> polygons;
    if (!CGAL::IO::read_polygon_soup (path, points, polygons, CGAL::parameters::verbose (false)))
      throw FormatError ("is no mesh, or is damaged");
    return fromSoup (points, polygons);
  }
  catch (const FormatError& error) {
    throw FileError (path, error.what (), advice);
  }
}

void
saveMesh (const Mesh& mesh, const std::string& path)
{
  OutputFile output (path);
  output.write ("ply\nformat ascii 1.0\nelement vertex " + std::to_string (mesh.vertices.size ()) +
                "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                std::to_string (mesh.triangles.size ()) + "\nproperty list uchar int vertex_indices\nend_header\n");
  std::string line;
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    line.clear ();
    for (int d = 0; d < 3; ++d) {
      line += d > 0 ? " " : "";
      appendFloat (static_cast<float> (vertex[d]), line);
    }
    output.write (line + "\n");
  }
  for (const auto& [a, b, c] : mesh.triangles)
    output.write ("3 " + std::to_string (a) + " " + std::to_string (b) + " " + std::to_string (c) + "\n");
  output.commit ();
}
} // namespace tools
} // namespace pcl_normal_smoothing
