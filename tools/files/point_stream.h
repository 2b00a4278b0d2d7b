// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "byte_stream.h"
#include "cloud_shape.h"
#include "output_file.h"

#include <memory>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Reads points, some at a time, from a file of any size. */
class PointReader
{
public:
  virtual ~PointReader () = default;

  /** A PLY file states viewpoint, width and height after its points: they are only known after finish (). */
  const CloudShape&
  shape () const
  {
    return shape_;
  }

  /** Reads the next points, laid out as in a pcl::PCLPointCloud2.
    * \param[in] most limit on their number
    * \param[out] data shape ().point_step bytes per point
    * \return their number; 0 after the last \throw FormatError */
  virtual std::size_t
  read (std::size_t most, std::vector<std::uint8_t>& data) = 0;

  /** Reads what follows the points, once all of them have been read. \throw FormatError */
  virtual void
  finish ()
  {}

protected:
  /** How many points read () is to return. */
  std::size_t
  nextCount (std::size_t most) const
  {
    return static_cast<std::size_t> (std::min<std::uint64_t> (most, shape_.size () - done_));
  }

  CloudShape shape_;
  std::uint64_t done_ = 0;
};

class CoordinateFields;

/** Reads the points of a PCD or PLY file, told apart by the extension. CoordinateFields converts their coordinates. The
  * functions throw FileError. */
class PointFile
{
public:
  /** \throw FileError if the file cannot be read, is not a cloud, or is a compressed PCD file, which is stored field by
    * field */
  explicit PointFile (const std::string& path);

  ~PointFile ();

  /** As PointReader::shape (). */
  const CloudShape&
  shape () const
  {
    return shape_;
  }

  std::size_t
  read (std::size_t most, std::vector<std::uint8_t>& data);

  /** Reads the rest. \return the checksum of the file */
  std::string
  finish ();

private:
  std::string path_;
  ByteStream bytes_;
  std::unique_ptr<PointReader> reader_;
  std::unique_ptr<CoordinateFields> coordinates_;
  CloudShape shape_;
};

/** Writes a PCD or PLY file, told apart by the extension, some points at a time: the same bytes as saveCloud. */
class PointWriter
{
public:
  /** \param[in] format ASCII or BINARY \throw FileError */
  PointWriter (const CloudShape& shape, const std::string& path, FileFormat format);

  /** \param[in] data shape.point_step bytes per point \throw FileError if the disk is full */
  void
  write (const std::uint8_t* data, std::size_t points);

  /** Puts the file in its place. */
  void
  commit ();

private:
  CloudShape shape_;
  FileFormat format_;
  bool ply_;
  OutputFile output_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
