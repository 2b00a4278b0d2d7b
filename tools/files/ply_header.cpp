// SPDX-License-Identifier: BSD-3-Clause
#include "field_values.h"
#include "ply_format.h"

#include <array>
#include <utility>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Field = pcl::PCLPointField;

std::uint8_t
typeNamed (std::string_view name)
{
  constexpr std::array<std::pair<std::string_view, std::uint8_t>, 16> types {{{"char", Field::INT8},
                                                                              {"int8", Field::INT8},
                                                                              {"uchar", Field::UINT8},
                                                                              {"uint8", Field::UINT8},
                                                                              {"short", Field::INT16},
                                                                              {"int16", Field::INT16},
                                                                              {"ushort", Field::UINT16},
                                                                              {"uint16", Field::UINT16},
                                                                              {"int", Field::INT32},
                                                                              {"int32", Field::INT32},
                                                                              {"uint", Field::UINT32},
                                                                              {"uint32", Field::UINT32},
                                                                              {"float", Field::FLOAT32},
                                                                              {"float32", Field::FLOAT32},
                                                                              {"double", Field::FLOAT64},
                                                                              {"float64", Field::FLOAT64}}};
  for (const auto& [known, type] : types)
    if (known == name)
      return type;
  throw FormatError ("its header has a property of an unknown type (" + std::string (name) + ")");
}

PlyHeader::Encoding
encodingNamed (std::string_view name)
{
  if (name == "ascii")
    return PlyHeader::Encoding::ASCII;
  if (name == "binary_little_endian")
    return PlyHeader::Encoding::LITTLE_ENDIAN_BYTES;
  if (name == "binary_big_endian")
    return PlyHeader::Encoding::BIG_ENDIAN_BYTES;
  throw FormatError ("its header has an unknown format (" + std::string (name) + ")");
}

/** The smallest number of bytes that an element can take. */
std::size_t
leastBytes (const PlyElement& element, PlyHeader::Encoding encoding)
{
  std::size_t bytes = 0;
  for (const PlyProperty& property : element.properties)
    if (encoding == PlyHeader::Encoding::ASCII)
      bytes += 2; // a digit and a separator
    else
      bytes += sizeOfType (property.list_type != 0 ? property.list_type : property.datatype);
  return bytes;
}

/** To be checked before memory is allocated for what a header claims. */
void
checkCounts (const PlyHeader& header, std::uint64_t available)
{
  for (const PlyElement& element : header.elements) {
    const std::size_t least = leastBytes (element, header.encoding);
    if (least > 0 && element.count > (available + 1) / least)
      throw FormatError ("is truncated, it holds less than the " + std::to_string (element.count) + " elements " +
                         element.name + " that its header claims");
  }
}

PlyProperty
readProperty (std::string_view line)
{
  PlyProperty property;
  std::string_view type = nextWord (line);
  if (type == "list") {
    property.list_type = typeNamed (nextWord (line));
    if (property.list_type == Field::FLOAT32 || property.list_type == Field::FLOAT64)
      throw FormatError ("its header has a list whose length is no integer");
    type = nextWord (line);
  }
  property.datatype = typeNamed (type);
  property.name = nextWord (line);
  return property;
}
} // namespace

PlyHeader
readPlyHeader (ByteStream& stream)
{
  PlyHeader header;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; // some editors write it
  if (stream.peek (byte_order_mark.size ()).substr (0, byte_order_mark.size ()) == byte_order_mark)
    stream.skip (byte_order_mark.size ());
  std::string_view line = nextLine (stream);
  if (line != "ply")
    throw FormatError ("is no PLY file, it does not begin with the line ply");
  while (stream.left () > 0) {
    line = nextLine (stream);
    const std::string_view key = nextWord (line);
    if (key == "format")
      header.encoding = encodingNamed (nextWord (line));
    else if (key == "element") {
      header.elements.emplace_back ();
      header.elements.back ().name = nextWord (line);
      if (!parseCount (nextWord (line), header.elements.back ().count))
        throw FormatError ("its header does not say how many elements " + header.elements.back ().name + " there are");
    }
    else if (key == "property" && !header.elements.empty ())
      header.elements.back ().properties.push_back (readProperty (line));
    else if (key == "end_header") {
      checkCounts (header, stream.left ());
      return header;
    }
    else if (key != "comment" && key != "obj_info" && !key.empty ())
      throw FormatError ("its header has a line that PLY does not know (" + std::string (key.substr (0, 40)) + ")");
  }
  throw FormatError ("is truncated, its header does not end");
}
} // namespace tools
} // namespace pcl_normal_smoothing
