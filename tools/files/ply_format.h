// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output_file.h"
#include "point_stream.h"
#include "tool_error.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** One property of an element of a PLY file. */
struct PlyProperty
{
  std::string name;
  std::uint8_t datatype = 0;  // of pcl::PCLPointField
  std::uint8_t list_type = 0; // of the length of a list; 0: this is not a list
};

struct PlyElement
{
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader
{
  enum class Encoding
  {
    ASCII,
    LITTLE_ENDIAN_BYTES,
    BIG_ENDIAN_BYTES
  };

  Encoding encoding = Encoding::ASCII;
  std::vector<PlyElement> elements;
};

/** Reads the header; the stream then continues with the data.
  * \throw FormatError if it is invalid, or claims more elements than the stream has room for */
PlyHeader
readPlyHeader (ByteStream& stream);

/** Reads the vertices of a PLY file under PCL's names (nx: normal_x; red, green, blue: rgb), and the viewpoint, width
  * and height from its camera element. \throw FormatError */
void
readPly (const std::string& bytes, CloudFile& file);

/** Reads the vertices of a PLY file.
  * \param[in] most limit on the vertices that its header may claim \throw FormatError */
std::unique_ptr<PointReader>
makePlyReader (ByteStream& stream, std::uint64_t most);

/** \throw FormatError if PLY cannot hold a field */
void
writePly (const CloudFile& file, FileFormat format, OutputFile& output);

/** The header; writePlyPoints and writePlyEnd write the rest. \throw FormatError if PLY cannot hold a field */
std::string
plyHeader (const CloudShape& shape, FileFormat format);

/** \param[in] data shape.point_step bytes per point */
void
writePlyPoints (const CloudShape& shape,
                FileFormat format,
                const std::uint8_t* data,
                std::size_t points,
                OutputFile& output);

void
writePlyEnd (const CloudShape& shape, FileFormat format, OutputFile& output);
} // namespace tools
} // namespace pcl_normal_smoothing
