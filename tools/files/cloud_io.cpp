// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_io.h"

#include "coordinate_fields.h"
#include "output_file.h"
#include "pcd_format.h"
#include "ply_format.h"
#include "tool_error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Closes a file when destroyed. */
struct Descriptor
{
  int number;

  ~Descriptor ()
  {
    if (number >= 0)
      close (number);
  }
};

[[noreturn]] void
failToRead (const std::string& path)
{
  throw FileError (path, "cannot be read (" + std::string (std::strerror (errno)) + ")",
                   "name a file that exists and that you may read");
}
} // namespace

std::string
extensionOf (const std::string& path)
{
  std::string extension = std::filesystem::path (path).extension ().string ();
  std::transform (extension.begin (), extension.end (), extension.begin (),
                  [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });
  return extension;
}

std::string
readFile (const std::string& path)
{
  const Descriptor file {open (path.c_str (), O_RDONLY | O_CLOEXEC)};
  struct stat status;
  if (file.number < 0 || fstat (file.number, &status) != 0)
    failToRead (path);
  if (S_ISDIR (status.st_mode))
    throw FileError (path, "is a folder", "name a file in it");
  constexpr std::size_t step = 1u << 20;
  std::string bytes;
  std::size_t size = 0;
  const std::size_t expected = S_ISREG (status.st_mode) ? static_cast<std::size_t> (status.st_size) : 0;
  try {
    while (true) {
      if (size == bytes.size ())
        bytes.resize (std::max (size + size / 2 + step, size == 0 ? expected + 1 : 0));
      const ssize_t count = read (file.number, bytes.data () + size, bytes.size () - size);
      if (count < 0 && errno != EINTR)
        failToRead (path);
      if (count == 0)
        break;
      size += count > 0 ? static_cast<std::size_t> (count) : 0;
    }
  }
  catch (const std::bad_alloc&) {
    throw FileError (path, "is larger than the memory", "give it in parts, or use a machine with more memory");
  }
  bytes.resize (size);
  return bytes;
}

std::string
cloudExtensionOf (const std::string& path)
{
  const std::string extension = extensionOf (path);
  if (extension == ".pcd" || extension == ".ply")
    return extension;
  if (path == "-" || path == "/dev/stdin")
    throw FileError (path, "is the standard input", "use a named pipe whose name ends in .pcd or .ply");
  if (extension == ".off" || extension == ".obj" || extension == ".stl")
    throw FileError (path, "is a mesh", "save its vertices as PLY; pcl_add_surface_noise makes a noisy cloud of it");
  throw FileError (path, "is neither a PCD nor a PLY file by its extension",
                   "convert it to one of them: CloudCompare and PDAL read most others");
}

CloudFile
loadCloud (const std::string& path)
{
  const std::string extension = cloudExtensionOf (path);
  const std::string bytes = readFile (path);
  CloudFile file;
  file.path = path;
  file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
  try {
    if (extension == ".pcd")
      readPcd (bytes, file);
    else
      readPly (bytes, file);
    const CloudShape stored = shapeOf (file);
    const CoordinateFields coordinates (stored);
    coordinates.convert (file.cloud->data);
    setShape (coordinates.shapeFrom (stored), file);
  }
  catch (const FormatError& error) {
    const std::string kind = extension == ".pcd" ? "PCD" : "PLY";
    throw FileError (path, error.what (), "give a whole and valid " + kind + " file");
  }
  return file;
}

void
checkOutput (const std::string& path, FileFormat format)
{
  const std::string extension = extensionOf (path);
  if (extension != ".pcd" && extension != ".ply")
    throw UsageError (path + ": the extension names no format to write: end the name in .pcd or .ply");
  if (extension == ".ply" && format == FileFormat::COMPRESSED)
    throw UsageError (path + ": PLY knows no -format compressed: take binary, or end the name in .pcd");
  checkWritable (path);
}

void
saveCloud (const CloudFile& file, const std::string& path, FileFormat format)
{
  checkOutput (path, format);
  OutputFile output (path);
  try {
    if (extensionOf (path) == ".pcd")
      writePcd (file, format, output);
    else
      writePly (file, format, output);
  }
  catch (const FormatError& error) {
    throw FileError (path, error.what (), "choose another format or extension for the output");
  }
  output.commit ();
}
} // namespace tools
} // namespace pcl_normal_smoothing
