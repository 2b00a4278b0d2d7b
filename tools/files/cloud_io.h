// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A cloud with all that its file says of it. */
struct CloudFile
{
  std::string path;
  pcl::PCLPointCloud2::Ptr cloud;
  Eigen::Vector4f origin = Eigen::Vector4f::Zero ();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity ();
  /** Faces of a PLY mesh, which a cloud does not keep. */
  std::size_t faces = 0;

  std::size_t
  size () const
  {
    return std::size_t (cloud->width) * cloud->height;
  }
};

enum class FileFormat
{
  ASCII,
  BINARY,
  COMPRESSED
};

/** Reads a PCD or PLY file, told apart by the extension.
  *
  * Not with PCL's readers: those of 1.13 lose the viewpoint of a PLY file, take a size that a camera element states for
  * that of the cloud, read a truncated line as a point at the origin, and crash where a header promises more than the
  * file holds.
  * \throw FileError where the file cannot be read or is no cloud */
CloudFile
loadCloud (const std::string& path);

/** Writes a PCD or PLY file, told apart by the extension; whatever was there stays until the file is complete.
  *
  * Not with PCL's writers: those of 1.13 take no notice of a full disk, round the viewpoint, and write PLY files that
  * nobody can read where normals are double or colours are not of one certain type.
  * \throw FileError where it cannot be written */
void
saveCloud (const CloudFile& file, const std::string& path, FileFormat format);

/** Finds out before the work whether saveCloud has a chance.
  * \throw UsageError where the extension is unknown or does not go with the format
  * \throw FileError where the place cannot be written to */
void
checkOutput (const std::string& path, FileFormat format);

/** Extension of a file's name in lower case, with its dot. */
std::string
extensionOf (const std::string& path);

/** ".pcd" or ".ply". \throw FileError for a path that ends in anything else */
std::string
cloudExtensionOf (const std::string& path);

/** The bytes of a file, or of what comes out of a pipe. \throw FileError */
std::string
readFile (const std::string& path);
} // namespace tools
} // namespace pcl_normal_smoothing
