// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>

#include <array>
#include <charconv>

namespace pcl_normal_smoothing
{
namespace core
{
std::string
numberText (double number)
{
  std::array<char, 32> text;
  // Unlike printf, whose decimal point is that of the user's language.
  const auto end = std::to_chars (text.begin (), text.end (), number, std::chars_format::general, 6).ptr;
  return {text.begin (), end};
}
} // namespace core
} // namespace pcl_normal_smoothing
