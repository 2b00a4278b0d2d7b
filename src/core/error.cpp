// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>

#include <array>
#include <cstdio>

namespace pcl_normal_smoothing
{
namespace core
{
std::string
numberText (double number)
{
  std::array<char, 32> text;
  std::snprintf (text.data (), text.size (), "%g", number);
  return text.data ();
}
} // namespace core
} // namespace pcl_normal_smoothing
