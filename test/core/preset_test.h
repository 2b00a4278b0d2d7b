// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smoothed.h"

#include <gtest/gtest.h>

namespace test_support
{
/** Tests that run with both presets, default and fast. */
class PresetTest : public testing::TestWithParam<bool>
{
protected:
  static bool
  isFast ()
  {
    return GetParam ();
  }

  /** Number of neighbours that the preset uses. */
  static std::uint32_t
  k ()
  {
    return neighborsOf (isFast ());
  }
};

inline std::string
nameOfPreset (const testing::TestParamInfo<bool>& preset)
{
  return preset.param ? "Fast" : "Default";
}
} // namespace test_support
