// SPDX-License-Identifier: BSD-3-Clause
#include "sources.h"

#include "files/tool_error.h"

#include <nlohmann/json.hpp>
#include <pcl/common/io.h>

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>

namespace fs = std::filesystem;

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
std::string
nameOf (const pcl::PCLPointField& field)
{
  return field.name + " (" + std::to_string (pcl::getFieldSize (field.datatype)) + " bytes, type " +
         std::to_string (field.datatype) + ", " + std::to_string (field.count) + ")";
}

bool
equal (const pcl::PCLPointField& a, const pcl::PCLPointField& b)
{
  return a.name == b.name && a.datatype == b.datatype && a.count == b.count && a.offset == b.offset;
}

/** Lists the fields that one cloud has and the other lacks. */
std::string
fieldsMissing (const CloudShape& from, const CloudShape& other)
{
  std::string names;
  for (const auto& field : from.fields)
    if (std::none_of (other.fields.begin (), other.fields.end (), [&] (const auto& o) { return equal (field, o); }))
      names += (names.empty () ? "" : ", ") + nameOf (field);
  return names.empty () ? "nothing, or in another order" : names;
}

void
requireSameFields (const Source& first, const Source& other)
{
  const CloudShape &a = first.shape, &b = other.shape;
  if (a.point_step == b.point_step && a.fields.size () == b.fields.size () &&
      std::equal (a.fields.begin (), a.fields.end (), b.fields.begin (), equal))
    return;
  throw FileError (other.path,
                   "has other fields than " + first.path + ": here " + fieldsMissing (b, a) + ", there " +
                       fieldsMissing (a, b),
                   "give files of the same fields, in the same order");
}

bool
isUtf8 (const std::string& text)
{
  try {
    nlohmann::json (text).dump ();
    return true;
  }
  catch (const nlohmann::json::type_error&) {
    return false;
  }
}

/** A plan names its files and their fields in JSON, which is UTF-8, and must find them by these names again. */
void
requireUtf8 (const Source& source)
{
  if (!isUtf8 (source.path))
    throw FileError (source.path, "its path is not in UTF-8, as a plan's must be", "rename it, or make a link to it");
  for (const auto& field : source.shape.fields)
    if (!isUtf8 (field.name))
      throw FileError (source.path, "the name of a field is not in UTF-8, as a plan's must be", "rename the field");
}
} // namespace

Sources::Sources (const std::vector<std::string>& paths)
{
  std::uint64_t first = 0;
  for (const std::string& path : paths) {
    const CloudShape shape = PointFile (path).shape ();
    std::error_code error;
    for (const Source& other : list_)
      if (fs::equivalent (other.path, path, error))
        throw FileError (path, "is given twice, as " + other.path + " too", "give every file once");
    const auto [bytes, changed] = stateOf (path);
    list_.push_back ({fs::absolute (path).lexically_normal ().string (), shape, first, bytes, changed, {}});
    requireUtf8 (list_.back ());
    requireSameFields (list_.front (), list_.back ());
    first += shape.size ();
  }
}

void
Sources::read (const Use& use)
{
  std::vector<std::uint8_t> points;
  for (Source& source : list_) {
    PointFile file (source.path);
    std::uint64_t done = 0;
    while (const std::size_t count = file.read (pointsAtOnce (source.shape), points)) {
      use (source.first + done, points.data (), count);
      done += count;
    }
    const std::string checksum = file.finish ();
    if (done != source.shape.size () || (!source.checksum.empty () && source.checksum != checksum))
      throw FileError (source.path, "has changed while it was read", "run plan again");
    source.shape = file.shape ();
    source.checksum = checksum;
  }
}

std::uint64_t
Sources::faces () const
{
  std::uint64_t faces = 0;
  for (const Source& source : list_)
    faces += source.shape.faces;
  return faces;
}

std::size_t
pointsAtOnce (const CloudShape& shape)
{
  constexpr std::size_t bytes = 4u << 20;
  return std::clamp<std::size_t> (bytes / std::max<std::size_t> (shape.point_step, 1), 1, 1u << 16);
}

std::pair<std::uint64_t, std::int64_t>
stateOf (const std::string& path)
{
  struct stat status;
  if (stat (path.c_str (), &status) != 0)
    throw FileError (path, "cannot be read (" + std::string (std::strerror (errno)) + ")", "put it back in its place");
  return {static_cast<std::uint64_t> (status.st_size),
          std::int64_t (status.st_mtim.tv_sec) * 1000000000 + status.st_mtim.tv_nsec};
}
} // namespace tools
} // namespace pcl_normal_smoothing
