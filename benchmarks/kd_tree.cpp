// SPDX-License-Identifier: BSD-3-Clause
#include "kd_tree.h"

#include <pcl/search/kdtree.h>

namespace pcl_normal_smoothing::benchmarks
{
void
searchByKdTree (const Cloud::Ptr& cloud, int k, int threads)
{
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud);
#pragma omp parallel num_threads(threads)
  {
    pcl::Indices indices;
    std::vector<float> sq_dists;
#pragma omp for schedule(dynamic, 256)
    for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t> (cloud->size ()); ++i)
      tree.nearestKSearch (static_cast<int> (i), k, indices, sq_dists);
  }
}
} // namespace pcl_normal_smoothing::benchmarks
