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
/** Reads one point after the other, whatever the size of the file. */
class PointReader
{
public:
  virtual ~PointReader () = default;

  /** What a PLY file says behind its points, the viewpoint and with it width and height, is there from finish () on. */
  const CloudShape&
  shape () const
  {
    return shape_;
  }

  /** The next points, as they lie in a pcl::PCLPointCloud2.
    * \param[in] most how many at most
    * \param[out] data shape ().point_step bytes a point
    * \return how many; 0 behind the last \throw FormatError */
  virtual std::size_t
  read (std::size_t most, std::vector<std::uint8_t>& data) = 0;

  /** Reads what follows the points, once all of them are read. \throw FormatError */
  virtual void
  finish ()
  {}

protected:
  /** How many points read () is to give. */
  std::size_t
  nextCount (std::size_t most) const
  {
    return static_cast<std::size_t> (std::min<std::uint64_t> (most, shape_.size () - done_));
  }

  CloudShape shape_;
  std::uint64_t done_ = 0;
};

class CoordinateFields;

/** Reads the points of a PCD or PLY file, told apart by the extension, their coordinates as CoordinateFields says. Its
  * functions throw FileError. */
class PointFile
{
public:
  /** \throw FileError where the file cannot be read, is no cloud, or is a compressed PCD file, which holds one field
    * after the other */
  explicit PointFile (const std::string& path);

  ~PointFile ();

  /** As of PointReader. */
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

/** Writes a PCD or PLY file, told apart by the extension, point by point: the bytes that saveCloud would write. */
class PointWriter
{
public:
  /** \param[in] format ASCII or BINARY \throw FileError */
  PointWriter (const CloudShape& shape, const std::string& path, FileFormat format);

  /** \param[in] data shape.point_step bytes a point \throw FileError where the disk is full */
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
