// SPDX-License-Identifier: BSD-3-Clause
#include "field_values.h"
#include "ply_format.h"
#include "ply_values.h"

#include <algorithm>
#include <array>
#include <cctype>
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

/** Reads an element, and calls \a use (property, bytes of the number) for its numbers, except those in lists. */
template <typename Use>
void
readElement (const PlyElement& element, PlyValues& values, const Use& use)
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

/** Where the numbers of a vertex's property go. */
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

  /** \param[in] lengths of the properties, as firstLengths () gives them */
  std::vector<Slot>
  place (const std::vector<std::size_t>& lengths, CloudShape& cloud)
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

  /** The byte of the packed colour that holds a property; -1 if it is not a colour. */
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
    for (const char* const normal : {"nx", "ny", "nz", "NX", "NY", "NZ"})
      if (name == normal)
        return std::string ("normal_") + static_cast<char> (std::tolower (name[1]));
    return name;
  }

  static std::size_t
  addField (CloudShape& cloud, const std::string& name, std::uint8_t datatype, std::size_t count)
  {
    Field field;
    field.name = name;
    field.offset = static_cast<pcl::uindex_t> (cloud.point_step);
    field.datatype = datatype;
    field.count = static_cast<pcl::uindex_t> (count);
    if (count > 0)
      cloud.fields.push_back (field);
    if (cloud.point_step + count * sizeOfType (datatype) > max_point_bytes)
      throw FormatError ("has vertices of more than 16 megabytes");
    cloud.point_step += count * sizeOfType (datatype);
    return field.offset;
  }

  const PlyElement& vertex_;
  bool has_colour_ = false;
  bool has_alpha_ = false;
  std::size_t colour_offset_ = none;
};

/** Length of every property of the first vertex: a list becomes a field of that many numbers. */
std::vector<std::size_t>
firstLengths (const PlyElement& vertex, PlyHeader::Encoding encoding, PlyValues& values_to_come)
{
  const bool lists = std::any_of (vertex.properties.begin (), vertex.properties.end (),
                                  [] (const PlyProperty& property) { return property.list_type != 0; });
  if (!lists)
    return std::vector<std::size_t> (vertex.properties.size (), 1);
  std::vector<std::size_t> lengths;
  ByteStream ahead (values_to_come.ahead ());
  PlyValues values (ahead, encoding);
  std::array<std::uint8_t, 8> bytes;
  for (const PlyProperty& property : vertex.properties) {
    const bool list = property.list_type != 0;
    lengths.push_back (!list ? 1 : vertex.count == 0 ? 0 : values.readLength (property.list_type));
    for (std::size_t c = 0; c < lengths.back () && vertex.count > 0; ++c)
      values.read (property.datatype, bytes.data ());
  }
  return lengths;
}

/** Applies what PCL stores in a camera element: the sensor's pose, and the width and height of the cloud. */
void
applyCamera (const std::map<std::string, double>& camera, CloudShape& shape)
{
  const auto value = [&] (const std::string& name) {
    const auto found = camera.find (name);
    return found == camera.end () ? 0.0 : found->second;
  };
  Eigen::Matrix3d axes;
  const std::string names = "xyz";
  for (int row = 0; row < 3; ++row) {
    const std::string axis {names[static_cast<std::size_t> (row)]};
    shape.origin[row] = static_cast<float> (value ("view_p" + axis));
    axes.row (row) << value (axis + "_axisx"), value (axis + "_axisy"), value (axis + "_axisz");
  }
  // Other programs leave the axes at zero, and put the size of their window into the viewport.
  if (std::abs (axes.determinant () - 1) < 1e-3)
    shape.orientation = Eigen::Quaterniond (axes).normalized ().cast<float> ();
  const double width = value ("viewportx"), height = value ("viewporty");
  if (width >= 1 && height >= 1 && width * height == static_cast<double> (shape.size ())) {
    shape.width = static_cast<std::uint64_t> (width);
    shape.height = static_cast<std::uint64_t> (height);
  }
}
class PlyReader : public PointReader
{
public:
  PlyReader (ByteStream& stream, std::uint64_t most)
  : header_ (readPlyHeader (stream)), values_ (stream, header_.encoding)
  {
    while (next_ < header_.elements.size () && header_.elements[next_].name != "vertex")
      readOther (header_.elements[next_++]);
    if (next_ == header_.elements.size ())
      throw FormatError ("has no element vertex");
    begin (header_.elements[next_++], most);
  }

  std::size_t
  read (std::size_t most, std::vector<std::uint8_t>& data) override
  {
    const std::size_t count = nextCount (most);
    data.assign (count * shape_.point_step, 0);
    for (std::size_t i = 0; i < count; ++i)
      readVertex (data.data () + i * shape_.point_step);
    done_ += count;
    return count;
  }

  void
  finish () override
  {
    while (next_ < header_.elements.size ())
      readOther (header_.elements[next_++]);
    applyCamera (camera_, shape_);
  }

private:
  void
  begin (const PlyElement& vertex, std::uint64_t most)
  {
    if (vertex.count > most)
      throw FormatError ("its header claims more points than PCL can count");
    properties_ = vertex.properties;
    shape_.width = vertex.count;
    slots_ = VertexFields (vertex).place (firstLengths (vertex, header_.encoding, values_), shape_);
    for (std::size_t p = 0; p < slots_.size (); ++p)
      if (slots_[p].length > 0 && vertex.count > values_.room (properties_[p].datatype) / slots_[p].length)
        throw FormatError ("is truncated, its data end too early");
  }

  void
  readVertex (std::uint8_t* point)
  {
    for (std::size_t p = 0; p < slots_.size (); ++p) {
      const PlyProperty& property = properties_[p];
      if (property.list_type != 0 && values_.readLength (property.list_type) != slots_[p].length)
        throw FormatError ("has lists " + property.name +
                           " of different lengths in its vertices, which no cloud can hold");
      for (std::size_t c = 0; c < slots_[p].length; ++c)
        values_.read (property.datatype, point + slots_[p].offset + c * sizeOfType (property.datatype));
    }
  }

  void
  readOther (const PlyElement& element)
  {
    shape_.faces = element.name == "face" ? element.count : shape_.faces;
    if (element.name != "camera" && header_.encoding == PlyHeader::Encoding::ASCII)
      values_.skipLines (element.count);
    else
      readElement (element, values_, [&] (const PlyProperty& property, const std::uint8_t* value) {
        if (element.name == "camera")
          camera_[property.name] = numberOf (value, property.datatype);
      });
  }

  PlyHeader header_;
  PlyValues values_;
  std::size_t next_ = 0; // element to be read
  std::vector<PlyProperty> properties_;
  std::vector<Slot> slots_;
  std::map<std::string, double> camera_;
};
} // namespace

std::unique_ptr<PointReader>
makePlyReader (ByteStream& stream, std::uint64_t most)
{
  return std::make_unique<PlyReader> (stream, most);
}

void
readPly (const std::string& bytes, CloudFile& file)
{
  ByteStream stream {std::string_view (bytes)};
  PlyReader reader (stream, max_cloud_size);
  reader.read (max_cloud_size, file.cloud->data);
  reader.finish ();
  setShape (reader.shape (), file);
}
} // namespace tools
} // namespace pcl_normal_smoothing
