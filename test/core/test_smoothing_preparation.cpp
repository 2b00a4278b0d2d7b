// SPDX-License-Identifier: BSD-3-Clause
#include <core/smoothing_preparation.h>

#include <gtest/gtest.h>

namespace
{
using namespace pcl_normal_smoothing::core;

TEST (SmoothingPreparationTest, WhatLeavesHardlyAnyNoiseThoughNoSheetIsSeenAreLayers)
{
  const auto areLayers = SmoothingPreparation::areLayers;
  EXPECT_TRUE (areLayers ({0.01f, 0.1f}, {0.001f, 0.1f}, {}));
  EXPECT_FALSE (areLayers ({0.01f, 0.1f}, {0.004f, 0.1f}, {})) << "the thin parts of a shape";
  EXPECT_FALSE (areLayers ({0.01f, 0.1f}, {0.001f, 0.1f}, {0.2f, 0.001f})) << "sheets that were seen";
  EXPECT_FALSE (areLayers ({0.01f, 0.1f}, {0, 0}, {})) << "too little is left to tell";
}
} // namespace
