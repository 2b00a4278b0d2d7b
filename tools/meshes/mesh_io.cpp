// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_io.h"

#include "files/cloud_io.h"
#include "files/field_values.h"
#include "files/output_file.h"
#include "files/ply_format.h"
#include "files/tool_error.h"

// Only CGAL's readers are used, which are LGPL.
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Polygon = std::vector<std::size_t>;

constexpr const char* advice = "give a complete PLY, OFF, OBJ or STL mesh";

/** Limits the memory of the process while this exists: CGAL allocates as much as the numbers in a damaged file demand,
  * and should get std::bad_alloc before the machine runs out of memory. */
class MemoryBound
{
public:
  explicit MemoryBound (std::size_t more)
  {
    getrlimit (RLIMIT_AS, &before_);
    std::size_t pages = 0;
    if (!(std::ifstream ("/proc/self/statm") >> pages))
      return;
    rlimit bound = before_;
    bound.rlim_cur =
        std::min<rlim_t> (bound.rlim_cur, pages * static_cast<std::size_t> (sysconf (_SC_PAGESIZE)) + more);
    setrlimit (RLIMIT_AS, &bound);
  }

  ~MemoryBound ()
  {
    setrlimit (RLIMIT_AS, &before_);
  }

  MemoryBound (const MemoryBound&) = delete;
  MemoryBound&
  operator= (const MemoryBound&) = delete;

private:
  rlimit before_;
};

/** Removes the letters from the header of an OFF file that announce texture coordinates, colours and normals. CGAL 5.5
  * looks for these beyond the end of a line that lacks them; without the letters, it skips what follows the
  * coordinates. A binary file is left alone, since nothing else there separates the numbers. */
std::string
withoutAttributes (std::string off)
{
  constexpr const char* spaces = " \t\r\n\v\f";
  std::size_t begin = off.find_first_not_of (spaces);
  while (begin < off.size () && off[begin] == '#')
    begin = off.find_first_not_of (spaces, off.find ('\n', begin));
  const std::size_t after = off.find_first_not_of (spaces, off.find_first_of (spaces, begin));
  if (after == std::string::npos || off.compare (after, 6, "BINARY") == 0)
    return off;
  std::size_t end = begin;
  for (const std::string promise : {"ST", "C", "N"}) // in this order
    end += off.compare (end, promise.size (), promise) == 0 ? promise.size () : 0;
  const bool promises_again =
      off.find_first_of ("CN", end) == end || off.compare (end, 2, "ST") == 0; // CGAL refuses it
  return promises_again ? off : off.erase (begin, end - begin);
}

/** \return false if the file is not a mesh */
bool
readSoup (const std::string& path, const std::string& bytes, std::vector<Point>& points, std::vector<Polygon>& polygons)
{
  // A face of a text file takes the most: about 8 bytes become a vector, which is moved when the list grows.
  const MemoryBound bound ((std::size_t (256) << 20) + 64 * bytes.size ());
  try {
    if (extensionOf (path) == ".off") {
      std::istringstream off (withoutAttributes (bytes));
      return CGAL::IO::read_OFF (off, points, polygons);
    }
    return CGAL::IO::read_polygon_soup (path, points, polygons, CGAL::parameters::verbose (false));
  }
  catch (const std::exception&) { // std::bad_alloc, std::length_error, and what CGAL throws
    return false;
  }
}

/** \throw FormatError if a vertex is not finite, a face has a corner that does not exist, or there are no faces */
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
    const std::string bytes = readFile (path);
    ByteStream stream {std::string_view (bytes)};
    if (extension == ".ply") // CGAL loops over as many elements as the header claims, present or not
      readPlyHeader (stream);
    std::vector<Point> points;
    std::vector<Polygon> polygons;
    if (!readSoup (path, bytes, points, polygons))
      throw FormatError ("is no mesh, or is truncated or damaged");
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
