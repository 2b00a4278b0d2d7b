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
/** Names of three fields that are a vector. */
using VectorFields = std::array<std::string, 3>;

extern const VectorFields position_fields; //!< x, y, z
extern const VectorFields normal_fields;   //!< normal_x, normal_y, normal_z

/** Where the points of a cloud keep a vector: how compiled code reads and writes any point type. */
class VectorLayout
{
public:
  enum class Scalar
  {
    FLOAT32,
    FLOAT64
  };

  using Offsets = std::array<std::size_t, 3>;

  /** \param[in] stride bytes from a point to the next
    * \param[in] offsets bytes from a point's begin to its three numbers */
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

  /** The fields called \a names; nothing where one is missing, or they are not all float or all double. */
  static std::optional<VectorLayout>
  find (const pcl::PCLPointCloud2& cloud, const VectorFields& names);

  /** The same. \throw core::Error where find has nothing: it names the fields that there are, and tells the \a advice */
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

  /** \return whether the point can hold the value: false where a number is not finite, or too large for a float */
  bool
  set (std::uint8_t* data, std::size_t i, const Eigen::Vector3d& value) const
  {
    std::uint8_t* const point = data + begin (i);
    return scalar_ == Scalar::FLOAT32 ? putNumbers<float> (point, value.cast<float> ())
                                      : putNumbers<double> (point, value);
  }

  /** Tells the processor that point \a i is soon asked for. */
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
  std::size_t width_ = 0; // of rows with padding behind them; 0 = none have any
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

/** A vector of every point of a cloud, to read. */
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

/** The unit in which the kernels can work on a cloud: 1, or, where half of its points lie nearer to the middle one than
  * 2^-20 or farther than 2^20, a power of two of that size. */
double
unitOf (const VectorView& positions);

/** The points of a cloud of \a size that tell its unit, some hundreds, and the unit from those of them that are finite:
  * for a cloud that is nowhere as a whole. */
std::vector<std::uint64_t>
unitSample (std::uint64_t size);

double
unitOf (const std::vector<Eigen::Vector3d>& sample);

/** The positions in unitOf (\a positions). */
core::Positions
readPositions (const VectorView& positions, const core::Execution& execution = core::Execution (1));

/** The positions in that unit: of a cloud that belongs to another. */
core::Positions
readPositions (const VectorView& positions, double unit, const core::Execution& execution = core::Execution (1));

/** The normals of the points \a order names, at length 1; NaN where one is not finite or zero. */
core::Vectors
readNormals (const VectorView& normals,
             const core::Elements& order,
             const core::Execution& execution = core::Execution (1));

/** Which of \a size points \a indices names.
  * \throw core::Error where an index is out of range */
std::vector<bool>
selectPoints (const pcl::Indices& indices, std::size_t size);

/** Adds what nodes have moved to the positions of the selected points of a cloud; one that has not moved keeps its
  * bits.
  * \param[in] unit of the displacements, see core::Positions
  * \param[in] order the point of every node
  * \throw core::Error where a point would move to where its type has no numbers; some are written then */
void
writeDisplacements (const core::Vectors& displacements,
                    double unit,
                    const core::Elements& order,
                    const std::vector<bool>& selected,
                    const VectorLayout& layout,
                    std::uint8_t* data,
                    const core::Execution& execution = core::Execution (1));

/** Writes the normals of the nodes to the selected points; where a node has none (NaN) the point keeps its own. */
void
writeNormals (const core::Vectors& normals,
              const core::Elements& order,
              const std::vector<bool>& selected,
              const VectorLayout& layout,
              std::uint8_t* data,
              const core::Execution& execution = core::Execution (1));
} // namespace pcl_normal_smoothing
