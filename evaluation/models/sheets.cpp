// SPDX-License-Identifier: BSD-3-Clause
#include "models/sheets.h"

#include "models/jitter.h"

#include <algorithm>

namespace pcl_normal_smoothing::evaluation
{

tools::Mesh
makeSheets (std::uint32_t side, double gap)
{
  tools::Mesh mesh;
  Jitter jitter;
  const double step = 1.0 / (side - 1);
  for (const double z : {0.0, gap})
    for (std::uint32_t i = 0; i < side * side; ++i) {
      const std::uint32_t x = i % side, y = i / side;
      const auto shifted = [&] (std::uint32_t n) { // vertices on the border stay on it
        const double shift = 0.2 * jitter ();
        return step * (n + (n > 0 && n + 1 < side ? shift : 0));
      };
      mesh.vertices.emplace_back (shifted (x), shifted (y), z);
    }
  for (std::uint32_t y = 0; y + 1 < side; ++y)
    for (std::uint32_t x = 0; x + 1 < side; ++x) {
      const std::uint32_t a = y * side + x, b = a + 1, c = a + side, d = c + 1, up = side * side;
      const bool rising = (x + y) % 2 == 0;
      for (const auto& [p, q, r] : {tools::Mesh::Triangle {a, b, rising ? d : c},
                                    rising ? tools::Mesh::Triangle {a, d, c} : tools::Mesh::Triangle {b, d, c}}) {
        mesh.triangles.push_back ({p, r, q});
        mesh.triangles.push_back ({p + up, q + up, r + up});
      }
    }
  return mesh;
}

double
distanceToSheets (double gap, const Eigen::Vector3d& point)
{
  const Eigen::Vector2d flat = point.head<2> ();
  const double aside = (flat - flat.cwiseMax (0).cwiseMin (1)).norm ();
  return std::hypot (aside, std::min (std::abs (point.z ()), std::abs (point.z () - gap)));
}

} // namespace pcl_normal_smoothing::evaluation
