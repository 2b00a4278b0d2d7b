// SPDX-License-Identifier: BSD-3-Clause
//
// Compares the time of the whole smoothing with that of what PCL users already pay for: all timed in turns, in one
// run on one cloud in random order. Prints a table of ratios, and the accuracy:
// ./ratios [points] [repetitions] [points of the large cloud, 0 = none]
#include "kd_tree.h"
#include "timing.h"

#include <pcl_normal_smoothing/neighbor_graph.h>
#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/features/normal_3d_omp.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/mls.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <thread>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::benchmarks;

const int cores = static_cast<int> (std::max (1u, std::thread::hardware_concurrency ()));

Cloud
smooth (const Cloud::Ptr& cloud, SmoothingPreset preset, unsigned threads = 0)
{
  NormalSmoothing<pcl::PointXYZ> smoothing;
  smoothing.setPreset (preset);
  smoothing.setNumberOfThreads (threads);
  smoothing.setInputCloud (cloud);
  Cloud smoothed;
  smoothing.filter (smoothed);
  return smoothed;
}

void
estimateNormals (const Cloud::Ptr& cloud)
{
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setKSearch (16);
  estimation.setInputCloud (cloud);
  pcl::PointCloud<pcl::Normal> normals;
  estimation.compute (normals);
}

/** Moving least squares with a radius that holds about 16 neighbours. */
Cloud
moveByLeastSquares (const Cloud::Ptr& cloud)
{
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointXYZ> mls;
  mls.setInputCloud (cloud);
  mls.setSearchMethod (pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>> ());
  mls.setSearchRadius (spacingOf (cloud->size ()) * std::sqrt (16 / M_PI));
  mls.setPolynomialOrder (2);
  mls.setNumberOfThreads (static_cast<unsigned> (cores));
  Cloud moved;
  mls.process (moved);
  return moved;
}

void
searchByGraph (const Cloud::Ptr& cloud)
{
  buildNeighborGraph<pcl::PointXYZ> (cloud, 16);
}

/** \param[in] goal upper bound that the ratio should meet; printed, not checked */
void
printRow (const std::string& what, double measured, double goal)
{
  std::printf ("| %s | %.3g | %.3g |\n", what.c_str (), measured, goal);
}

struct Times
{
  std::vector<double> smoothing[2], one_thread, normals, tree, graph;
};

Times
takeTurns (const Cloud::Ptr& cloud, int repetitions)
{
  Times times;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    times.normals.push_back (seconds ([&] { estimateNormals (cloud); }));
    times.smoothing[0].push_back (seconds ([&] { smooth (cloud, SmoothingPreset::DEFAULT); }));
    times.smoothing[1].push_back (seconds ([&] { smooth (cloud, SmoothingPreset::FAST); }));
    times.one_thread.push_back (seconds ([&] { smooth (cloud, SmoothingPreset::DEFAULT, 1); }));
    times.tree.push_back (seconds ([&] { searchByKdTree (cloud, 16, cores); }));
    times.graph.push_back (seconds ([&] { searchByGraph (cloud); }));
  }
  return times;
}

/** Seconds per point of the preset fast. */
double
secondsPerPoint (const Cloud::Ptr& cloud)
{
  return seconds ([&] { smooth (cloud, SmoothingPreset::FAST); }) / static_cast<double> (cloud->size ());
}
} // namespace

int
main (int argc, char** argv)
{
  const std::size_t size = argc > 1 ? std::stoul (argv[1]) : 1000000, large = argc > 3 ? std::stoul (argv[3]) : 0;
  const Cloud::Ptr cloud = makeTorus (size, Order::RANDOM);
  const Times times = takeTurns (cloud, argc > 2 ? std::stoi (argv[2]) : 3);
  Cloud moved;
  const double mls = seconds ([&] { moved = moveByLeastSquares (cloud); });
  const double normals = median (times.normals), by_default = median (times.smoothing[0]),
               fast = median (times.smoothing[1]);

  std::printf ("%zu points in random order, %d threads\n\n| what | measured | goal |\n|---|---|---|\n", size, cores);
  printRow ("preset fast / NormalEstimationOMP, k = 16", fast / normals, .3);
  printRow ("preset default / NormalEstimationOMP", by_default / normals, 1);
  printRow ("preset fast / MovingLeastSquares, order 2", fast / mls, .2);
  printRow ("neighbour graph / pcl::search::KdTree", median (times.graph) / median (times.tree), .25);
  printRow ("all threads / one, preset default", by_default / median (times.one_thread), .55);
  if (large > 0) {
    const double small_seconds = secondsPerPoint (cloud);
    printRow (std::to_string (large) + " points, time a point / at " + std::to_string (size),
              secondsPerPoint (makeTorus (large, Order::RANDOM)) / small_seconds, 1.25);
  }

  const double noisy = meanDistance (*cloud);
  std::printf ("\n| accuracy | p2s ratio | seconds |\n|---|---|---|\n");
  std::printf ("| preset default | %.3f | %.2f |\n", meanDistance (smooth (cloud, SmoothingPreset::DEFAULT)) / noisy,
               by_default);
  std::printf ("| preset fast | %.3f | %.2f |\n", meanDistance (smooth (cloud, SmoothingPreset::FAST)) / noisy, fast);
  std::printf ("| MovingLeastSquares | %.3f | %.2f |\n", meanDistance (moved) / noisy, mls);
  std::printf ("| NormalEstimationOMP alone | 1 | %.2f |\n", normals);
}
