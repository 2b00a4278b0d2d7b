// SPDX-License-Identifier: BSD-3-Clause
#include "ray_motion.h"

#include <cmath>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr float least_cosine_to_ray = .15f; // |cosine| of ray and normal: 81 degrees
} // namespace

void
moveAlongRays (const Vectors& start,
               const Vectors& normals,
               float max_displacement,
               const Execution& execution,
               Positions& positions)
{
  parallelFor (positions.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3f first = start.empty () ? Eigen::Vector3f::Zero () : start[i];
      const Eigen::Vector3f ray = (positions.base[i] + first).normalized ();
      const float cosine = normals[i].dot (ray), length = normals[i].dot (positions.offset[i] - first) / cosine;
      if (std::abs (cosine) > least_cosine_to_ray && std::abs (length) <= max_displacement)
        positions.offset[i] = first + length * ray;
    }
  });
}
} // namespace core
} // namespace pcl_normal_smoothing
