// SPDX-License-Identifier: BSD-3-Clause
#include "lop.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_types.h>

#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Point = Eigen::Vector3d;
using Points = std::vector<Point>;

/** Finds the points within a radius. The search is in single precision, the computations on its results in double. */
class BallSearch
{
public:
  explicit BallSearch (const Points& points) : points_ (points), tree_ (false)
  {
    auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> ();
    for (const Point& point : points)
      cloud->push_back (asPcl (point));
    tree_.setInputCloud (cloud);
  }

  /** Calls \a use (difference to \a center, distance) for every point within \a radius, except those at \a center. */
  template <typename Use>
  void
  around (const Point& center, double radius, const Use& use) const
  {
    pcl::Indices indices;
    std::vector<float> squared_distances;
    tree_.radiusSearch (asPcl (center), radius, indices, squared_distances);
    for (const auto index : indices) {
      const Point difference = points_[index] - center;
      const double distance = difference.norm ();
      if (distance > 0)
        use (difference, distance);
    }
  }

private:
  static pcl::PointXYZ
  asPcl (const Point& point)
  {
    const Eigen::Vector3f p = point.cast<float> ();
    return {p.x (), p.y (), p.z ()};
  }

  const Points& points_;
  pcl::KdTreeFLANN<pcl::PointXYZ> tree_;
};

/** A weighted mean of differences: the weighted sum over the sum of the weights. */
struct WeightedMean
{
  Point sum = Point::Zero ();
  double weights = 0;

  void
  add (double weight, const Point& difference)
  {
    sum += weight * difference;
    weights += weight;
  }

  Point
  value () const
  {
    return weights > 0 ? Point (sum / weights) : Point::Zero ();
  }
};

/** The fast decreasing weight theta of the paper. */
double
theta (double distance, double h)
{
  const double x = 4 * distance / h;
  return std::exp (-x * x);
}

/** X^(1): the mean of the surrounding points, weighted by theta. */
Point
firstPlace (const Point& x, const BallSearch& points, double h)
{
  WeightedMean mean;
  mean.add (1, Point::Zero ()); // the point itself
  points.around (x, h, [&] (const Point& to, double distance) { mean.add (theta (distance, h), to); });
  return x + mean.value ();
}

/** X^(k+1) from X^(k), one step of the fixed-point iteration: the weights alpha attract to the points, the weights beta
  * keep the projected points apart. */
Point
nextPlace (const Point& x, const BallSearch& points, const BallSearch& projected, const LopParameters& parameters)
{
  const double h = parameters.h;
  WeightedMean attraction;
  points.around (x, h, [&] (const Point& to, double distance) {
    const double alpha = theta (distance, h) / distance;
    attraction.add (alpha, to);
  });
  WeightedMean repulsion;
  projected.around (x, h, [&] (const Point& to, double distance) {
    const double squared = distance * distance;
    const double slope = 1 / (squared * squared); // of eta
    const double beta = theta (distance, h) / distance * slope;
    repulsion.add (beta, -to);
  });
  return x + attraction.value () + parameters.mu * repulsion.value ();
}
} // namespace

Points
locallyOptimalProjection (const Points& points, const LopParameters& parameters)
{
  const BallSearch input (points);
  const auto count = static_cast<std::ptrdiff_t> (points.size ());
  Points now = points, next = points;
  for (int k = 0; k < parameters.iterations; ++k) {
    const BallSearch projected (now);
#pragma omp parallel for schedule(dynamic, 256)
    for (std::ptrdiff_t i = 0; i < count; ++i)
      next[i] = k == 0 ? firstPlace (now[i], input, parameters.h) : nextPlace (now[i], input, projected, parameters);
    now.swap (next);
  }
  return now;
}

} // namespace pcl_normal_smoothing::evaluation
