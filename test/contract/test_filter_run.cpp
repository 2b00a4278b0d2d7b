// SPDX-License-Identifier: BSD-3-Clause
#include "filter_fixture.h"

#include <algorithm>

namespace
{
using namespace test_support;

template <typename FilterT>
class FilterRun : public FilterTest<FilterT>
{
protected:
  /** Uses a cloud of many work chunks, so that threads have something to share. */
  FilterRun ()
  {
    const Shape shape = torus (6000, 1, 0.4);
    this->points_ = withNoise (shape.points, 0.01, 110);
    this->normals_ = withRandomSigns (shape.normals, 111);
    this->cloud_ = makeCloud<typename FilterRun::Point> (this->points_, this->normals_);
  }
};

TYPED_TEST_SUITE (FilterRun, OneOfEachFilter);

TYPED_TEST (FilterRun, IsTheSameBitForBitForAnyNumberOfThreads)
{
  TypeParam filter;
  this->prepare (filter);
  filter.setNumberOfThreads (1);
  const auto one = this->run (filter);
  for (const unsigned threads : {0u, 2u, 3u, 4u, 16u}) {
    filter.setNumberOfThreads (threads);
    EXPECT_EQ (filter.getNumberOfThreads (), threads);
    expectSamePoints (this->run (filter), one);
  }
}

TYPED_TEST (FilterRun, ReportsProgressThatNeverFallsAndEndsAtOne)
{
  for (const unsigned threads : {1u, 2u, 4u}) {
    TypeParam filter;
    this->prepare (filter);
    filter.setNumberOfThreads (threads);
    std::vector<double> shares;
    const auto caller = std::this_thread::get_id ();
    filter.setProgressCallback ([&] (double share) {
      EXPECT_EQ (std::this_thread::get_id (), caller);
      shares.push_back (share);
      return true;
    });
    this->run (filter);
    ASSERT_GT (shares.size (), 3u);
    EXPECT_TRUE (std::is_sorted (shares.begin (), shares.end ()));
    EXPECT_GE (shares.front (), 0);
    EXPECT_NEAR (shares.back (), 1, 1e-12) << "threads " << threads;
    EXPECT_LE (shares.back (), 1);
  }
}

TEST (SmoothingRun, CanBeCancelledWhileTheNoiseIsEstimated)
{
  const Shape shape = torus (60000, 1, 0.4);
  const auto cloud = makeCloud<pcl::PointNormal> (withNoise (shape.points, 0.01, 112), shape.normals);
  pcl_normal_smoothing::NormalSmoothing<pcl::PointNormal> smoothing;
  smoothing.setInputCloud (cloud);
  int standing = 0;
  double last = 0;
  smoothing.setProgressCallback ([&] (double share) {
    standing += share == last && share > 0.4 && share < 1 ? 1 : 0;
    last = share;
    return standing < 20; // progress stands still this long only between the search and the rounds
  });
  pcl::PointCloud<pcl::PointNormal> output;
  smoothing.filter (output);
  EXPECT_TRUE (smoothing.wasCancelled ());
  EXPECT_NEAR (last, 0.5, 0.01);
}

TYPED_TEST (FilterRun, CancelledItsOutputIsTheInput)
{
  for (const double at : {0.0, 0.3, 0.6, 0.95}) {
    TypeParam filter;
    this->prepare (filter);
    filter.setProgressCallback ([=] (double share) { return share < at; });
    auto output = poisonedCloud<typename TestFixture::Point> ();
    filter.filter (output);
    EXPECT_TRUE (filter.wasCancelled ());
    EXPECT_TRUE (contains (filter.getErrorMessage (), "cancelled")) << filter.getErrorMessage ();
    expectSamePoints (output, *this->cloud_);
    expectSameFrame (output, *this->cloud_);

    const auto before = *this->cloud_;
    filter.filter (*this->cloud_);
    expectSamePoints (*this->cloud_, before);

    filter.setProgressCallback ({});
    expectSamePoints (this->run (filter), this->result ());
  }
}

TYPED_TEST (FilterRun, OptionsOfAnEarlierRunDoNotOutliveOneThatFails)
{
  if constexpr (TestFixture::Traits::estimates_normals) {
    TypeParam filter;
    this->prepare (filter);
    this->run (filter);
    EXPECT_GT (filter.usedOptions ().rounds.noise.sigma, 0);
    filter.setKSearch (-3);
    this->expectError (filter, "-3");
    EXPECT_EQ (filter.usedOptions ().rounds.noise.sigma, 0);

    filter.setKSearch (0);
    this->run (filter);
    EXPECT_GT (filter.usedOptions ().rounds.noise.sigma, 0);
    filter.setInputCloud (nullptr);
    this->expectError (filter, "no input");
    EXPECT_EQ (filter.usedOptions ().rounds.noise.sigma, 0);
  }
}

TYPED_TEST (FilterRun, AnExceptionOfTheCallbackIsAnError)
{
  TypeParam filter;
  this->prepare (filter);
  filter.setProgressCallback ([] (double) -> bool { throw std::runtime_error ("the window is gone"); });
  this->expectError (filter, "the window is gone");
}

TYPED_TEST (FilterRun, TwoObjectsRunInTwoThreadsAtOnce)
{
  const auto expected = this->result ();
  for (const auto& output : resultsOfTwoThreads ([this] { return this->result (); }))
    expectSamePoints (output, expected);
}
} // namespace
