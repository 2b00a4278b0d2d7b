// SPDX-License-Identifier: BSD-3-Clause
#include "models/subdivision.h"

#include <algorithm>
#include <map>

namespace pcl_normal_smoothing::evaluation
{

void
subdivide (tools::Mesh& mesh)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middleOf = [&] (std::uint32_t a, std::uint32_t b) {
    const auto [found, added] =
        middles.try_emplace (std::minmax (a, b), static_cast<std::uint32_t> (mesh.vertices.size ()));
    if (added)
      mesh.vertices.emplace_back ((mesh.vertices[a] + mesh.vertices[b]) / 2);
    return found->second;
  };
  std::vector<tools::Mesh::Triangle> parts;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middleOf (a, b), bc = middleOf (b, c), ca = middleOf (c, a);
    parts.insert (parts.end (), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  mesh.triangles = std::move (parts);
}

} // namespace pcl_normal_smoothing::evaluation
