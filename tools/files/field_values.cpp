// SPDX-License-Identifier: BSD-3-Clause
#include "field_values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Calls \a use with a number of the C++ type of a datatype. \return false for an unknown datatype */
template <typename Use>
bool
withType (std::uint8_t datatype, const Use& use)
{
  using Field = pcl::PCLPointField;
  switch (datatype) {
  case Field::BOOL: // stored in a byte
  case Field::UINT8:
    return use (std::uint8_t ());
  case Field::INT8:
    return use (std::int8_t ());
  case Field::INT16:
    return use (std::int16_t ());
  case Field::UINT16:
    return use (std::uint16_t ());
  case Field::INT32:
    return use (std::int32_t ());
  case Field::UINT32:
    return use (std::uint32_t ());
  case Field::INT64:
    return use (std::int64_t ());
  case Field::UINT64:
    return use (std::uint64_t ());
  case Field::FLOAT32:
    return use (float ());
  case Field::FLOAT64:
    return use (double ());
  default:
    return false;
  }
}

template <typename T>
bool
parse (std::string_view text, T& value)
{
  if (!text.empty () && text.front () == '+')
    text.remove_prefix (1);
  const auto [end, error] = std::from_chars (text.data (), text.data () + text.size (), value);
  if (end != text.data () + text.size () || text.empty ())
    return false;
  if constexpr (std::is_floating_point_v<T>)
    if (error == std::errc::result_out_of_range) { // infinity, or zero or a denormal number
      value = static_cast<T> (std::strtod (std::string (text).c_str (), nullptr));
      return true;
    }
  return error == std::errc ();
}

template <typename T>
void
append (T value, std::string& text)
{
  if constexpr (std::is_floating_point_v<T>)
    if (std::isnan (value)) {
      text += "nan";
      return;
    }
  char digits[40];
  const auto result = std::to_chars (digits, digits + sizeof digits, value);
  text.append (digits, result.ptr);
}
} // namespace

std::size_t
sizeOfType (std::uint8_t datatype)
{
  std::size_t size = 0;
  withType (datatype, [&] (auto number) {
    size = sizeof number;
    return true;
  });
  return size;
}

bool
parseValue (std::string_view text, std::uint8_t datatype, std::uint8_t* value)
{
  return withType (datatype, [&] (auto number) {
    if (!parse (text, number))
      return false;
    std::memcpy (value, &number, sizeof number);
    return true;
  });
}

double
numberOf (const std::uint8_t* value, std::uint8_t datatype)
{
  double result = 0;
  withType (datatype, [&] (auto number) {
    std::memcpy (&number, value, sizeof number);
    result = static_cast<double> (number);
    return true;
  });
  return result;
}

void
appendValue (const std::uint8_t* value, std::uint8_t datatype, std::string& text)
{
  withType (datatype, [&] (auto number) {
    std::memcpy (&number, value, sizeof number);
    append (number, text);
    return true;
  });
}

void
appendFloat (float value, std::string& text)
{
  append (value, text);
}

std::string_view
nextWord (std::string_view& text)
{
  constexpr std::string_view space = " \t\r\n\v\f";
  text.remove_prefix (std::min (text.find_first_not_of (space), text.size ()));
  const std::string_view word = text.substr (0, text.find_first_of (space));
  text.remove_prefix (word.size ());
  return word;
}

std::string_view
nextLine (std::string_view& text)
{
  std::string_view line = text.substr (0, text.find ('\n'));
  text.remove_prefix (std::min (line.size () + 1, text.size ()));
  if (!line.empty () && line.back () == '\r')
    line.remove_suffix (1);
  return line;
}

bool
parseCount (std::string_view word, std::uint64_t& count)
{
  return parse (word, count);
}

const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& cloud, const std::string& name)
{
  const auto field = std::find_if (cloud.fields.begin (), cloud.fields.end (),
                                   [&] (const auto& candidate) { return candidate.name == name; });
  return field == cloud.fields.end () ? nullptr : &*field;
}

void
addFloatFields (pcl::PCLPointCloud2& cloud, const std::vector<std::string>& names)
{
  const std::size_t old_step = cloud.point_step;
  for (const std::string& name : names) {
    if (findField (cloud, name))
      continue;
    pcl::PCLPointField field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = pcl::PCLPointField::FLOAT32;
    field.count = 1;
    cloud.fields.push_back (field);
    cloud.point_step += sizeof (float);
  }
  const std::size_t step = cloud.point_step, size = std::size_t (cloud.width) * cloud.height;
  if (step == old_step)
    return;
  std::vector<std::uint8_t> data (size * step);
  const float nan = std::numeric_limits<float>::quiet_NaN ();
  for (std::size_t i = 0; i < size; ++i) {
    std::copy_n (cloud.data.data () + i * old_step, old_step, data.data () + i * step);
    for (std::size_t at = old_step; at < step; at += sizeof nan)
      std::memcpy (data.data () + i * step + at, &nan, sizeof nan);
  }
  cloud.data.swap (data);
  cloud.row_step = cloud.width * cloud.point_step;
}
} // namespace tools
} // namespace pcl_normal_smoothing
