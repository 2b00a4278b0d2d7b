// SPDX-License-Identifier: BSD-3-Clause
#include "field_values.h"
#include "pcd_format.h"

#include <lzf.h>
#include <pcl/common/io.h>

#include <cstring>
#include <limits>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
std::size_t
bytesOf (const pcl::PCLPointField& field)
{
  return std::max<std::size_t> (field.count, 1) * sizeOfType (field.datatype);
}

/** Type of a field in the file. As text, packed colours are written as integers: most are NaN as a float, and text
  * does not distinguish one NaN from another. PCL's writer does the same, and its reader accepts both. */
std::uint8_t
typeIn (FileFormat format, const pcl::PCLPointField& field)
{
  const bool colour = (field.name == "rgb" || field.name == "rgba") && field.datatype == pcl::PCLPointField::FLOAT32;
  return colour && format == FileFormat::ASCII ? std::uint8_t (pcl::PCLPointField::UINT32) : field.datatype;
}

} // namespace

std::string
pcdHeader (const CloudShape& shape, FileFormat format)
{
  std::string names, sizes, types, counts;
  for (const auto& field : shape.fields) {
    const std::uint8_t type = typeIn (format, field);
    names += " " + field.name;
    sizes += " " + std::to_string (sizeOfType (type));
    types += std::string (" ") + pcl::getFieldType (type);
    counts += " " + std::to_string (std::max<std::size_t> (field.count, 1));
  }
  std::string text = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + names + "\nSIZE" + sizes +
                     "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " + std::to_string (shape.width) + "\nHEIGHT " +
                     std::to_string (shape.height) + "\nVIEWPOINT";
  const Eigen::Quaternionf& q = shape.orientation;
  for (const float number : {shape.origin[0], shape.origin[1], shape.origin[2], q.w (), q.x (), q.y (), q.z ()}) {
    text += ' ';
    appendFloat (number, text);
  }
  const char* encoding = format == FileFormat::ASCII    ? "ascii"
                         : format == FileFormat::BINARY ? "binary"
                                                        : "binary_compressed";
  return text + "\nPOINTS " + std::to_string (shape.size ()) + "\nDATA " + encoding + "\n";
}

namespace
{
std::string_view
fieldBytes (const std::uint8_t* point, const pcl::PCLPointField& field)
{
  return {reinterpret_cast<const char*> (point + field.offset), bytesOf (field)};
}

void
writeAsciiPoint (const CloudShape& shape, const std::uint8_t* point, std::string& line, OutputFile& output)
{
  line.clear ();
  for (const auto& field : shape.fields) {
    const std::uint8_t type = typeIn (FileFormat::ASCII, field);
    const std::string_view bytes = fieldBytes (point, field);
    for (std::size_t at = 0; at < bytes.size (); at += sizeOfType (type)) {
      line += line.empty () ? "" : " ";
      appendValue (reinterpret_cast<const std::uint8_t*> (bytes.data ()) + at, type, line);
    }
  }
  line += '\n';
  output.write (line);
}

void
writeCompressed (const CloudFile& file, OutputFile& output)
{
  std::string columns;
  for (const auto& field : file.cloud->fields)
    for (std::size_t i = 0; i < file.size (); ++i)
      columns += fieldBytes (file.cloud->data.data () + i * file.cloud->point_step, field);
  // LZF makes incompressible data a thirtieth longer.
  const std::size_t capacity = columns.size () + columns.size () / 16 + 64;
  if (capacity > std::numeric_limits<std::uint32_t>::max ())
    throw FormatError ("a compressed PCD file holds 4 gigabytes at most, the cloud has more");
  std::string block (capacity, '\0');
  const std::uint32_t sizes[2] = {lzf_compress (columns.data (), static_cast<unsigned> (columns.size ()), block.data (),
                                                static_cast<unsigned> (capacity)),
                                  static_cast<std::uint32_t> (columns.size ())};
  if (sizes[0] == 0 && !columns.empty ())
    throw FormatError ("the cloud cannot be compressed");
  output.write ({reinterpret_cast<const char*> (sizes), sizeof sizes});
  output.write (std::string_view (block).substr (0, sizes[0]));
}
} // namespace

void
writePcdPoints (const CloudShape& shape,
                FileFormat format,
                const std::uint8_t* data,
                std::size_t points,
                OutputFile& output)
{
  std::string line;
  for (std::size_t i = 0; i < points; ++i, data += shape.point_step)
    if (format == FileFormat::ASCII)
      writeAsciiPoint (shape, data, line, output);
    else
      for (const auto& field : shape.fields)
        output.write (fieldBytes (data, field));
}

void
writePcd (const CloudFile& file, FileFormat format, OutputFile& output)
{
  const CloudShape shape = shapeOf (file);
  output.write (pcdHeader (shape, format));
  if (format == FileFormat::COMPRESSED)
    writeCompressed (file, output);
  else
    writePcdPoints (shape, format, file.cloud->data.data (), file.size (), output);
}
} // namespace tools
} // namespace pcl_normal_smoothing
