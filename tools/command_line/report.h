// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Named numbers, for people or for programs. */
class Report
{
public:
  void
  add (const std::string& name, double value, const std::string& meaning);

  /** \param[in] json true: one line of JSON, with null for numbers that are not finite; false: one line per number */
  void
  print (bool json) const;

private:
  struct Entry
  {
    std::string name, value, meaning;
  };

  std::vector<Entry> entries_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
