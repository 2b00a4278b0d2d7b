// SPDX-License-Identifier: BSD-3-Clause
#include "kernels_fixture.h"

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

struct Votes
{
  float normals[3][block_size];
  std::int32_t bins[block_size];
};

/** Indices of points, three for each vote. */
struct Triples
{
  std::uint32_t corners[3][block_size];
};

/** The points that vote. */
const Vectors&
points ()
{
  static const Vectors all = withNoise (torus (333, 1, 0.4).points, 0.05, 120);
  return all;
}

/** \param[in] round each gives other triples */
Triples
triplesOf (std::uint32_t round)
{
  Triples triples;
  for (std::uint32_t i = 0; i < block_size; ++i)
    for (std::uint32_t corner = 0; corner < 3; ++corner)
      triples.corners[corner][i] =
          static_cast<std::uint32_t> ((7 * i + (5 + round) * corner + 31 * round) % points ().size ());
  return triples;
}

constexpr std::uint32_t bands = 3;
constexpr float band_begin[] = {0, 1, 7, 17};

Votes
votesOf (const Kernels& kernels,
         const Triples& triples,
         const float (&rotation)[3][3],
         const float (&band_cosine)[bands])
{
  Votes votes;
  kernels.vote_planes ({points ().data ()->data (), triples.corners, rotation, band_cosine, band_begin, bands,
                        votes.normals, votes.bins});
  return votes;
}

/** Checks the bins of the votes whose normals are not close to the border of a bin; adds their number to \a checked. */
void
expectTheBinsOfTheirNormals (const Votes& votes, const std::string& kernels, std::size_t& checked)
{
  for (std::size_t i = 0; i < block_size; ++i) {
    const double turn = std::atan2 (votes.normals[1][i], votes.normals[0][i]) / (2 * M_PI) + 1;
    const int band = (votes.normals[2][i] < 0.9f) + (votes.normals[2][i] < 0.5f);
    const double column = (turn - std::floor (turn)) * static_cast<double> (band_begin[band + 1] - band_begin[band]);
    if (std::abs (column - std::round (column)) < 0.05)
      continue;
    ++checked;
    EXPECT_EQ (votes.bins[i], static_cast<int> (band_begin[band]) + static_cast<int> (column))
        << kernels << ": normal " << i;
  }
}

TEST (PlaneVotesTest, VotesGoToTheBinOfTheirNormal)
{
  const float upright[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const float band_cosine[] = {0.9f, 0.5f, 0.2f}; // the last band extends to the equator
  constexpr std::uint32_t rounds = 20;
  std::size_t count = 0;
  const Kernels* const* all = allKernels (count);
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t checked = 0;
    for (std::uint32_t round = 0; round < rounds; ++round)
      expectTheBinsOfTheirNormals (votesOf (*all[k], triplesOf (round), upright, band_cosine), all[k]->name, checked);
    EXPECT_GT (checked, rounds * block_size / 2) << all[k]->name;
  }
}

TEST (PlaneVotesTest, VotesOfPlanesAreTheSameForEveryInstructionSet)
{
  const float rotation[3][3] = {{0.36f, 0.48f, -0.8f}, {-0.8f, 0.6f, 0}, {0.48f, 0.64f, 0.6f}};
  const float band_cosine[] = {0.9f, 0.5f, 0};
  expectAllTheSame ([&] (const Kernels& kernels) {
    Triples triples = triplesOf (0);
    for (std::uint32_t corner = 0; corner < 3; ++corner)
      triples.corners[corner][block_size - 1] = corner % 2; // only two different points
    const Votes votes = votesOf (kernels, triples, rotation, band_cosine);
    EXPECT_EQ (votes.bins[block_size - 1], -1);
    EXPECT_LT (*std::max_element (votes.bins, votes.bins + block_size), 17);
    std::vector<float> result (votes.bins, votes.bins + block_size);
    for (const auto& coordinates : votes.normals)
      result.insert (result.end (), coordinates, coordinates + block_size);
    return result;
  });
}
} // namespace
