// SPDX-License-Identifier: BSD-3-Clause
#include "filter_fixture.h"

namespace
{
using namespace test_support;

template <typename FilterT>
class FilterLifeCycle : public FilterTest<FilterT>
{};

TYPED_TEST_SUITE (FilterLifeCycle, AllFilters);

TYPED_TEST (FilterLifeCycle, ChangesItsFieldsOfEveryPointAndNoOther)
{
  constexpr bool writes_points = TestFixture::Traits::writes_points;
  constexpr bool writes_normals = TestFixture::has_normal && (!writes_points || TestFixture::Traits::estimates_normals);
  const auto output = this->result ();
  expectSameFrame (output, *this->cloud_);
  ASSERT_EQ (output.size (), this->cloud_->size ());
  std::size_t moved = 0, turned = 0;
  for (std::size_t i = 0; i < output.size (); ++i) {
    auto point = output[i];
    const auto& input = (*this->cloud_)[i];
    moved += point.getVector3fMap () != input.getVector3fMap ();
    point.getVector3fMap () = input.getVector3fMap ();
    if constexpr (TestFixture::has_normal) {
      turned += point.getNormalVector3fMap () != input.getNormalVector3fMap ();
      if (writes_normals)
        point.getNormalVector3fMap () = input.getNormalVector3fMap ();
    }
    EXPECT_TRUE (samePoint (point, input)) << "a field of point " << i << " that is not the filter's has changed";
  }
  EXPECT_EQ (moved > output.size () / 2, writes_points);
  EXPECT_EQ (moved > 0, writes_points);
  EXPECT_EQ (turned > output.size () / 2, writes_normals);
}

TYPED_TEST (FilterLifeCycle, IndicesChooseWhatIsWrittenAndNotWhereNorWhatIsSeen)
{
  const auto full = this->result ();
  TypeParam filter;
  this->prepare (filter);
  const pcl::Indices chosen {299, 7, 7, 120, 0};
  filter.setIndices (std::make_shared<pcl::Indices> (chosen));
  const auto output = this->run (filter);
  auto expected = *this->cloud_;
  for (const auto index : chosen)
    expected[index] = full[index];
  expectSamePoints (output, expected);
  expectSameFrame (output, *this->cloud_);

  filter.setIndices (std::make_shared<pcl::Indices> ());
  expectSamePoints (this->run (filter), *this->cloud_);
}

TYPED_TEST (FilterLifeCycle, FiltersInPlace)
{
  const auto expected = this->result ();
  const auto frame = *this->cloud_;
  TypeParam filter;
  this->prepare (filter);
  filter.filter (*this->cloud_);
  expectSamePoints (*this->cloud_, expected);
  expectSameFrame (*this->cloud_, frame);
}

TYPED_TEST (FilterLifeCycle, OrganisedCloudsStayOrganised)
{
  const auto flat = this->result ();
  this->cloud_->width = 20;
  this->cloud_->height = 15;
  const auto output = this->result ();
  expectSameFrame (output, *this->cloud_);
  expectSamePoints (output, flat);
}

TYPED_TEST (FilterLifeCycle, APointThatIsNotFiniteStaysAndIsNobodysNeighbour)
{
  Vectors finite, normals_of_finite;
  pcl::Indices kept;
  for (std::size_t i = 0; i < this->points_.size (); ++i)
    if (i % 7 == 3)
      (*this->cloud_)[i].getVector3fMap ()[static_cast<int> (i % 3)] =
          i % 2 == 0 ? nan_float : -std::numeric_limits<float>::infinity ();
    else {
      finite.push_back (this->points_[i]);
      normals_of_finite.push_back (this->normals_[i]);
      kept.push_back (static_cast<pcl::index_t> (i));
    }
  TypeParam of_finite;
  this->prepare (of_finite, makeCloud<typename TestFixture::Point> (finite, normals_of_finite), normals_of_finite);
  of_finite.setKSearch (10);
  const auto result_of_finite = this->run (of_finite);

  for (const bool is_dense : {true, false}) { // users' flags are often wrong
    this->cloud_->is_dense = is_dense;
    const auto output = this->result ();
    EXPECT_EQ (output.is_dense, is_dense);
    for (std::size_t i = 0; i < output.size (); ++i)
      EXPECT_TRUE (i % 7 != 3 || samePoint (output[i], (*this->cloud_)[i])) << "point " << i;
    for (std::size_t j = 0; j < kept.size (); ++j) {
      EXPECT_EQ (output[kept[j]].getVector3fMap (), result_of_finite[j].getVector3fMap ()) << "point " << kept[j];
      if constexpr (TestFixture::has_normal) {
        EXPECT_EQ (output[kept[j]].getNormalVector3fMap (), result_of_finite[j].getNormalVector3fMap ());
      }
    }
  }
}

TYPED_TEST (FilterLifeCycle, OneObjectServesOneCloudAfterAnother)
{
  const auto expected = this->result ();
  const Shape ball = sphere (500, 2);
  TypeParam filter;
  this->prepare (filter, makeCloud<typename TestFixture::Point> (ball.points, ball.normals), ball.normals);
  filter.setKSearch (10);
  EXPECT_EQ (this->run (filter).size (), 500u);
  filter.setIndices (std::make_shared<pcl::Indices> (pcl::Indices {1, 2}));
  this->run (filter);
  filter.setIndices (pcl::IndicesPtr ());
  this->prepare (filter);
  expectSamePoints (this->run (filter), expected);
  TypeParam copy = filter;
  expectSamePoints (this->run (copy), expected);
}
} // namespace
