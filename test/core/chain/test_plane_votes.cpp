// SPDX-License-Identifier: BSD-3-Clause
#include "kernels_fixture.h"

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

class PlaneVotesTest : public KernelsTest
{};

TEST_P (PlaneVotesTest, VotesGoToTheBinOfTheirNormal)
{
  const float rotation[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const float band_cosine[] = {0.9f, 0.5f, 0.2f}, band_begin[] = {0, 1, 7, 17}; // the last band goes on to the equator
  for (std::uint32_t round = 0; round < 20; ++round) {
    std::uint32_t triples[3][16];
    for (std::uint32_t i = 0; i < 16; ++i)
      for (std::uint32_t corner = 0; corner < 3; ++corner)
        triples[corner][i] = static_cast<std::uint32_t> ((7 * i + (5 + round) * corner + 31 * round) % nodes_.size ());
    float normals[3][16];
    std::int32_t bins[16];
    kernels ().vote_planes (
        {nodes_.base.data ()->data (), triples, rotation, band_cosine, band_begin, 3, normals, bins});
    for (std::size_t i = 0; i < 16; ++i) {
      if (bins[i] < 0)
        continue;
      const double turn = std::atan2 (normals[1][i], normals[0][i]) / (2 * 3.14159265358979) + 1;
      const int band = (normals[2][i] < 0.9f) + (normals[2][i] < 0.5f);
      const double column = (turn - std::floor (turn)) * static_cast<double> (band_begin[band + 1] - band_begin[band]);
      if (std::abs (column - std::round (column)) < 0.05) // between two
        continue;
      EXPECT_EQ (bins[i], static_cast<int> (band_begin[band]) + static_cast<int> (column)) << "normal " << i;
    }
  }
}

TEST_P (PlaneVotesTest, VotesOfPlanesAreTheSameForEveryInstructionSet)
{
  expectAllTheSame ([this] (const Kernels& kernels) {
    const float rotation[3][3] = {{0.36f, 0.48f, -0.8f}, {-0.8f, 0.6f, 0}, {0.48f, 0.64f, 0.6f}};
    const float band_cosine[] = {0.9f, 0.5f, 0}, band_begin[] = {0, 1, 7, 17};
    std::uint32_t triples[3][16];
    for (std::uint32_t i = 0; i < 16; ++i) // the last is of two points alone
      for (std::uint32_t corner = 0; corner < 3; ++corner)
        triples[corner][i] = i == 15 ? corner % 2 : static_cast<std::uint32_t> ((7 * i + 5 * corner) % nodes_.size ());
    float normals[3][16];
    std::int32_t bins[16];
    kernels.vote_planes ({nodes_.base.data ()->data (), triples, rotation, band_cosine, band_begin, 3, normals, bins});
    EXPECT_EQ (bins[15], -1);
    EXPECT_LT (*std::max_element (bins, bins + 16), 17);
    std::vector<float> result (bins, bins + 16);
    for (const auto& coordinates : normals)
      result.insert (result.end (), coordinates, coordinates + 16);
    return result;
  });
}

INSTANTIATE_TEST_SUITE_P (Graphs, PlaneVotesTest, graphsForKernels ());
} // namespace
