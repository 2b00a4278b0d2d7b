// SPDX-License-Identifier: BSD-3-Clause
#include "point_stream.h"

#include "coordinate_fields.h"
#include "pcd_format.h"
#include "ply_format.h"
#include "tool_error.h"

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Limit on the points that a file may claim: the count of their bytes does not overflow. */
constexpr std::uint64_t most_points = std::uint64_t (1) << 38;

template <typename Work>
auto
withPath (const std::string& path, const Work& work)
{
  try {
    return work ();
  }
  catch (const FormatError& error) {
    throw FileError (path, error.what (), "give a whole and valid PCD or PLY file");
  }
}
} // namespace

PointFile::PointFile (const std::string& path) : path_ (path), bytes_ (std::filesystem::path (path))
{
  const std::string extension = cloudExtensionOf (path);
  reader_ = withPath (path, [&] {
    return extension == ".pcd" ? makePcdReader (bytes_, most_points) : makePlyReader (bytes_, most_points);
  });
  if (!reader_)
    throw FileError (path, "is a compressed PCD file, which holds one field after the other",
                     "convert it, for example by pcl_convert_pcd_ascii_binary in.pcd out.pcd 1");
  coordinates_ = withPath (path, [&] { return std::make_unique<CoordinateFields> (reader_->shape ()); });
  shape_ = coordinates_->shapeFrom (reader_->shape ());
}

PointFile::~PointFile () = default;

std::size_t
PointFile::read (std::size_t most, std::vector<std::uint8_t>& data)
{
  return withPath (path_, [&] {
    const std::size_t count = reader_->read (most, data);
    coordinates_->convert (data);
    return count;
  });
}

std::string
PointFile::finish ()
{
  withPath (path_, [&] { reader_->finish (); });
  shape_ = coordinates_->shapeFrom (reader_->shape ());
  while (bytes_.left () > 0)
    bytes_.skip (bytes_.peek ().size ());
  return bytes_.checksum ();
}

PointWriter::PointWriter (const CloudShape& shape, const std::string& path, FileFormat format)
: shape_ (shape), format_ (format), ply_ (extensionOf (path) == ".ply"), output_ (path)
{
  withPath (path, [&] { output_.write (ply_ ? plyHeader (shape_, format_) : pcdHeader (shape_, format_)); });
}

void
PointWriter::write (const std::uint8_t* data, std::size_t points)
{
  if (ply_)
    writePlyPoints (shape_, format_, data, points, output_);
  else
    writePcdPoints (shape_, format_, data, points, output_);
}

void
PointWriter::commit ()
{
  if (ply_)
    writePlyEnd (shape_, format_, output_);
  output_.commit ();
}
} // namespace tools
} // namespace pcl_normal_smoothing
