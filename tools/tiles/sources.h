// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

#include <functional>

namespace pcl_normal_smoothing
{
namespace tools
{
/** The input files as one cloud, whose points are numbered consecutively through all files. */
class Sources
{
public:
  /** Reads the headers.
    * \throw FileError if a file cannot be read, is given twice, has other fields than the first, or
    * names that a plan cannot hold */
  explicit Sources (const std::vector<std::string>& paths);

  /** The shape of the first file; all have the same fields. */
  const CloudShape&
  shape () const
  {
    return list_.front ().shape;
  }

  std::uint64_t
  size () const
  {
    return list_.back ().first + list_.back ().shape.size ();
  }

  /** \param[in] first number of the first point of \a points, of which there are \a count */
  using Use = std::function<void (std::uint64_t first, const std::uint8_t* points, std::size_t count)>;

  /** Calls \a use with all points in order, some at a time. \throw FileError if a file is damaged or has changed
    * meanwhile */
  void
  read (const Use& use);

  /** Complete after read (). */
  const std::vector<Source>&
  list () const
  {
    return list_;
  }

  /** Faces of meshes, which clouds do not keep. */
  std::uint64_t
  faces () const;

private:
  std::vector<Source> list_;
};

/** How many points to read at a time: some megabytes. */
std::size_t
pointsAtOnce (const CloudShape& shape);

/** Size in bytes of a file, and the time of its last change. \throw FileError if it is missing */
std::pair<std::uint64_t, std::int64_t>
stateOf (const std::string& path);
} // namespace tools
} // namespace pcl_normal_smoothing
