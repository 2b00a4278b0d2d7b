// SPDX-License-Identifier: BSD-3-Clause
#include "feature_fixture.h"
#include "searches.h"

#include <pcl_normal_smoothing/neighbor_graph.h>

#include <pcl/features/normal_3d.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace test_support;
using pcl_normal_smoothing::buildNeighborGraph;

/** For tests of the search and the run, which do not depend on the point types. */
template <typename FeatureT>
class FeatureRun : public FeatureTest<FeatureT>
{
protected:
  FeatureRun () : FeatureTest<FeatureT> (3000) {}
};

TYPED_TEST_SUITE (FeatureRun, OneOfEachFeature);

TYPED_TEST (FeatureRun, IsTheSameBitForBitForAnyNumberOfThreads)
{
  TypeParam feature;
  this->prepare (feature);
  feature.setNumberOfThreads (1);
  const auto one = this->run (feature);
  for (const unsigned threads : {0u, 2u, 3u, 4u}) {
    feature.setNumberOfThreads (threads);
    this->expectSameNormals (this->run (feature), one);
  }
}

TYPED_TEST (FeatureRun, ReportsProgressThatNeverFallsAndEndsAtOne)
{
  for (const unsigned threads : {1u, 2u, 4u})
    for (const bool by_queries : {false, true}) {
      TypeParam feature;
      this->prepare (feature);
      feature.setNumberOfThreads (threads);
      if (by_queries)
        feature.setSearchSurface (this->cloud_);
      std::vector<double> shares;
      feature.setProgressCallback ([&] (double share) {
        shares.push_back (share);
        return true;
      });
      this->run (feature);
      ASSERT_GT (shares.size (), 1u);
      EXPECT_TRUE (std::is_sorted (shares.begin (), shares.end ()));
      EXPECT_NEAR (shares.back (), 1, 1e-12);
    }
}

TYPED_TEST (FeatureRun, CancelledItsOutputIsEmpty)
{
  for (const double at : {0.0, 0.5, 0.95}) {
    TypeParam feature;
    this->prepare (feature);
    feature.setProgressCallback ([=] (double share) { return share < at; });
    auto output = poisonedCloud<pcl::Normal> ();
    feature.compute (output);
    EXPECT_TRUE (feature.wasCancelled ());
    EXPECT_TRUE (contains (feature.getErrorMessage (), "cancelled"));
    expectEmpty (output);
    feature.setProgressCallback ({});
    this->expectSameNormals (this->run (feature), this->result ());
  }
}

TYPED_TEST (FeatureRun, EverySearchObjectGivesTheSame)
{
  const auto by_k = this->result ();
  auto some = std::make_shared<pcl::Indices> (pcl::Indices {5, 2999, 1000});
  for (const auto& search : userSearches<pcl::PointXYZ> ()) {
    SCOPED_TRACE (search->getName ());
    TypeParam feature;
    this->prepare (feature);
    feature.setSearchMethod (search);
    this->expectSameNormals (this->run (feature), by_k);
    feature.setIndices (some);
    const auto of_some = this->run (feature);
    for (std::size_t i = 0; i < some->size (); ++i)
      EXPECT_TRUE (this->sameNormal (of_some[i], by_k[(*some)[i]])) << "output " << i;
  }
  TypeParam feature;
  this->prepare (feature);
  feature.setSearchMethod (std::make_shared<ThrowingSearch<pcl::PointXYZ>> ());
  this->expectError (feature, "the index is corrupt");
  feature.setIndices (some);
  this->expectError (feature, "the index is corrupt");
}

TYPED_TEST (FeatureRun, APointMovedBehindItsPointerIsFoundWhereItIs)
{
  TypeParam feature;
  this->prepare (feature);
  auto search = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>> ();
  feature.setSearchMethod (search);
  this->run (feature);
  for (std::size_t i = 0; i < this->cloud_->size (); ++i)
    (*this->cloud_)[i].getVector3fMap () = this->shape_.points[(i + 1500) % 3000];
  this->expectSameNormals (this->run (feature), this->result ());
}

TYPED_TEST (FeatureRun, ASharedGraphGivesTheSameAndOneOfAnotherCloudIsRefused)
{
  TypeParam feature;
  this->prepare (feature);
  feature.setKSearch (0); // neither k nor a radius is set: the graph suffices
  feature.setNeighborGraph (buildNeighborGraph<pcl::PointXYZ> (this->cloud_, 10));
  const auto full = this->run (feature);
  this->expectSameNormals (full, this->result ());
  feature.setIndices (std::make_shared<pcl::Indices> (pcl::Indices {2999, 4}));
  const auto some = this->run (feature);
  ASSERT_EQ (some.size (), 2u);
  EXPECT_TRUE (this->sameNormal (some[0], full[2999]) && this->sameNormal (some[1], full[4]));

  feature.setSearchSurface (this->cloud_);
  this->expectError (feature, "search surface");
  feature.setSearchSurface (nullptr);
  const Shape ball = sphere (77, 1);
  feature.setNeighborGraph (
      buildNeighborGraph<pcl::PointXYZ> (makeCloud<pcl::PointXYZ> (ball.points, ball.normals), 10));
  this->expectError (feature, "77");
}

TYPED_TEST (FeatureRun, WorksWhereAnyFeatureDoes)
{
  const typename pcl::Feature<pcl::PointXYZ, pcl::Normal>::Ptr feature = std::make_shared<TypeParam> ();
  feature->setInputCloud (this->cloud_);
  feature->setSearchMethod (std::make_shared<pcl::search::KdTree<pcl::PointXYZ>> ());
  feature->setRadiusSearch (0.2);
  auto output = poisonedCloud<pcl::Normal> ();
  feature->compute (output);
  ASSERT_EQ (output.size (), this->cloud_->size ());

  // Oriented as by pcl::NormalEstimation.
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> pcl_estimation;
  pcl_estimation.setInputCloud (this->cloud_);
  pcl_estimation.setSearchMethod (std::make_shared<pcl::search::KdTree<pcl::PointXYZ>> ());
  pcl_estimation.setRadiusSearch (0.2);
  pcl::PointCloud<pcl::Normal> expected;
  pcl_estimation.compute (expected);
  std::size_t same_side = 0;
  for (std::size_t i = 0; i < output.size (); ++i)
    same_side += output[i].getNormalVector3fMap ().dot (expected[i].getNormalVector3fMap ()) > 0.7f;
  EXPECT_GT (same_side, output.size () * 98 / 100); // near the silhouette, the two may differ
}

TEST (HoughNormalEstimation, IsTheSameForTheSameSeedAndAnotherForAnother)
{
  const Shape shape = cube (12, 1);
  pcl_normal_smoothing::HoughNormalEstimation<pcl::PointXYZ, pcl::Normal> hough;
  hough.setInputCloud (makeCloud<pcl::PointXYZ> (withNoise (shape.points, 0.01, 140), shape.normals));
  hough.setKSearch (20);
  const auto run = [&] (std::uint64_t seed) {
    hough.setSeed (seed);
    EXPECT_EQ (hough.getSeed (), seed);
    pcl::PointCloud<pcl::Normal> normals;
    hough.compute (normals);
    std::vector<float> xs;
    for (const auto& normal : normals)
      xs.push_back (normal.normal_x);
    return xs;
  };
  const auto first = run (1);
  EXPECT_EQ (run (1), first);
  EXPECT_NE (run (2), first);
}
} // namespace
