// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <Eigen/Geometry>

#include <string>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A cloud with everything that its file says about it. */
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
  * PCL's readers are not used: those of 1.13 lose the viewpoint of a PLY file, take the size in a camera element for
  * that of the cloud, read a truncated line as a point at the origin, and crash if a header promises more than the
  * file holds.
  * \throw FileError if the file cannot be read or is not a cloud */
CloudFile
loadCloud (const std::string& path);

/** Writes a PCD or PLY file, told apart by the extension; an existing file is replaced once the new one is complete.
  *
  * PCL's writers are not used: those of 1.13 ignore a full disk, round the viewpoint, and write unreadable PLY files
  * if normals are double or colours are not of one particular type.
  * \throw FileError if it cannot be written */
void
saveCloud (const CloudFile& file, const std::string& path, FileFormat format);

/** Checks, before the work is done, whether saveCloud can succeed.
  * \throw UsageError if the extension is unknown or does not support the format
  * \throw FileError if the file cannot be written there */
void
checkOutput (const std::string& path, FileFormat format);

/** The extension of a file name in lower case, with its dot. */
std::string
extensionOf (const std::string& path);

/** ".pcd" or ".ply". \throw FileError for any other extension */
std::string
cloudExtensionOf (const std::string& path);

/** All bytes of a file or a pipe. \throw FileError */
std::string
readFile (const std::string& path);
} // namespace tools
} // namespace pcl_normal_smoothing
