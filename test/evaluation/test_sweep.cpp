// SPDX-License-Identifier: BSD-3-Clause
#include "meshes/mesh_measures.h"
#include "meshes/surface_noise.h"
#include "models/made_models.h"
#include "sweep/sweep.h"

#include <pcl_normal_smoothing/normal_smoothing.h>

#include <gtest/gtest.h>

#include <set>

using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::evaluation;

namespace
{
const tools::Points&
noisyTorus ()
{
  static const tools::Points points = [] {
    const Model model = makeModel ("double_torus");
    return tools::noisyVertices (model.mesh, tools::NoiseType::GR, 0.2 * tools::meanEdgeLength (model.mesh), 1);
  }();
  return points;
}

/** The result of the class NormalSmoothing for the torus. */
pcl::PointCloud<pcl::PointNormal>
smoothedByTheClass (const Combination& combination)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointNormal>> ();
  for (const Eigen::Vector3d& p : noisyTorus ()) {
    cloud->emplace_back ();
    cloud->back ().getVector3fMap () = p.cast<float> ();
  }
  NormalSmoothing<pcl::PointNormal> smoothing;
  smoothing.setPreset (SmoothingPreset::PAPER);
  smoothing.setNormalSource (combination.source);
  smoothing.setNormalWeight (combination.weight);
  smoothing.setKSearch (combination.k);
  smoothing.setNormalIterations (combination.normal_iterations);
  smoothing.setPointIterations (combination.point_iterations);
  smoothing.setInputCloud (cloud);
  pcl::PointCloud<pcl::PointNormal> smoothed;
  smoothing.filter (smoothed);
  return smoothed;
}

void
expectSameBits (const Combination& combination, const Smoothed& smoothed)
{
  const auto expected = smoothedByTheClass (combination);
  ASSERT_EQ (smoothed.points.size (), expected.size ());
  for (std::size_t i = 0; i < expected.size (); ++i) {
    ASSERT_EQ (smoothed.points[i], Eigen::Vector3d (expected[i].getVector3fMap ().cast<double> ()))
        << combination.parameters () << " point " << i;
    ASSERT_EQ (smoothed.normals[i], Eigen::Vector3d (expected[i].getNormalVector3fMap ().cast<double> ()))
        << combination.parameters () << " normal " << i;
  }
}
} // namespace

TEST (Combinations, AreThePapers540)
{
  std::set<std::string> parameters, names;
  for (const Combination& combination : allCombinations ()) {
    parameters.insert (combination.parameters ());
    names.insert (combination.name ());
  }
  EXPECT_EQ (parameters.size (), 540u);
  EXPECT_EQ (names.size (), 27u);
  for (const char* name : {"PTU7", "WPGU21", "HMU15", "HTU21"})
    EXPECT_EQ (names.count (name), 1u) << name;
  EXPECT_EQ ((Combination {NormalSource::HOUGH, NormalWeight::MIXED, 15, 32, 40}.parameters ()),
             "-preset paper -normals hough -weights mixed -k 15 -normal_iterations 32 -point_iterations 40");
}

TEST (Sweep, GivesTheBitsOfTheClass)
{
  const std::vector<Combination> all = allCombinations ();
  std::vector<Combination> some; // from different methods: some share much work, some little
  for (std::size_t method = 0; method < all.size (); method += 5 * 20)
    for (const std::size_t i : {0, 2, 5, 19})
      some.push_back (all[method + i]);
  std::set<std::string> seen;
  Sweep (noisyTorus ()).run (some, [&] (const Combination& combination, const Smoothed& smoothed) {
    expectSameBits (combination, smoothed);
    EXPECT_GT (smoothed.seconds, 0);
    EXPECT_TRUE (seen.insert (combination.parameters ()).second);
  });
  EXPECT_EQ (seen.size (), some.size ());
}

TEST (Sweep, SharesIterationsOfOneWeightOnly)
{
  const Combination few {NormalSource::WPCA, NormalWeight::THRESHOLD, 7, 2, 5},
      more {NormalSource::WPCA, NormalWeight::GAUSSIAN, 7, 4, 10},
      most {NormalSource::WPCA, NormalWeight::GAUSSIAN, 7, 8, 5};
  int count = 0;
  Sweep (noisyTorus ()).run ({most, few, more}, [&] (const Combination& combination, const Smoothed& smoothed) {
    expectSameBits (combination, smoothed);
    ++count;
  });
  EXPECT_EQ (count, 3);
}
