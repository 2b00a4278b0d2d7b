// SPDX-License-Identifier: BSD-3-Clause
#include "coordinate_fields.h"

#include "field_values.h"
#include "tool_error.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Field = pcl::PCLPointField;
using Fields = std::vector<Field>;

/** Indices of the three coordinates' fields; empty if one is missing or holds more than one number. */
std::vector<std::size_t>
coordinatesOf (const Fields& fields)
{
  constexpr std::array<std::array<const char*, 3>, 2> names {{{"x", "y", "z"}, {"X", "Y", "Z"}}};
  for (const auto& triple : names) {
    std::vector<std::size_t> found;
    for (const char* name : triple) {
      const auto field = std::find_if (fields.begin (), fields.end (), [&] (const Field& candidate) {
        return candidate.name == name && candidate.count <= 1;
      });
      if (field != fields.end ())
        found.push_back (static_cast<std::size_t> (field - fields.begin ()));
    }
    if (found.size () == triple.size ())
      return found;
  }
  return {};
}

bool
fitsFloat (const Field& field)
{
  return field.datatype == Field::FLOAT32 || sizeOfType (field.datatype) <= sizeof (std::uint16_t);
}

bool
isFloatOrDouble (const Field& field)
{
  return field.datatype == Field::FLOAT32 || field.datatype == Field::FLOAT64;
}

/** Converts a number to float or double. */
void
convertNumber (const std::uint8_t* from, std::uint8_t from_type, std::uint8_t* to, std::uint8_t to_type)
{
  const double number = numberOf (from, from_type);
  const auto single = static_cast<float> (number);
  if (to_type == Field::FLOAT32)
    std::memcpy (to, &single, sizeof single);
  else
    std::memcpy (to, &number, sizeof number);
}
} // namespace

CoordinateFields::CoordinateFields (const CloudShape& stored)
: stored_ (stored.fields), fields_ (stored.fields), stored_step_ (stored.point_step), step_ (stored.point_step)
{
  const std::vector<std::size_t> coordinates = coordinatesOf (stored_);
  if (coordinates.empty ())
    return;
  for (std::size_t d = 0; d < coordinates.size (); ++d)
    rename (coordinates[d], std::string (1, "xyz"[d]));
  const Field& first = stored_[coordinates[0]];
  const auto all = [&] (const auto& holds) {
    return std::all_of (coordinates.begin (), coordinates.end (), [&] (std::size_t c) { return holds (stored_[c]); });
  };
  converts_ = !isFloatOrDouble (first) || !all ([&] (const Field& f) { return f.datatype == first.datatype; });
  if (!converts_)
    return;
  const std::uint8_t type = all (fitsFloat) ? Field::FLOAT32 : Field::FLOAT64;
  for (const std::size_t c : coordinates)
    fields_[c].datatype = type;
  step_ = 0; // the new points have no padding
  for (Field& field : fields_) {
    field.offset = static_cast<pcl::uindex_t> (step_);
    step_ += field.count * sizeOfType (field.datatype);
  }
}

void
CoordinateFields::rename (std::size_t field, const std::string& name)
{
  const std::string old = fields_[field].name;
  const auto hasName = [&] (const Field& other) { return other.name == name; };
  if (old != name && std::any_of (fields_.begin (), fields_.end (), hasName))
    throw FormatError ("has both " + name + " and " + old + ", and not all of x, y, z");
  fields_[field].name = name;
}

CloudShape
CoordinateFields::shapeFrom (const CloudShape& stored) const
{
  CloudShape shape = stored;
  shape.fields = fields_;
  shape.point_step = step_;
  return shape;
}

void
CoordinateFields::convert (std::vector<std::uint8_t>& data) const
{
  if (!converts_)
    return;
  const std::size_t size = data.size () / stored_step_;
  std::vector<std::uint8_t> converted (size * step_);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t f = 0; f < fields_.size (); ++f) {
      const std::uint8_t* from = data.data () + i * stored_step_ + stored_[f].offset;
      std::uint8_t* to = converted.data () + i * step_ + fields_[f].offset;
      if (fields_[f].datatype == stored_[f].datatype)
        std::memcpy (to, from, fields_[f].count * sizeOfType (fields_[f].datatype));
      else
        convertNumber (from, stored_[f].datatype, to, fields_[f].datatype);
    }
  data.swap (converted);
}
} // namespace tools
} // namespace pcl_normal_smoothing
