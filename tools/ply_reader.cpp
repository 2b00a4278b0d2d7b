// SPDX-License-Identifier: BSD-3-Clause
#include "field_values.h"
#include "ply_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Field = pcl::PCLPointField;
using Encoding = PlyHeader::Encoding;

/** Takes one number after the other off the data. */
class Values
{
public:
  Values (std::string_view data, Encoding encoding) : data_ (data), encoding_ (encoding) {}

  /** \param[out] value where the bytes of a number of type \a datatype go */
  void
  read (std::uint8_t datatype, std::uint8_t* value)
  {
    if (encoding_ == Encoding::ASCII) {
      const std::string_view word = nextWord (data_);
      if (!parseValue (word, datatype, value))
        throw FormatError (word.empty () ? "is truncated, its data end too early"
                                         : "has a value that is no number of its type (" + std::string (word) + ")");
      return;
    }
    const std::size_t size = sizeOfType (datatype);
    if (data_.size () < size)
      throw FormatError ("is truncated, its data end too early");
    std::memcpy (value, data_.data (), size);
    if (encoding_ == Encoding::BIG_ENDIAN_BYTES)
      std::reverse (value, value + size);
    data_.remove_prefix (size);
  }

  /** How long the list is that comes next. */
  std::size_t
  readLength (std::uint8_t datatype)
  {
    std::array<std::uint8_t, 8> bytes {}; // little-endian, like every machine that PCL runs on
    read (datatype, bytes.data ());
    std::uint64_t length;
    std::memcpy (&length, bytes.data (), sizeof length);
    if (length > data_.size ())
      throw FormatError ("is truncated or damaged, a list is longer than the file");
    return static_cast<std::size_t> (length);
  }

  /** Numbers of that type that may still follow. */
  std::size_t
  room (std::uint8_t datatype) const
  {
    return encoding_ == Encoding::ASCII ? (data_.size () + 1) / 2 : data_.size () / sizeOfType (datatype);
  }

private:
  std::string_view data_;
  Encoding encoding_;
};

/** Reads past an element, or hands its scalar numbers to \a use (property name, value). */
template <typename Use>
void
readElement (const PlyElement& element, Values& values, const Use& use)
{
  std::array<std::uint8_t, 8> bytes;
  const std::uint64_t count = element.properties.empty () ? 0 : element.count;
  for (std::uint64_t i = 0; i < count; ++i)
    for (const PlyProperty& property : element.properties) {
      const std::size_t length = property.list_type == 0 ? 1 : values.readLength (property.list_type);
      for (std::size_t c = 0; c < length; ++c)
        values.read (property.datatype, bytes.data ());
      if (property.list_type == 0)
        use (property, bytes.data ());
    }
}

/** Where the numbers of a vertex go. */
struct Slot
{
  std::size_t offset = 0;
  std::size_t length = 1;
};

/** Builds the fields of a cloud from the properties of a vertex. */
class VertexFields
{
public:
  explicit VertexFields (const PlyElement& vertex) : vertex_ (vertex)
  {
    const auto position = [&] (const char* name) {
      const auto found =
          std::find_if (vertex.properties.begin (), vertex.properties.end (), [&] (const auto& property) {
            return property.name == name && property.datatype == Field::UINT8 && property.list_type == 0;
          });
      return found - vertex.properties.begin ();
    };
    const auto end = static_cast<std::ptrdiff_t> (vertex.properties.size ());
    has_colour_ = position ("red") < end && position ("green") < end && position ("blue") < end;
    has_alpha_ = has_colour_ && position ("alpha") < end;
  }

  /** \param[in] length of every list */
  std::vector<Slot>
  place (const std::vector<std::size_t>& lengths, pcl::PCLPointCloud2& cloud)
  {
    std::vector<Slot> slots;
    for (std::size_t p = 0; p < vertex_.properties.size (); ++p) {
      const PlyProperty& property = vertex_.properties[p];
      const int channel = channelOf (property);
      if (channel < 0)
        slots.push_back ({addField (cloud, fieldName (property.name), property.datatype, lengths[p]), lengths[p]});
      else {
        if (colour_offset_ == none)
          colour_offset_ =
              has_alpha_ ? addField (cloud, "rgba", Field::UINT32, 1) : addField (cloud, "rgb", Field::FLOAT32, 1);
        slots.push_back ({colour_offset_ + static_cast<std::size_t> (channel), 1});
      }
    }
    return slots;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t> (-1);

  /** Byte of a packed colour that a property goes to; -1 where it is none. */
  int
  channelOf (const PlyProperty& property) const
  {
    if (!has_colour_ || property.datatype != Field::UINT8 || property.list_type != 0)
      return -1;
    if (property.name == "alpha")
      return 3;
    return property.name == "red" ? 2 : property.name == "green" ? 1 : property.name == "blue" ? 0 : -1;
  }

  static std::string
  fieldName (const std::string& name)
  {
    const bool normal = name == "nx" || name == "ny" || name == "nz";
    return normal ? "normal_" + name.substr (1) : name;
  }

  static std::size_t
  addField (pcl::PCLPointCloud2& cloud, const std::string& name, std::uint8_t datatype, std::size_t count)
  {
    Field field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = datatype;
    field.count = static_cast<pcl::uindex_t> (count);
    if (count > 0)
      cloud.fields.push_back (field);
    if (cloud.point_step + count * sizeOfType (datatype) > max_point_bytes)
      throw FormatError ("has vertices of more than 16 megabytes");
    cloud.point_step += static_cast<pcl::uindex_t> (count * sizeOfType (datatype));
    return field.offset;
  }

  const PlyElement& vertex_;
  bool has_colour_ = false;
  bool has_alpha_ = false;
  std::size_t colour_offset_ = none;
};

/** Length of every property of the first vertex: a list becomes a field of that many numbers. */
std::vector<std::size_t>
firstLengths (const PlyElement& vertex, Values values)
{
  std::vector<std::size_t> lengths;
  std::array<std::uint8_t, 8> bytes;
  for (const PlyProperty& property : vertex.properties) {
    const bool list = property.list_type != 0;
    lengths.push_back (!list ? 1 : vertex.count == 0 ? 0 : values.readLength (property.list_type));
    for (std::size_t c = 0; c < lengths.back () && vertex.count > 0; ++c)
      values.read (property.datatype, bytes.data ());
  }
  return lengths;
}

void
readVertices (const PlyElement& vertex, Values& values, pcl::PCLPointCloud2& cloud)
{
  if (vertex.count > max_points)
    throw FormatError ("its header claims more points than PCL can count");
  const std::vector<std::size_t> lengths = firstLengths (vertex, values);
  const std::vector<Slot> slots = VertexFields (vertex).place (lengths, cloud);
  for (std::size_t p = 0; p < slots.size (); ++p)
    if (slots[p].length > 0 && vertex.count > values.room (vertex.properties[p].datatype) / slots[p].length)
      throw FormatError ("is truncated, its data end too early");
  cloud.data.resize (vertex.count * cloud.point_step);
  std::uint8_t* point = cloud.data.data ();
  for (std::uint64_t i = 0; i < vertex.count; ++i, point += cloud.point_step)
    for (std::size_t p = 0; p < slots.size (); ++p) {
      const PlyProperty& property = vertex.properties[p];
      if (property.list_type != 0 && values.readLength (property.list_type) != slots[p].length)
        throw FormatError ("has lists " + property.name +
                           " of different lengths in its vertices, which no cloud can hold");
      for (std::size_t c = 0; c < slots[p].length; ++c)
        values.read (property.datatype, point + slots[p].offset + c * sizeOfType (property.datatype));
    }
}

double
toDouble (std::uint8_t datatype, const std::uint8_t* bytes)
{
  if (datatype == Field::FLOAT32) {
    float number;
    std::memcpy (&number, bytes, sizeof number);
    return number;
  }
  std::string text;
  appendValue (bytes, datatype, text);
  return std::strtod (text.c_str (), nullptr);
}

/** What PCL keeps in a camera element: the sensor's pose, and the width and height of the cloud. */
void
applyCamera (const std::map<std::string, double>& camera, CloudFile& file)
{
  const auto value = [&] (const std::string& name) {
    const auto found = camera.find (name);
    return found == camera.end () ? 0.0 : found->second;
  };
  Eigen::Matrix3d axes;
  const std::string names = "xyz";
  for (int row = 0; row < 3; ++row) {
    const std::string axis {names[static_cast<std::size_t> (row)]};
    file.origin[row] = static_cast<float> (value ("view_p" + axis));
    axes.row (row) << value (axis + "_axisx"), value (axis + "_axisy"), value (axis + "_axisz");
  }
  // Other programs leave the axes empty, and put the size of their window into the viewport.
  if (std::abs (axes.determinant () - 1) < 1e-3)
    file.orientation = Eigen::Quaterniond (axes).normalized ().cast<float> ();
  const double width = value ("viewportx"), height = value ("viewporty");
  if (width >= 1 && height >= 1 && width * height == static_cast<double> (file.size ())) {
    file.cloud->width = static_cast<pcl::uindex_t> (width);
    file.cloud->height = static_cast<pcl::uindex_t> (height);
  }
}
} // namespace

void
readPly (const std::string& bytes, CloudFile& file)
{
  std::string_view body = bytes;
  const PlyHeader header = readPlyHeader (body);
  Values values (body, header.encoding);
  bool has_vertices = false;
  std::map<std::string, double> camera;
  for (const PlyElement& element : header.elements)
    if (element.name == "vertex" && !has_vertices) {
      readVertices (element, values, *file.cloud);
      file.cloud->width = static_cast<pcl::uindex_t> (element.count);
      file.cloud->height = 1;
      has_vertices = true;
    }
    else {
      file.faces = element.name == "face" ? element.count : file.faces;
      readElement (element, values, [&] (const PlyProperty& property, const std::uint8_t* value) {
        if (element.name == "camera")
          camera[property.name] = toDouble (property.datatype, value);
      });
    }
  if (!has_vertices)
    throw FormatError ("has no element vertex");
  applyCamera (camera, file);
  file.cloud->row_step = file.cloud->width * file.cloud->point_step;
}
} // namespace tools
} // namespace pcl_normal_smoothing
