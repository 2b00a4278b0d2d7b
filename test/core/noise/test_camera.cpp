// SPDX-License-Identifier: BSD-3-Clause
#include "noise/layer_clouds.h"
#include "preset_test.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::core;
using namespace test_support;

/** A table a metre away, tilted by \a degrees, seen by a depth camera that measures the disparity in steps. The rows of
  * pixels in one step form planes as well. */
Vectors
tableBeforeACamera (double degrees)
{
  constexpr double focal_length = 525, steps_of_metre = 345; // in pixels; a step of the disparity is z²/345 m
  const double slope = std::tan (degrees * M_PI / 180);
  Vectors points;
  for (int v = -60; v < 60; ++v)
    for (int u = -60; u < 60; ++u) {
      const Eigen::Vector3d ray (u / focal_length, v / focal_length, 1);
      const double noise = .4 * patchNoise (layer_spacing * (u + 60.), layer_spacing * (v + 60.));
      const double disparity = std::round (steps_of_metre * (1 + slope * ray.y ()) + noise);
      points.push_back ((steps_of_metre / disparity * ray).cast<float> ());
    }
  return points;
}

TEST (CameraTest, LayersOfATableThatSlantsAreSeen)
{
  for (const double degrees : {50., 60., 65.})
    EXPECT_TRUE (layersOf (Searched (tableBeforeACamera (degrees))).hasLayers ()) << degrees;
}

TEST (CameraTest, LayersAreOfACameraAtTheOriginAlone)
{
  for (const double degrees : {0., 30., 50., 65.}) {
    Vectors points = tableBeforeACamera (degrees);
    EXPECT_TRUE (layersOf (Searched (points)).are_of_camera) << degrees;
    for (const Eigen::Vector3f& away :
         {Eigen::Vector3f (1, 0, 0), Eigen::Vector3f (2, 1, 0), Eigen::Vector3f (0, 0, -1)}) {
      Vectors moved = points;
      for (auto& point : moved)
        point += away;
      EXPECT_FALSE (layersOf (Searched (moved)).are_of_camera) << degrees << " by " << away.transpose ();
    }
  }
}

TEST (CameraTest, LayersAreNotOfACameraFromWherePixelsAreNotAlike)
{
  Vectors points = tableBeforeACamera (50);
  for (auto& point : points) // towards the camera
    point.z () -= 0.7f;
  const LayerEstimate layers = layersOf (Searched (points));
  EXPECT_TRUE (layers.hasLayers ());
  EXPECT_FALSE (layers.are_of_camera);
}

class CameraPresets : public PresetTest
{};

TEST_P (CameraPresets, PointsOfACameraStayInTheirPixels)
{
  constexpr float pixel = 1 / 525.f;
  const Vectors points = tableBeforeACamera (50);
  const Vectors& moved = smoothed (asPositions (points), k (), wideningOptions (isFast ())).displacements;
  double along = 0, aside = 0;
  for (std::size_t i = 0; i < points.size (); ++i) {
    along += std::abs (moved[i].dot (points[i].normalized ()));
    aside += moved[i].cross (points[i].normalized ()).norm ();
  }
  EXPECT_GT (along, 0.2 * pixel * static_cast<double> (points.size ())) << "the test is of no use";
  EXPECT_LT (aside, 0.05 * along);
}

INSTANTIATE_TEST_SUITE_P (Presets, CameraPresets, testing::Bool (), nameOfPreset);
} // namespace
