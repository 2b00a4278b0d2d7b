// SPDX-License-Identifier: BSD-3-Clause
#include "point_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Point = Eigen::Vector3d;
static_assert (sizeof (Point) == 3 * sizeof (double));

[[noreturn]] void
fail (const std::string& path, const std::string& what)
{
  throw std::runtime_error (std::filesystem::path (path).filename ().string () + " " + what);
}
} // namespace

void
writeBytes (const std::string& path, std::string_view bytes)
{
  errno = 0;
  std::ofstream file (path, std::ios::binary);
  file.write (bytes.data (), static_cast<std::streamsize> (bytes.size ()));
  file.close ();
  if (!file)
    fail (path, std::string ("cannot be written: ") + std::strerror (errno));
}

void
writePoints (const std::string& path, const std::vector<Point>& points)
{
  writeBytes (path, {reinterpret_cast<const char*> (points.data ()), points.size () * sizeof (Point)});
}

std::vector<Point>
readPoints (const std::string& path)
{
  std::error_code error;
  const auto bytes = std::filesystem::file_size (path, error);
  if (error)
    fail (path, "cannot be read: " + error.message ());
  if (bytes % sizeof (Point) != 0)
    fail (path, "has " + std::to_string (bytes) + " bytes, which are no whole points");
  std::vector<Point> points (bytes / sizeof (Point));
  std::ifstream file (path, std::ios::binary);
  file.read (reinterpret_cast<char*> (points.data ()), static_cast<std::streamsize> (bytes));
  if (!file)
    fail (path, "cannot be read");
  return points;
}

} // namespace pcl_normal_smoothing::evaluation
