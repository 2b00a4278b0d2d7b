// SPDX-License-Identifier: BSD-3-Clause
#include "worker_methods.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/compute_average_spacing.h>
#include <CGAL/jet_smooth_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <CGAL/wlop_simplify_and_regularize_point_set.h>

#include <iterator>
#include <stdexcept>
#include <tuple>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Concurrency = CGAL::Parallel_if_available_tag;
/** A point, its normal and its index, which is kept because CGAL shuffles and sorts points. */
using Item = std::tuple<Kernel::Point_3, Kernel::Vector_3, std::size_t>;
using PointMap = CGAL::Nth_of_tuple_property_map<0, Item>;
using NormalMap = CGAL::Nth_of_tuple_property_map<1, Item>;

std::vector<Item>
itemsOf (const WorkerPoints& points)
{
  std::vector<Item> items;
  for (const auto& point : points)
    items.emplace_back (Kernel::Point_3 (point.x (), point.y (), point.z ()), CGAL::NULL_VECTOR, items.size ());
  return items;
}

Eigen::Vector3d
asEigen (const Kernel::Point_3& point)
{
  return {point.x (), point.y (), point.z ()};
}

WorkerPoints
pointsOf (const std::vector<Item>& items)
{
  WorkerPoints points (items.size ());
  for (const auto& [point, normal, index] : items)
    points[index] = asEigen (point);
  return points;
}

unsigned
wholeNumber (const WorkerValues& values, const std::string& name)
{
  return static_cast<unsigned> (values.at (name));
}
} // namespace

double
averageSpacing (const WorkerPoints& points)
{
  constexpr unsigned one_ring = 6;
  return CGAL::compute_average_spacing<Concurrency> (itemsOf (points), one_ring,
                                                     CGAL::parameters::point_map (PointMap ()));
}

WorkerPoints
smoothWithWlop (const WorkerPoints& points, const WorkerValues& values)
{
  std::vector<Item> items = itemsOf (points);
  std::vector<Kernel::Point_3> projected;
  CGAL::wlop_simplify_and_regularize_point_set<Concurrency> (
      items, std::back_inserter (projected),
      CGAL::parameters::point_map (PointMap ())
          .select_percentage (100.)
          .neighbor_radius (values.at ("radius"))
          .number_of_iterations (wholeNumber (values, "iterations"))
          .require_uniform_sampling (values.at ("uniform") != 0));
  if (projected.size () != items.size ())
    throw std::runtime_error ("WLOP gave " + std::to_string (projected.size ()) + " of " +
                              std::to_string (items.size ()) + " points");
  // The sample is the end of the shuffled input, here all of it; WLOP keeps its order.
  for (std::size_t i = 0; i < items.size (); ++i)
    std::get<0> (items[i]) = projected[i];
  return pointsOf (items);
}

WorkerPoints
smoothWithJets (const WorkerPoints& points, const WorkerValues& values)
{
  std::vector<Item> items = itemsOf (points);
  CGAL::jet_smooth_point_set<Concurrency> (items, wholeNumber (values, "neighbors"),
                                           CGAL::parameters::point_map (PointMap ()));
  return pointsOf (items);
}

WorkerPoints
smoothBilaterally (const WorkerPoints& points, const WorkerValues& values)
{
  constexpr unsigned normal_neighbors = 18; // as in CGAL's examples
  std::vector<Item> items = itemsOf (points);
  const auto maps = CGAL::parameters::point_map (PointMap ()).normal_map (NormalMap ());
  CGAL::pca_estimate_normals<Concurrency> (items, normal_neighbors, maps);
  CGAL::mst_orient_normals (items, normal_neighbors, maps);
  for (unsigned i = 0; i < wholeNumber (values, "iterations"); ++i)
    CGAL::bilateral_smooth_point_set<Concurrency> (items, wholeNumber (values, "neighbors"),
                                                   CGAL::parameters::point_map (PointMap ())
                                                       .normal_map (NormalMap ())
                                                       .sharpness_angle (values.at ("sharpness angle")));
  return pointsOf (items);
}

} // namespace pcl_normal_smoothing::evaluation
