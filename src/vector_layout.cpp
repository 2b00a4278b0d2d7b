// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <pcl/common/io.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
const VectorFields position_fields {"x", "y", "z"};
const VectorFields normal_fields {"normal_x", "normal_y", "normal_z"};

namespace
{
/** Names, types and sizes in bytes of the fields, as in the header of a PCD file. */
std::string
fieldsOf (const pcl::PCLPointCloud2& cloud)
{
  std::string list;
  for (const pcl::PCLPointField& field : cloud.fields)
    list += (list.empty () ? "" : ", ") + field.name + " " + pcl::getFieldType (field.datatype) +
            std::to_string (pcl::getFieldSize (field.datatype));
  return list.empty () ? "none" : list;
}
} // namespace

std::optional<VectorLayout>
VectorLayout::find (const pcl::PCLPointCloud2& cloud, const VectorFields& names)
{
  Offsets offsets {};
  std::array<std::uint8_t, 3> types {};
  for (std::size_t d = 0; d < 3; ++d) {
    const auto field = std::find_if (cloud.fields.begin (), cloud.fields.end (), [&] (const auto& candidate) {
      return candidate.name == names[d] && candidate.count <= 1;
    });
    if (field == cloud.fields.end ())
      return std::nullopt;
    offsets[d] = field->offset;
    types[d] = field->datatype;
  }
  const bool all_float = types[0] == pcl::PCLPointField::FLOAT32, all_double = types[0] == pcl::PCLPointField::FLOAT64;
  if (types[1] != types[0] || types[2] != types[0] || !(all_float || all_double))
    return std::nullopt;
  const std::size_t scalar_size = all_float ? sizeof (float) : sizeof (double);
  if (*std::max_element (offsets.begin (), offsets.end ()) + scalar_size > cloud.point_step)
    return std::nullopt; // it would extend into the next point
  VectorLayout layout (cloud.point_step, offsets, all_float ? Scalar::FLOAT32 : Scalar::FLOAT64);
  if (cloud.row_step > std::size_t (cloud.width) * cloud.point_step) {
    layout.width_ = cloud.width;
    layout.row_step_ = cloud.row_step;
  }
  return layout;
}

VectorLayout
VectorLayout::require (const pcl::PCLPointCloud2& cloud, const VectorFields& names, const std::string& advice)
{
  if (const auto layout = find (cloud, names))
    return *layout;
  for (const std::string& name : names)
    if (std::none_of (cloud.fields.begin (), cloud.fields.end (), [&] (const auto& f) { return f.name == name; }))
      throw core::Error ("the cloud has no field " + name + ", but " + fieldsOf (cloud) + ": " + advice);
  throw core::Error ("the cloud has no fields " + names[0] + ", " + names[1] + ", " + names[2] +
                     " that are all float or all double, but " + fieldsOf (cloud) + ": " + advice);
}

namespace
{
/** The distance within which at least half of the points lie from the median point, along each axis: robust to a few
  * points far off. */
double
typicalExtent (const std::vector<Eigen::Vector3d>& sample)
{
  if (sample.empty ())
    return 0;
  const auto middleOf = [] (std::vector<double>& numbers) {
    const auto middle = numbers.begin () + static_cast<std::ptrdiff_t> (numbers.size () / 2);
    std::nth_element (numbers.begin (), middle, numbers.end ());
    return *middle;
  };
  std::vector<double> numbers (sample.size ());
  Eigen::Vector3d centre;
  for (int d = 0; d < 3; ++d) {
    std::transform (sample.begin (), sample.end (), numbers.begin (), [d] (const auto& point) { return point[d]; });
    centre[d] = middleOf (numbers);
  }
  std::transform (sample.begin (), sample.end (), numbers.begin (),
                  [&] (const auto& point) { return (point - centre).template lpNorm<Eigen::Infinity> (); });
  const double extent = middleOf (numbers);
  return extent > 0 ? extent : *std::max_element (numbers.begin (), numbers.end ());
}
} // namespace

std::vector<std::uint64_t>
unitSample (std::uint64_t size)
{
  constexpr std::uint64_t sample_size = 1000, prime = 2654435761; // visits every point once if the cloud is smaller
  std::vector<std::uint64_t> sample;
  for (std::uint64_t i = 0; i < std::min (size, sample_size); ++i)
    sample.push_back (i * prime % size);
  return sample;
}

double
unitOf (const VectorView& positions)
{
  std::vector<Eigen::Vector3d> sample;
  for (const std::uint64_t i : unitSample (positions.size)) {
    const Eigen::Vector3d point = positions.layout.get (positions.data, i);
    if (point.allFinite ())
      sample.push_back (point);
  }
  return unitOf (sample);
}

double
unitOf (const std::vector<Eigen::Vector3d>& sample)
{
  constexpr int no_need = 20, most = 1000;
  const double extent = typicalExtent (sample);
  const int exponent = std::isinf (extent) ? most : extent > 0 ? std::clamp (std::ilogb (extent), -most, most) : 0;
  return std::abs (exponent) <= no_need ? 1 : std::ldexp (1.0, exponent);
}

core::Positions
readPositions (const VectorView& view, const core::Execution& execution)
{
  return readPositions (view, unitOf (view), execution);
}

core::Positions
readPositions (const VectorView& view, double unit, const core::Execution& execution)
{
  core::Positions positions {core::Vectors (view.size), core::Vectors (view.size), unit};
  core::parallelFor (view.size, execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d position = view.layout.get (view.data, i) / unit;
      positions.base[i] = position.cast<float> ();
      positions.offset[i] = (position - positions.base[i].cast<double> ()).cast<float> ();
    }
  });
  return positions;
}

core::Vectors
readNormals (const VectorView& view, const core::Elements& order, const core::Execution& execution)
{
  core::Vectors normals (order.size ());
  core::parallelFor (order.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      const Eigen::Vector3d normal = view.layout.get (view.data, order[node]);
      const double length = normal.norm ();
      const bool valid = std::isfinite (length) && length > 0;
      normals[node] = valid ? Eigen::Vector3f ((normal / length).cast<float> ())
                            : Eigen::Vector3f::Constant (std::numeric_limits<float>::quiet_NaN ());
    }
  });
  return normals;
}

std::vector<bool>
selectPoints (const pcl::Indices& indices, std::size_t size)
{
  std::vector<bool> selected (size);
  for (const pcl::index_t index : indices) {
    if (index < 0 || static_cast<std::size_t> (index) >= size)
      throw core::Error ("index " + std::to_string (index) + " of setIndices is out of range: the cloud has " +
                         std::to_string (size) + " points");
    selected[static_cast<std::size_t> (index)] = true;
  }
  return selected;
}

void
writeDisplacements (const core::Vectors& displacements,
                    double unit,
                    const core::Elements& order,
                    const std::vector<bool>& selected,
                    const VectorLayout& layout,
                    std::uint8_t* data,
                    const core::Execution& execution)
{
  constexpr std::size_t ahead = 16; // nodes are in spatial order, the points of the cloud need not be
  core::parallelFor (order.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node) {
      layout.prefetch (data, order[std::min (node + ahead, end - 1)]);
      if (!selected[order[node]] || displacements[node].isZero (0))
        continue;
      const Eigen::Vector3d place = layout.get (data, order[node]) + unit * displacements[node].cast<double> ();
      if (!layout.set (data, order[node], place))
        throw core::Error ("point " + std::to_string (order[node]) +
                           " would move to where its coordinates can hold no number: give the cloud in another unit");
    }
  });
}

void
writeNormals (const core::Vectors& normals,
              const core::Elements& order,
              const std::vector<bool>& selected,
              const VectorLayout& layout,
              std::uint8_t* data,
              const core::Execution& execution)
{
  core::parallelFor (order.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t node = begin; node < end; ++node)
      if (selected[order[node]] && !std::isnan (normals[node].x ()))
        layout.set (data, order[node], normals[node].cast<double> ());
  });
}
} // namespace pcl_normal_smoothing
