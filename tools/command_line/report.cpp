// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace pcl_normal_smoothing
{
namespace tools
{
void
Report::add (const std::string& name, double value, const std::string& meaning)
{
  char digits[40];
  const auto end = std::to_chars (digits, digits + sizeof digits, value, std::chars_format::general, 9).ptr;
  entries_.push_back ({name, std::isfinite (value) ? std::string (digits, end) : "null", meaning});
}

void
Report::print (bool json) const
{
  if (!json) {
    for (const Entry& entry : entries_)
      std::printf ("%-14s  %-14s  %s\n", entry.name.c_str (), entry.value.c_str (), entry.meaning.c_str ());
    return;
  }
  const char* separator = "{";
  for (const Entry& entry : entries_) {
    std::printf ("%s\"%s\": %s", separator, entry.name.c_str (), entry.value.c_str ());
    separator = ", ";
  }
  std::printf ("}\n");
}
} // namespace tools
} // namespace pcl_normal_smoothing
