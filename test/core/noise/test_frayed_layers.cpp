// SPDX-License-Identifier: BSD-3-Clause
#include "noise/layer_clouds.h"
#include "smoothed.h"

#include <gtest/gtest.h>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::core;
using namespace test_support;

/** Noise of more than half a step: they lie one through the other, and none ends where the next begins. */
TEST (FrayedLayersTest, AreSeenInTheViewOfACamera)
{
  for (const double noise : {0.2, 0.5, 0.8, 1.0}) {
    const Searched cloud (viewInSteps (noise));
    const LayerEstimate layers = layersOf (cloud);
    EXPECT_TRUE (layers.hasLayers ()) << noise;
    EXPECT_TRUE (layers.are_of_camera) << noise;
    EXPECT_GT (layers.noise_of_step, noise) << noise;
    const SmoothingOptions options = prepared (wideningOptions (false), cloud);
    EXPECT_TRUE (options.widen_neighborhoods);
    EXPECT_TRUE (options.rounds.along_rays);
    EXPECT_EQ (options.rounds.noise.hidden_by, NoiseHiddenBy::LAYERS);
  }
}

TEST (FrayedLayersTest, AreNoneIfNoCameraSawThem)
{
  EXPECT_FALSE (layersOf (Searched (viewInSteps (1, 30))).hasLayers ());
}
} // namespace
