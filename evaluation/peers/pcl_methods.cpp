// SPDX-License-Identifier: BSD-3-Clause
#include "lop.h"
#include "worker_methods.h"

#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/mls.h>

#include <thread>

namespace pcl_normal_smoothing::evaluation
{

WorkerPoints
smoothWithMovingLeastSquares (const WorkerPoints& points, const WorkerValues& values)
{
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  auto cloud = pcl::make_shared<Cloud> ();
  for (const auto& point : points) {
    const Eigen::Vector3f p = point.cast<float> ();
    cloud->push_back ({p.x (), p.y (), p.z ()});
  }
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointXYZ> mls;
  mls.setInputCloud (cloud);
  mls.setSearchMethod (pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>> ());
  mls.setSearchRadius (values.at ("radius"));
  mls.setPolynomialOrder (static_cast<int> (values.at ("order")));
  mls.setNumberOfThreads (std::max (1u, std::thread::hardware_concurrency ()));
  Cloud projected;
  mls.process (projected);
  WorkerPoints result = points;
  const pcl::Indices& origins = mls.getCorrespondingIndices ()->indices;
  for (std::size_t i = 0; i < projected.size (); ++i)
    result.at (origins.at (i)) = projected[i].getVector3fMap ().cast<double> ();
  return result;
}

WorkerPoints
smoothWithLop (const WorkerPoints& points, const WorkerValues& values)
{
  LopParameters parameters;
  parameters.h = values.at ("h");
  parameters.mu = values.at ("mu");
  parameters.iterations = static_cast<int> (values.at ("iterations"));
  return locallyOptimalProjection (points, parameters);
}

} // namespace pcl_normal_smoothing::evaluation
