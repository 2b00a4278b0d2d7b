// SPDX-License-Identifier: BSD-3-Clause
#include "own_parameters.h"

#include <pcl/search/kdtree.h>

namespace
{
using namespace test_support;
using namespace pcl_normal_smoothing;

using Bilateral = BilateralNormalFilter<pcl::PointNormal>;
using Update = NormalGuidedPointUpdate<pcl::PointNormal>;

class BilateralParameters : public OwnParameters<Bilateral>
{};
class UpdateParameters : public OwnParameters<Update>
{};

TEST_F (BilateralParameters, EachHasItsEffect)
{
  const auto gaussian = [] (Bilateral& filter) {
    filter.setNormalWeight (NormalWeight::GAUSSIAN);
    filter.setSigmaS (0.3);
    filter.setMaxIterations (4);
    filter.setNormalsOriented (false);
  };
  expectEffect ([] (auto& filter) { filter.setSigmaS (0.5); }, gaussian);
  expectEffect ([] (auto& filter) { filter.setMaxIterations (2); }, gaussian);
  expectEffect ([] (auto& filter) { filter.setNormalsOriented (true); }, gaussian);
  expectEffect ([] (auto& filter) { filter.setNormalWeight (NormalWeight::MIXED); }, gaussian);
  expectEffect ([] (auto& filter) { filter.setThreshold (0.9); },
                [] (auto& filter) {
                  filter.setNormalWeight (NormalWeight::THRESHOLD);
                  filter.setThreshold (0.65);
                });
  expectEffect ([] (auto& filter) { filter.setMixedThreshold (MixedThreshold::RMS); },
                [] (auto& filter) {
                  filter.setNormalWeight (NormalWeight::MIXED);
                  filter.setMixedThreshold (MixedThreshold::PRINTED);
                });
}

TEST_F (BilateralParameters, NoIterationCopiesTheInput)
{
  Bilateral filter;
  prepare (filter);
  filter.setMaxIterations (0);
  const auto output = run (filter);
  for (std::size_t i = 0; i < output.size (); ++i)
    EXPECT_LT ((output[i].getNormalVector3fMap () - normals_[i].normalized ()).norm (), 1e-6) << "point " << i;
}

TEST_F (BilateralParameters, OutOfRangeTheyAreRefused)
{
  expectRefused ([] (auto& filter) { filter.setMaxIterations (-7); }, "-7");
  expectRefused ([] (auto& filter) { filter.setThreshold (1.5); }, "1.5");
  expectRefused ([] (auto& filter) { filter.setThreshold (-0.5); }, "-0.5");
}

TEST_F (BilateralParameters, InputNormalsComeFirstAndMayHaveACloudOfTheirOwn)
{
  Bilateral filter;
  prepare (filter);
  filter.setInputNormals (makeNormals (Vectors (300, Eigen::Vector3f::UnitX ())));
  for (const auto& point : run (filter))
    EXPECT_EQ (point.getNormalVector3fMap (), Eigen::Vector3f::UnitX ());

  BilateralNormalFilter<pcl::PointXYZ> without;
  without.setInputCloud (makeCloud<pcl::PointXYZ> (points_, normals_));
  without.setKSearch (10);
  NormalCloud normals = poisonedCloud<pcl::Normal> ();
  without.filterNormals (normals);
  EXPECT_TRUE (normals.empty ());
  EXPECT_TRUE (contains (without.getErrorMessage (), "setInputNormals"));
  without.setInputNormals (makeNormals (normals_));
  normals = poisonedCloud<pcl::Normal> ();
  without.filterNormals (normals);
  const auto expected = result ();
  ASSERT_EQ (normals.size (), expected.size ());
  for (std::size_t i = 0; i < normals.size (); ++i)
    EXPECT_EQ (normals[i].getNormalVector3fMap (), expected[i].getNormalVector3fMap ()) << "point " << i;

  // The points have no normals to write to, and the error says so.
  pcl::PointCloud<pcl::PointXYZ> output = poisonedCloud<pcl::PointXYZ> ();
  without.filter (output);
  expectEmpty (output);
  EXPECT_TRUE (contains (without.getErrorMessage (), "filterNormals")) << without.getErrorMessage ();
}

TEST_F (UpdateParameters, EachHasItsEffect)
{
  const auto defaults = [] (Update& filter) {
    filter.setUpdateRule (UpdateRule::COMPENSATED);
    filter.setSigmaS (0.1);
    filter.setMaxIterations (4);
    filter.setNormalsOriented (false);
    filter.setMaxDisplacement (1);
    filter.setSearchInterval (0);
  };
  expectEffect ([] (auto& filter) { filter.setUpdateRule (UpdateRule::PAPER); }, defaults);
  expectEffect ([] (auto& filter) { filter.setSigmaS (0.5); }, defaults);
  expectEffect ([] (auto& filter) { filter.setMaxIterations (2); }, defaults);
  expectEffect ([] (auto& filter) { filter.setNormalsOriented (true); }, defaults);
  expectEffect ([] (auto& filter) { filter.setMaxDisplacement (0.01); }, defaults);
  expectEffect ([] (auto& filter) { filter.setSearchInterval (1); }, defaults);
}

TEST_F (UpdateParameters, NoPointGoesFartherThanTheMaximum)
{
  Update filter;
  prepare (filter);
  filter.setMaxIterations (5);
  filter.setMaxDisplacement (0.01);
  const auto output = run (filter);
  for (std::size_t i = 0; i < output.size (); ++i)
    EXPECT_LE ((output[i].getVector3fMap () - points_[i]).norm (), 0.01 * 1.0001) << "point " << i;
}

TEST_F (UpdateParameters, ASearchIntervalWorksWithEverySearch)
{
  Update filter;
  prepare (filter);
  filter.setMaxIterations (3);
  filter.setSearchInterval (1);
  const auto expected = run (filter);
  auto search = std::make_shared<pcl::search::KdTree<pcl::PointNormal>> ();
  filter.setSearchMethod (search);
  const auto of_search = run (filter);
  for (std::size_t i = 0; i < expected.size (); ++i) // search objects get the positions in float
    EXPECT_LT ((of_search[i].getVector3fMap () - expected[i].getVector3fMap ()).norm (), 1e-5) << "point " << i;
  EXPECT_EQ (search->getInputCloud (), cloud_) << "the user's search must be left with the user's cloud";
}

TEST_F (UpdateParameters, OutOfRangeTheyAreRefused)
{
  expectRefused ([] (auto& filter) { filter.setMaxIterations (-7); }, "-7");
  expectRefused ([] (auto& filter) { filter.setSearchInterval (-2); }, "-2");
  expectRefused ([] (auto& filter) { filter.setMaxDisplacement (-0.5); }, "-0.5");
  expectRefused ([] (auto& filter) { filter.setMaxDisplacement (0); }, "is 0:");
}
} // namespace
