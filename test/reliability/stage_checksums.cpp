// SPDX-License-Identifier: BSD-3-Clause
//
// usage: stage_checksums threads
// Prints a checksum of the result of every stage, one per line. check_same_bits.cmake runs it with different numbers of
// threads and schedules, and compares.
#include "shapes.h"

#include <pcl_normal_smoothing/bilateral_normal_filter.h>
#include <pcl_normal_smoothing/hough_normal_estimation.h>
#include <pcl_normal_smoothing/neighbor_graph.h>
#include <pcl_normal_smoothing/normal_guided_point_update.h>
#include <pcl_normal_smoothing/normal_smoothing.h>
#include <pcl_normal_smoothing/surface_noise_estimation.h>
#include <pcl_normal_smoothing/wpca_normal_estimation.h>

#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace
{
using namespace pcl_normal_smoothing;
using Cloud = pcl::PointCloud<pcl::PointNormal>;

constexpr int k = 12;
unsigned threads = 0;

/** FNV-1a over the bits of some numbers. */
class Checksum
{
public:
  void
  add (const float* numbers, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t bits;
      std::memcpy (&bits, numbers + i, sizeof bits);
      value_ = (value_ ^ bits) * 1099511628211u;
    }
  }

  void
  print (const char* stage) const
  {
    std::printf ("%-28s %016llx\n", stage, static_cast<unsigned long long> (value_));
  }

private:
  std::uint64_t value_ = 14695981039346656037u;
};

void
print (const char* stage, const Cloud& cloud)
{
  Checksum checksum;
  for (const auto& point : cloud) {
    checksum.add (point.data, 3);
    checksum.add (point.normal, 3);
    checksum.add (&point.curvature, 1);
  }
  checksum.print (stage);
}

/** A noisy torus with difficult points: duplicate, non-finite and isolated ones. */
Cloud::Ptr
hardCloud ()
{
  const test_support::Shape shape = test_support::torus (9000, 1, 0.4);
  const auto points = test_support::withNoise (shape.points, 0.01, 400);
  auto cloud = std::make_shared<Cloud> ();
  for (std::size_t i = 0; i < points.size (); ++i) {
    pcl::PointNormal point;
    point.getVector3fMap () = points[i % 50 == 7 ? i - 1 : i];
    point.getNormalVector3fMap () = (i % 3 == 0 ? -1 : 1) * shape.normals[i];
    point.curvature = 0;
    if (i % 200 == 3)
      point.y = std::numeric_limits<float>::quiet_NaN ();
    if (i % 1000 == 11)
      point.getVector3fMap () *= 3;
    cloud->push_back (point);
  }
  return cloud;
}

template <typename FilterT>
Cloud
filtered (FilterT& filter, const Cloud::Ptr& cloud)
{
  Cloud output;
  filter.setInputCloud (cloud);
  filter.setKSearch (k);
  filter.setNumberOfThreads (threads);
  filter.filter (output);
  return output;
}

template <typename FeatureT>
void
printNormals (const char* stage, const Cloud::Ptr& cloud)
{
  FeatureT feature;
  feature.setInputCloud (cloud);
  feature.setKSearch (k);
  feature.setNumberOfThreads (threads);
  Cloud output;
  feature.compute (output);
  print (stage, output);
}

void
printStages (const Cloud::Ptr& cloud)
{
  const auto graph = buildNeighborGraph<pcl::PointNormal> (cloud, k, 0, nullptr, threads);
  Checksum rows;
  for (std::size_t node = 0; node < graph->size (); ++node) {
    const auto row = graph->row (node);
    for (std::size_t j = 0; j < row.size (); ++j) {
      const auto index = static_cast<float> (graph->order ()[row[j]]);
      rows.add (&index, 1);
    }
  }
  rows.print ("neighbours");
  printNormals<WPCANormalEstimation<pcl::PointNormal, pcl::PointNormal>> ("WPCA normals", cloud);
  printNormals<HoughNormalEstimation<pcl::PointNormal, pcl::PointNormal>> ("Hough normals", cloud);

  SurfaceNoiseEstimation<pcl::PointNormal> noise;
  noise.setInputCloud (cloud);
  noise.setNumberOfThreads (threads);
  noise.compute ();
  const float numbers[] = {static_cast<float> (noise.getSigma ()), static_cast<float> (noise.getSpacing ())};
  Checksum estimate;
  estimate.add (numbers, 2);
  estimate.print ("noise estimate");

  for (const auto weight : {NormalWeight::THRESHOLD, NormalWeight::GAUSSIAN, NormalWeight::MIXED}) {
    BilateralNormalFilter<pcl::PointNormal> filter;
    filter.setNormalWeight (weight);
    print ("filtered normals", filtered (filter, cloud));
  }
  for (const auto rule : {UpdateRule::PAPER, UpdateRule::COMPENSATED})
    for (const int interval : {0, 1}) {
      NormalGuidedPointUpdate<pcl::PointNormal> update;
      update.setUpdateRule (rule);
      update.setSearchInterval (interval);
      print ("moved points", filtered (update, cloud));
    }
}

void
printWhole (const Cloud::Ptr& cloud)
{
  for (const auto preset : {SmoothingPreset::DEFAULT, SmoothingPreset::FAST, SmoothingPreset::PAPER}) {
    NormalSmoothing<pcl::PointNormal> smoothing;
    smoothing.setPreset (preset);
    const Cloud whole = filtered (smoothing, cloud);
    print ("smoothing", whole);

    // The input is split by indices; the results of the parts must add up to the whole.
    Cloud together = *cloud;
    for (std::size_t part = 0; part < 3; ++part) {
      auto indices = std::make_shared<pcl::Indices> ();
      for (std::size_t i = part; i < cloud->size (); i += 3)
        indices->push_back (static_cast<pcl::index_t> (i));
      smoothing.setIndices (indices);
      const Cloud output = filtered (smoothing, cloud);
      for (const auto i : *indices)
        together[i] = output[i];
    }
    print ("smoothing", together);
  }
}

/** Compares search objects, on a cloud without duplicates, as they may break ties arbitrarily. */
void
printSearches ()
{
  const test_support::Shape shape = test_support::torus (3000, 1, 0.4);
  const auto points = test_support::withNoise (shape.points, 0.01, 401);
  auto cloud = std::make_shared<Cloud> ();
  for (const auto& position : points) {
    cloud->emplace_back ();
    cloud->back ().getVector3fMap () = position;
  }
  for (const pcl::search::Search<pcl::PointNormal>::Ptr& search :
       {pcl::search::Search<pcl::PointNormal>::Ptr (),
        pcl::search::Search<pcl::PointNormal>::Ptr (new pcl::search::KdTree<pcl::PointNormal>),
        pcl::search::Search<pcl::PointNormal>::Ptr (new pcl::search::Octree<pcl::PointNormal> (0.05))}) {
    NormalSmoothing<pcl::PointNormal> smoothing;
    smoothing.setSearchMethod (search);
    print ("any search object", filtered (smoothing, cloud));
  }
}
} // namespace

int
main (int argc, char** argv)
{
  threads = argc > 1 ? static_cast<unsigned> (std::atoi (argv[1])) : 0;
  const Cloud::Ptr cloud = hardCloud ();
  printStages (cloud);
  printWhole (cloud);
  printSearches ();
}
