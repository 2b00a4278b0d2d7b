// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../shapes.h"

#include <pcl/PCLPointCloud2.h>

#include <cstring>

namespace test_support
{
/** A cloud in bytes: x y z, then a counter, then three bytes of an unknown field. */
struct BinaryLayout
{
  std::uint32_t width = 300;
  std::uint32_t row_padding = 0;
  bool as_double = false;

  std::size_t
  scalarSize () const
  {
    return as_double ? 8 : 4;
  }

  std::size_t
  pointStep () const
  {
    return 3 * scalarSize () + 4 + 3; // odd, so that nothing is aligned
  }

  /** Offset of the first byte of point \a i. */
  std::size_t
  begin (std::size_t i) const
  {
    return i / width * (width * pointStep () + row_padding) + i % width * pointStep ();
  }

  Eigen::Vector3d
  position (const pcl::PCLPointCloud2& cloud, std::size_t i) const
  {
    Eigen::Vector3d as_doubles;
    Eigen::Vector3f as_floats;
    std::memcpy (as_doubles.data (), &cloud.data[begin (i)], as_double ? sizeof as_doubles : 0);
    std::memcpy (as_floats.data (), &cloud.data[begin (i)], as_double ? 0 : sizeof as_floats);
    return as_double ? as_doubles : as_floats.cast<double> ();
  }
};

inline pcl::PCLPointField
makeField (const std::string& name, std::size_t offset, std::uint8_t type, std::uint32_t count)
{
  pcl::PCLPointField field;
  field.name = name;
  field.offset = static_cast<std::uint32_t> (offset);
  field.datatype = type;
  field.count = count;
  return field;
}

/** A cloud of \a points moved by \a translation; every byte outside the positions is a function of its offset. */
inline pcl::PCLPointCloud2
makeBinaryCloud (const BinaryLayout& layout,
                 const Vectors& points,
                 const Eigen::Vector3d& translation = Eigen::Vector3d::Zero ())
{
  const std::size_t size = layout.scalarSize ();
  const std::uint8_t type = layout.as_double ? pcl::PCLPointField::FLOAT64 : pcl::PCLPointField::FLOAT32;
  pcl::PCLPointCloud2 cloud;
  cloud.fields = {makeField ("x", 0, type, 1), makeField ("y", size, type, 1), makeField ("z", 2 * size, type, 1),
                  makeField ("counter", 3 * size, pcl::PCLPointField::UINT32, 1),
                  makeField ("secret", 3 * size + 4, pcl::PCLPointField::UINT8, 3)};
  cloud.header.frame_id = "scanner";
  cloud.header.stamp = 99;
  cloud.width = layout.width;
  cloud.height = static_cast<std::uint32_t> (points.size () / layout.width);
  cloud.point_step = static_cast<std::uint32_t> (layout.pointStep ());
  cloud.row_step = cloud.width * cloud.point_step + layout.row_padding;
  cloud.is_dense = false;
  cloud.data.resize (std::size_t (cloud.row_step) * cloud.height);
  for (std::size_t i = 0; i < cloud.data.size (); ++i)
    cloud.data[i] = static_cast<std::uint8_t> (i * 131 + 7);
  for (std::size_t i = 0; i < points.size (); ++i) {
    const Eigen::Vector3d as_doubles = points[i].cast<double> () + translation;
    const Eigen::Vector3f as_floats = as_doubles.cast<float> ();
    if (layout.as_double)
      std::memcpy (&cloud.data[layout.begin (i)], as_doubles.data (), sizeof as_doubles);
    else
      std::memcpy (&cloud.data[layout.begin (i)], as_floats.data (), sizeof as_floats);
  }
  return cloud;
}

/** Arbitrary contents of an output before it is written. */
inline pcl::PCLPointCloud2
poisonedBinaryCloud ()
{
  pcl::PCLPointCloud2 cloud = makeBinaryCloud ({}, Vectors (300, Eigen::Vector3f::Constant (-7777)));
  cloud.header.frame_id = "poison";
  return cloud;
}
} // namespace test_support
