// SPDX-License-Identifier: BSD-3-Clause
#include "filter_fixture.h"
#include "searches.h"

#include <pcl_normal_smoothing/neighbor_graph.h>

namespace
{
using namespace test_support;
using pcl_normal_smoothing::buildNeighborGraph;

template <typename FilterT>
class FilterSearch : public FilterTest<FilterT>
{};

TYPED_TEST_SUITE (FilterSearch, OneOfEachFilter);

TYPED_TEST (FilterSearch, EverySearchObjectGivesTheSame)
{
  using PointT = typename TestFixture::Point;
  const auto by_k = this->result ();
  TypeParam by_radius_filter;
  this->prepare (by_radius_filter);
  by_radius_filter.setKSearch (0);
  by_radius_filter.setRadiusSearch (0.35);
  const auto by_radius = this->run (by_radius_filter);
  for (const auto& search : userSearches<PointT> ()) {
    SCOPED_TRACE (search->getName ());
    TypeParam filter;
    this->prepare (filter);
    filter.setSearchMethod (search);
    expectSamePoints (this->run (filter), by_k);
    filter.setKSearch (0);
    filter.setRadiusSearch (0.35);
    expectSamePoints (this->run (filter), by_radius);
  }
}

TYPED_TEST (FilterSearch, EverySearchObjectLeavesOutPointsThatAreNotFinite)
{
  using PointT = typename TestFixture::Point;
  for (std::size_t i = 0; i < this->points_.size (); i += 9)
    (*this->cloud_)[i].y = nan_float;
  const auto expected = this->result ();
  for (const auto& search : userSearches<PointT> ()) {
    SCOPED_TRACE (search->getName ());
    TypeParam filter;
    this->prepare (filter);
    filter.setSearchMethod (search);
    expectSamePoints (this->run (filter), expected);
  }
}

TYPED_TEST (FilterSearch, TheMaximalDistanceLimitsK)
{
  using PointT = typename TestFixture::Point;
  TypeParam filter;
  this->prepare (filter);
  filter.setMaxNeighborDistance (0.2);
  const auto limited = this->run (filter);
  bool differs = false;
  const auto free = this->result ();
  for (std::size_t i = 0; i < free.size (); ++i)
    differs = differs || !samePoint (free[i], limited[i]);
  EXPECT_TRUE (differs);
  for (const auto& search : userSearches<PointT> ()) {
    filter.setSearchMethod (search);
    expectSamePoints (this->run (filter), limited);
  }
  filter.setMaxNeighborDistance (1e6);
  expectSamePoints (this->run (filter), free);
}

TYPED_TEST (FilterSearch, APointMovedBehindItsPointerIsFoundWhereItIs)
{
  using PointT = typename TestFixture::Point;
  for (const auto& search : userSearches<PointT> ()) {
    SCOPED_TRACE (search->getName ());
    TypeParam filter;
    this->prepare (filter);
    filter.setSearchMethod (search);
    search->setInputCloud (this->cloud_);
    this->run (filter);
    for (std::size_t i = 0; i < this->cloud_->size (); ++i) // swap the two halves
      (*this->cloud_)[i].getVector3fMap () = this->points_[(i + 150) % 300];
    const auto stale = this->run (filter);
    expectSamePoints (stale, this->result ());
  }
}

/** Some of PCL's searches find points exactly at the radius, others not. */
TYPED_TEST (FilterSearch, APointAtTheRadiusIsNoNeighbour)
{
  using PointT = typename TestFixture::Point;
  Vectors grid, up;
  for (int i = 0; i < 100; ++i) {
    grid.emplace_back (0.5f * static_cast<float> (i % 10), 0.5f * static_cast<float> (i / 10), 0.f);
    up.emplace_back (0.f, 0.f, 1.f);
  }
  const auto cloud = makeCloud<PointT> (grid, up);
  std::vector<typename pcl::search::Search<PointT>::Ptr> searches = userSearches<PointT> ();
  searches.push_back (nullptr);
  for (const auto& search : searches) {
    const auto graph = buildNeighborGraph<PointT> (cloud, 0, 0.5, search);
    for (std::uint32_t node = 0; node < graph->size (); ++node)
      EXPECT_EQ (graph->row (node).size (), 1u) << (search ? search->getName () : "own");
  }
}

TYPED_TEST (FilterSearch, AGraphOfNoCloudIsAnErrorThatNamesTheArgument)
{
  using PointT = typename TestFixture::Point;
  const auto messageOf = [] (const auto& cloud, int k, double radius) -> std::string {
    try {
      buildNeighborGraph<PointT> (cloud, k, radius);
      return "";
    }
    catch (const pcl_normal_smoothing::core::Error& error) {
      return error.what ();
    }
  };
  EXPECT_TRUE (contains (messageOf (typename TestFixture::CloudPtr (), 10, 0), "no cloud"));
  EXPECT_TRUE (contains (messageOf (this->cloud_, -5, 0), "the argument k"));
  EXPECT_TRUE (contains (messageOf (this->cloud_, 0, nan_float), "the argument radius"));
  EXPECT_TRUE (contains (messageOf (this->cloud_, 10, nan_float), "the argument radius"));
  EXPECT_TRUE (contains (messageOf (this->cloud_, 0, 0), "the argument k or the argument radius"));
}

TYPED_TEST (FilterSearch, ASearchIsGivenBackEvenAfterAnError)
{
  if constexpr (TestFixture::Traits::writes_points) {
    using PointT = typename TestFixture::Point;
    for (const int queries : {450, 1 << 30}) { // 300 of the first search, and half of the second one's
      TypeParam filter;
      this->prepare (filter);
      filter.setSearchInterval (1);
      const auto search = std::make_shared<TiringSearch<PointT>> (queries);
      filter.setSearchMethod (search);
      typename TestFixture::Cloud output;
      filter.filter (output);
      EXPECT_EQ (filter.getErrorMessage ().empty (), queries > 450);
      ASSERT_TRUE (search->getInputCloud ());
      for (std::size_t i = 0; i < this->points_.size (); ++i)
        ASSERT_EQ ((*search->getInputCloud ())[i].getVector3fMap (), (*this->cloud_)[i].getVector3fMap ());
    }
  }
}

TYPED_TEST (FilterSearch, ASearchThatThrowsIsAnError)
{
  TypeParam filter;
  this->prepare (filter);
  filter.setSearchMethod (std::make_shared<ThrowingSearch<typename TestFixture::Point>> ());
  this->expectError (filter, "the index is corrupt");
}

TYPED_TEST (FilterSearch, ASearchMayFindLessThanItWasGivenRoomFor)
{
  using PointT = typename TestFixture::Point;
  TypeParam filter;
  this->prepare (filter);
  filter.setKSearch (8);
  const auto expected = this->run (filter);
  filter.setKSearch (10);
  filter.setSearchMethod (std::make_shared<ShortSearch<PointT>> (8));
  expectSamePoints (this->run (filter), expected);
}

TYPED_TEST (FilterSearch, ASearchOfAnotherCloudIsAnError)
{
  TypeParam filter;
  this->prepare (filter);
  filter.setSearchMethod (std::make_shared<WrongSearch<typename TestFixture::Point>> ());
  this->expectError (filter, "300");
}

TYPED_TEST (FilterSearch, AnAbsurdKDoesNotTakeAbsurdMemory)
{
  using PointT = typename TestFixture::Point;
  TypeParam filter;
  this->prepare (filter);
  filter.setKSearch (300);
  const auto expected = this->run (filter);
  filter.setKSearch (2147483647);
  expectSamePoints (this->run (filter), expected);
  filter.setSearchMethod (std::make_shared<pcl::search::KdTree<PointT>> ());
  expectSamePoints (this->run (filter), expected);
}

TYPED_TEST (FilterSearch, ASharedGraphGivesTheSame)
{
  using PointT = typename TestFixture::Point;
  const auto graph = buildNeighborGraph<PointT> (this->cloud_, 10);
  for (const auto& shared :
       {graph, buildNeighborGraph<PointT> (this->cloud_, 10, 0, std::make_shared<pcl::search::KdTree<PointT>> ())}) {
    TypeParam filter;
    this->prepare (filter);
    filter.setKSearch (0);
    filter.setNeighborGraph (shared);
    EXPECT_EQ (filter.getNeighborGraph (), shared);
    expectSamePoints (this->run (filter), this->result ());
  }
}

TYPED_TEST (FilterSearch, WhereNeighboursAreSearchedAnewAGraphNeedsKBesides)
{
  if constexpr (TestFixture::Traits::writes_points) {
    using PointT = typename TestFixture::Point;
    TypeParam filter;
    this->prepare (filter);
    filter.setSearchInterval (1);
    const auto expected = this->run (filter);
    filter.setNeighborGraph (buildNeighborGraph<PointT> (this->cloud_, 10));
    expectSamePoints (this->run (filter), expected);
    filter.setKSearch (0);
    this->expectError (filter, "setSearchInterval (0)");
    filter.setRadiusSearch (0.35);
    this->run (filter);
  }
}

TYPED_TEST (FilterSearch, AGraphOfAnotherCloudIsRefused)
{
  using PointT = typename TestFixture::Point;
  const Shape ball = sphere (77, 1);
  TypeParam filter;
  this->prepare (filter);
  filter.setNeighborGraph (buildNeighborGraph<PointT> (makeCloud<PointT> (ball.points, ball.normals), 10));
  this->expectError (filter, "77");
  filter.setNeighborGraph (
      buildNeighborGraph<PointT> (makeCloud<PointT> ({{0, 0, 0}, {1, 0, 0}}, {{0, 0, 1}, {0, 0, 1}}), 2));
  this->expectError (filter, "a cloud of 2 points");

  filter.setNeighborGraph (buildNeighborGraph<PointT> (this->cloud_, 10));
  this->run (filter);
  (*this->cloud_)[123].z = nan_float;
  this->expectError (filter, "123");
  filter.setNeighborGraph (nullptr);
  this->run (filter);
}

/** The smallest k that NormalSmoothing accepts, for each of its methods. */
TEST (SmoothingK, TooSmallForAnyNormalOrQuadricItIsAnError)
{
  using Smoothing = pcl_normal_smoothing::NormalSmoothing<pcl::PointNormal>;
  using pcl_normal_smoothing::NormalSource;
  const Shape shape = torus (300, 1, 0.4);
  const auto cloud = makeCloud<pcl::PointNormal> (withNoise (shape.points, 0.03, 100), shape.normals);
  const auto messageFor = [&] (int k, const auto& set, const pcl_normal_smoothing::NeighborGraph::ConstPtr& graph) {
    Smoothing smoothing;
    smoothing.setInputCloud (cloud);
    smoothing.setKSearch (k);
    smoothing.setNeighborGraph (graph);
    set (smoothing);
    pcl::PointCloud<pcl::PointNormal> output;
    smoothing.filter (output);
    EXPECT_EQ (output.empty (), !smoothing.getErrorMessage ().empty ());
    return smoothing.getErrorMessage ();
  };
  const auto expectLeast = [&] (int least, const auto& set) {
    if (least > 1) {
      EXPECT_TRUE (contains (messageFor (least - 1, set, nullptr), "at least " + std::to_string (least))) << least;
    }
    EXPECT_EQ (messageFor (least, set, nullptr), "");
  };
  expectLeast (7, [] (Smoothing&) {});
  for (const auto& [source, least] : {std::pair (NormalSource::WPCA, 4), std::pair (NormalSource::PCA, 3),
                                      std::pair (NormalSource::HOUGH, 3), std::pair (NormalSource::INPUT, 1)})
    expectLeast (least, [source = source] (Smoothing& chain) {
      chain.setNormalIterations (1);
      chain.setNormalSource (source);
    });
  const auto none = [] (Smoothing&) {};
  EXPECT_EQ (messageFor (3, none, buildNeighborGraph<pcl::PointNormal> (cloud, 10)), ""); // a graph needs no k
}
} // namespace
