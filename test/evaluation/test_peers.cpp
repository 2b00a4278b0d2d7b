// SPDX-License-Identifier: BSD-3-Clause
#include "peer_fixture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
/** A gentle setting for each peer, which leaves every point near its place. */
const std::vector<PeerSetting> gentle {
    {"APSS", "", false, {{"filter scale", 3}, {"spherical parameter", 1}}},
    {"RIMLS", "", false, {{"filter scale", 3}, {"sharpness", .75}}},
    {"LOP", "", false, {{"h", 3}, {"mu", .1}, {"iterations", 5}}},
    {"WLOP", "", false, {{"radius", 2.5}, {"iterations", 5}, {"uniform", 0}}},
    {"CGAL jet", "", false, {{"neighbors", 24}}},
    {"CGAL bilateral", "", false, {{"neighbors", 16}, {"sharpness angle", 30}, {"iterations", 1}}},
    {"PCL MLS", "", false, {{"order", 2}, {"radius", 3}}},
};

class PeerOrder : public PeerTest
{
protected:
  Points
  smooth (const Points& points, const PeerSetting& setting)
  {
    const PeerResult result = runPeer (setting, points, run);
    EXPECT_EQ ("", result.failure);
    EXPECT_EQ (points.size (), result.points.size ());
    return result.points.size () == points.size () ? result.points : points;
  }
};

class Peers : public PeerOrder, public testing::WithParamInterface<PeerSetting>
{};

constexpr std::size_t count = 2000;
/** Distance between neighbours of that many points on the sphere. */
const double spacing = std::sqrt (4 * M_PI / count);

TEST_P (Peers, KeepTheOrderOfThePoints)
{
  if (const auto why = whyAbsent (GetParam ().peer))
    GTEST_SKIP () << *why;
  const Points noisy = noisySphere (count, 0.2 * spacing);
  const Points smoothed = smooth (noisy, GetParam ());
  // If the order were lost, points would be as far apart as random points of a sphere: 1.33 on average.
  std::size_t far_away = 0;
  double moved = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double distance = (smoothed[i] - noisy[i]).norm ();
    moved += distance;
    far_away += distance > 2 * spacing;
  }
  EXPECT_LE (far_away, count / 200);
  EXPECT_GT (moved / count, 0.01 * spacing) << "nothing was done";
}

TEST_P (Peers, AreTheSameAtAnyPlaceAndScale)
{
  if (const auto why = whyAbsent (GetParam ().peer))
    GTEST_SKIP () << *why;
  const Eigen::Vector3d utm (5e5, 5e6, 100);
  const Points noisy = noisySphere (500, 0.03);
  Points far_away;
  for (const auto& point : noisy)
    far_away.push_back (1000 * point + utm);
  const auto difference = [&] {
    const Points near = smooth (noisy, GetParam ()), result = smooth (far_away, GetParam ());
    std::vector<double> differences;
    for (std::size_t i = 0; i < noisy.size (); ++i)
      differences.push_back (((result[i] - utm) / 1000 - near[i]).norm ());
    // The median, as a neighbour at the limit of a radius may be in or out.
    std::nth_element (differences.begin (), differences.begin () + 250, differences.end ());
    return differences[250];
  };
  // About once in sixty times, MeshLab's APSS gives different results for the same points; a dependence on the place
  // would show every time.
  double least = difference ();
  for (int again = 0; again < 2 && least >= 1e-4; ++again)
    least = std::min (least, difference ());
  EXPECT_LT (least, 1e-4);
}

INSTANTIATE_TEST_SUITE_P (Each, Peers, testing::ValuesIn (gentle), [] (const auto& test) {
  std::string name = test.param.peer;
  name.erase (std::remove (name.begin (), name.end (), ' '), name.end ());
  return name;
});

TEST_F (PeerOrder, WlopGivesEveryPointItsOwnPlaceBack)
{
  const Points noisy = noisySphere (200, 0.1);
  const Points result = smooth (noisy, {"WLOP", "", false, {{"radius", 3}, {"iterations", 0}, {"uniform", 0}}});
  for (std::size_t i = 0; i < noisy.size (); ++i)
    EXPECT_LT ((result[i] - noisy[i]).norm (), 1e-14);
}

TEST_F (PeerOrder, PointThatPclDropsStays)
{
  Points points = noisySphere (count, 0.2 * spacing);
  points.insert (points.begin () + 10, Eigen::Vector3d (5, 5, 5));
  const Points result = smooth (points, {"PCL MLS", "", false, {{"order", 2}, {"radius", 3}}});
  EXPECT_LT ((result[10] - points[10]).norm (), 1e-6);
  EXPECT_LT ((result[11] - points[11]).norm (), 2 * spacing);
}

TEST (PeerSettings, EachPeerHasOneDefaultAndNothingTwice)
{
  std::map<std::string, int> defaults;
  std::set<std::pair<std::string, std::string>> seen;
  std::vector<std::string> order;
  for (const PeerSetting& setting : peerSettings ()) {
    defaults[setting.peer] += setting.is_default;
    EXPECT_TRUE (seen.emplace (setting.peer, setting.parameters).second) << setting.peer << ' ' << setting.parameters;
    if (order.empty () || order.back () != setting.peer)
      order.push_back (setting.peer);
  }
  EXPECT_EQ ((std::vector<std::string> {"APSS", "RIMLS", "LOP", "WLOP", "CGAL jet", "CGAL bilateral", "PCL MLS"}),
             order);
  for (const auto& [peer, number] : defaults)
    EXPECT_EQ (1, number) << peer;
}

TEST (PeerSettings, AreReadable)
{
  const PeerSetting first = peerSettings ().front ();
  EXPECT_EQ ("filter scale 2, spherical parameter 1", first.parameters);
  EXPECT_TRUE (first.is_default);
  EXPECT_EQ (2, first.values.at ("filter scale"));
}

} // namespace
} // namespace pcl_normal_smoothing::evaluation
