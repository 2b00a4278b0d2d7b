// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/parallel_for.h>
#include <pcl_normal_smoothing/core/positions.h>

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace pcl_normal_smoothing
{
/** Names of three fields that form a vector. */
using VectorFields = std::array<std::string, 3>;

extern const VectorFields position_fields; //!< x, y, z
extern const VectorFields normal_fields;   //!< normal_x, normal_y, normal_z

/** Where the points of a cloud keep a vector: lets compiled code read and write any point type. */
class VectorLayout
{
public:
  enum class Scalar
  {
    FLOAT32,
    FLOAT64
  };

  using Offsets = std::array<std::size_t, 3>;

  /** \param[in] stride bytes from one point to the next
    * \param[in] offsets bytes from the begin of a point to its three numbers */
  VectorLayout (std::size_t stride, const Offsets& offsets, Scalar scalar)
  : stride_ (stride), offsets_ (offsets), scalar_ (scalar)
  {}

  /** The three fields \a X, \a Y, \a Z (pcl::fields::x ...) of a point type. */
  template <typename PointT, typename X, typename Y, typename Z>
  static VectorLayout
  ofFields ()
  {
    constexpr auto type = pcl::traits::datatype<PointT, X>::value;
    static_assert (type == pcl::PCLPointField::FLOAT32 || type == pcl::PCLPointField::FLOAT64,
                   "the coordinates must be float or double");
    return {sizeof (PointT),
            {pcl::traits::offset<PointT, X>::value, pcl::traits::offset<PointT, Y>::value,
             pcl::traits::offset<PointT, Z>::value},
            type == pcl::PCLPointField::FLOAT32 ? Scalar::FLOAT32 : Scalar::FLOAT64};
  }

  /** The fields called \a names; empty if one is missing, or they are not all float or all double. */
  static std::optional<VectorLayout>
  find (const pcl::PCLPointCloud2& cloud, const VectorFields& names);

  /** The same. \throw core::Error if find returns nothing: it names the available fields, and adds the \a advice */
  static VectorLayout
  require (const pcl::PCLPointCloud2& cloud, const VectorFields& names, const std::string& advice);

  Scalar
  scalar () const
  {
    return scalar_;
  }

  /** The vector of point \a i of the cloud that begins at \a data. */
  Eigen::Vector3d
  get (const std::uint8_t* data, std::size_t i) const
  {
    const std::uint8_t* const point = data + begin (i);
    return scalar_ == Scalar::FLOAT32 ? numbersAt<float> (point).template cast<double> () : numbersAt<double> (point);
  }

  /** \return whether the point can hold the value: false if a number is not finite, or too large for a float */
  bool
  set (std::uint8_t* data, std::size_t i, const Eigen::Vector3d& value) const
  {
    std::uint8_t* const point = data + begin (i);
    return scalar_ == Scalar::FLOAT32 ? putNumbers<float> (point, value.cast<float> ())
                                      : putNumbers<double> (point, value);
  }

  /** Tells the processor that point \a i will be needed soon. */
  void
  prefetch (const std::uint8_t* data, std::size_t i) const
  {
    __builtin_prefetch (data + begin (i) + offsets_[0], 1);
  }

private:
  template <typename Number>
  Eigen::Matrix<Number, 3, 1>
  numbersAt (const std::uint8_t* point) const
  {
    Eigen::Matrix<Number, 3, 1> numbers;
    for (std::size_t d = 0; d < 3; ++d)
      std::memcpy (numbers.data () + d, point + offsets_[d], sizeof (Number));
    return numbers;
  }

  template <typename Number>
  bool
  putNumbers (std::uint8_t* point, const Eigen::Matrix<Number, 3, 1>& numbers) const
  {
    for (std::size_t d = 0; d < 3; ++d)
      std::memcpy (point + offsets_[d], numbers.data () + d, sizeof (Number));
    return numbers.allFinite ();
  }

  std::size_t
  begin (std::size_t i) const
  {
    return width_ == 0 ? i * stride_ : i / width_ * row_step_ + i % width_ * stride_;
  }

  std::size_t stride_;
  Offsets offsets_;
  Scalar scalar_;
  std::size_t width_ = 0; // of rows that are followed by padding; 0: none are
  std::size_t row_step_ = 0;
};

/** The layout of x, y, z of a point type. */
template <typename PointT>
VectorLayout
positionLayout ()
{
  return VectorLayout::ofFields<PointT, pcl::fields::x, pcl::fields::y, pcl::fields::z> ();
}

/** The layout of normal_x, normal_y, normal_z of a point type. */
template <typename PointT>
VectorLayout
normalLayout ()
{
  return VectorLayout::ofFields<PointT, pcl::fields::normal_x, pcl::fields::normal_y, pcl::fields::normal_z> ();
}

/** Read access to a vector of every point of a cloud. */
struct VectorView
{
  VectorLayout layout;
  const std::uint8_t* data;
  std::size_t size;
};

template <typename PointT>
VectorView
positionsOf (const pcl::PointCloud<PointT>& cloud)
{
  return {positionLayout<PointT> (), reinterpret_cast<const std::uint8_t*> (cloud.data ()), cloud.size ()};
}

template <typename PointT>
VectorView
normalsOf (const pcl::PointCloud<PointT>& cloud)
{
  return {normalLayout<PointT> (), reinterpret_cast<const std::uint8_t*> (cloud.data ()), cloud.size ()};
}

/** The unit in which the kernels can process a cloud: 1, or, if the median distance of its points from the middle
  * one is below 2^-20 or above 2^20, a power of two of that size. */
double
unitOf (const VectorView& positions);

/** The points of a cloud of \a size that determine its unit, some hundreds; and the unit from the finite ones among
  * them: for a cloud that is never in memory as a whole. */
std::vector<std::uint64_t>
unitSample (std::uint64_t size);

double
unitOf (const std::vector<Eigen::Vector3d>& sample);

/** The positions in the unit unitOf (\a positions). */
core::Positions
readPositions (const VectorView& positions, const core::Execution& execution = core::Execution (1));

/** The positions in a given \a unit, that of another cloud. */
core::Positions
readPositions (const VectorView& positions, double unit, const core::Execution& execution = core::Execution (1));

/** The normals of the points named by \a order, normalised; NaN if one is not finite or zero. */
core::Vectors
readNormals (const VectorView& normals,
             const core::Elements& order,
             const core::Execution& execution = core::Execution (1));

/** Marks those of \a size points that \a indices names.
  * \throw core::Error if an index is out of range */
std::vector<bool>
selectPoints (const pcl::Indices& indices, std::size_t size);

/** Adds the displacements of nodes to the positions of the selected points of a cloud; a point that has not moved keeps
  * its bits.
  * \param[in] unit of the displacements, see core::Positions
  * \param[in] order the point of every node
  * \throw core::Error if the point type cannot hold a new position; some points are already written then */
void
writeDisplacements (const core::Vectors& displacements,
                    double unit,
                    const core::Elements& order,
                    const std::vector<bool>& selected,
                    const VectorLayout& layout,
                    std::uint8_t* data,
                    const core::Execution& execution = core::Execution (1));

/** Writes the normals of the nodes to the selected points; if a node has none (NaN), the point keeps its own. */
void
writeNormals (const core::Vectors& normals,
              const core::Elements& order,
              const std::vector<bool>& selected,
              const VectorLayout& layout,
              std::uint8_t* data,
              const core::Execution& execution = core::Execution (1));
} // namespace pcl_normal_smoothing
