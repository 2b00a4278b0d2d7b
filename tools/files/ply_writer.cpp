// SPDX-License-Identifier: BSD-3-Clause
#include "field_values.h"
#include "ply_format.h"

#include <algorithm>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Field = pcl::PCLPointField;

const char*
typeName (const Field& field)
{
  switch (field.datatype) {
  case Field::INT8:
    return "char";
  case Field::BOOL:
  case Field::UINT8:
    return "uchar";
  case Field::INT16:
    return "short";
  case Field::UINT16:
    return "ushort";
  case Field::INT32:
    return "int";
  case Field::UINT32:
    return "uint";
  case Field::FLOAT32:
    return "float";
  case Field::FLOAT64:
    return "double";
  default:
    throw FormatError ("PLY has no type for the 64-bit integers of field " + field.name);
  }
}

/** Number of colour channels that a packed field is written as; 0 for every other field. */
std::size_t
channelsOf (const Field& field)
{
  const bool packed = field.count <= 1 && (field.datatype == Field::FLOAT32 || field.datatype == Field::UINT32);
  if (!packed)
    return 0;
  return field.name == "rgb" ? 3 : field.name == "rgba" ? 4 : 0;
}

} // namespace

std::string
plyHeader (const CloudShape& shape, FileFormat format)
{
  std::string text = "ply\nformat ";
  text += format == FileFormat::ASCII ? "ascii" : "binary_little_endian";
  text += " 1.0\nelement vertex " + std::to_string (shape.size ()) + "\n";
  for (const Field& field : shape.fields) {
    const std::size_t channels = channelsOf (field);
    if (channels > 0) {
      text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
      text += channels == 4 ? "property uchar alpha\n" : "";
      continue;
    }
    const bool normal = field.name == "normal_x" || field.name == "normal_y" || field.name == "normal_z";
    text += std::string ("property ") + (field.count > 1 ? "list uint " : "") + typeName (field) + " ";
    text += (normal ? "n" + field.name.substr (7) : field.name) + "\n";
  }
  // VTK requires a face element. PCL stores the viewpoint, the width and the height in the camera element.
  text += "element face 0\nproperty list uchar int vertex_indices\nelement camera 1\n";
  for (const char* name :
       {"view_px", "view_py", "view_pz", "x_axisx", "x_axisy", "x_axisz", "y_axisx", "y_axisy", "y_axisz", "z_axisx",
        "z_axisy", "z_axisz", "focal", "scalex", "scaley", "centerx", "centery"})
    text += std::string ("property float ") + name + "\n";
  return text + "property int viewportx\nproperty int viewporty\nproperty float k1\nproperty float k2\nend_header\n";
}

namespace
{
/** Appends numbers to a record, as text or as bytes. */
class Record
{
public:
  explicit Record (FileFormat format) : format_ (format) {}

  void
  add (std::uint8_t datatype, const void* value)
  {
    if (format_ != FileFormat::ASCII) {
      bytes_.append (static_cast<const char*> (value), sizeOfType (datatype));
      return;
    }
    bytes_ += bytes_.empty () ? "" : " ";
    appendValue (static_cast<const std::uint8_t*> (value), datatype, bytes_);
  }

  void
  writeTo (OutputFile& output)
  {
    if (format_ == FileFormat::ASCII)
      bytes_ += '\n';
    output.write (bytes_);
    bytes_.clear ();
  }

private:
  FileFormat format_;
  std::string bytes_;
};

void
addField (const Field& field, const std::uint8_t* value, Record& record)
{
  if (const std::size_t channels = channelsOf (field)) { // packed as blue, green, red, alpha
    for (const std::size_t channel : {2, 1, 0, 3})
      if (channel < channels)
        record.add (Field::UINT8, value + channel);
    return;
  }
  const std::uint32_t count = field.count;
  if (count > 1)
    record.add (Field::UINT32, &count);
  for (std::size_t c = 0; c < std::max<std::size_t> (count, 1); ++c)
    record.add (field.datatype, value + c * sizeOfType (field.datatype));
}

void
addCamera (const CloudShape& shape, Record& record)
{
  const auto add = [&] (float number) { record.add (Field::FLOAT32, &number); };
  for (int d = 0; d < 3; ++d)
    add (shape.origin[d]);
  const bool turned = shape.orientation.norm () > 0;
  const Eigen::Quaternionf pose = turned ? shape.orientation.normalized () : Eigen::Quaternionf::Identity ();
  const Eigen::Matrix3f axes = pose.toRotationMatrix ();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      add (axes (row, column));
  for (int unused = 0; unused < 5; ++unused)
    add (0);
  for (const std::uint64_t length : {shape.width, shape.height}) {
    const std::int64_t size = shape.size () > max_cloud_size ? 0 : static_cast<std::int64_t> (length); // 0: unknown
    record.add (Field::INT32, &size);
  }
  add (0);
  add (0);
}
} // namespace

void
writePlyPoints (const CloudShape& shape,
                FileFormat format,
                const std::uint8_t* data,
                std::size_t points,
                OutputFile& output)
{
  Record record (format);
  for (std::size_t i = 0; i < points; ++i, data += shape.point_step) {
    for (const Field& field : shape.fields)
      addField (field, data + field.offset, record);
    record.writeTo (output);
  }
}

void
writePlyEnd (const CloudShape& shape, FileFormat format, OutputFile& output)
{
  Record record (format);
  addCamera (shape, record);
  record.writeTo (output);
}

void
writePly (const CloudFile& file, FileFormat format, OutputFile& output)
{
  const CloudShape shape = shapeOf (file);
  output.write (plyHeader (shape, format));
  writePlyPoints (shape, format, file.cloud->data.data (), file.size (), output);
  writePlyEnd (shape, format, output);
}
} // namespace tools
} // namespace pcl_normal_smoothing
