// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <core/rounds/ray_motion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using namespace pcl_normal_smoothing::core;
using namespace test_support;

const Eigen::Vector3f slanting = Eigen::Vector3f (0, .6f, .8f);

/** Noisy points near a slanting plane that crosses the z axis a metre from the origin. */
Positions
besideAPlane ()
{
  Positions positions;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const Eigen::Vector3d ray (uniformNoise (1, i) - .5, uniformNoise (2, i) - .5, 1);
    const double to_plane = .8 / slanting.cast<double> ().dot (ray);
    positions.base.push_back (((to_plane + .01 * gaussianNoise (3, i)) * ray).cast<float> ());
  }
  positions.offset.assign (positions.size (), Eigen::Vector3f::Zero ());
  return positions;
}

void
moveAlongNormals (Positions& positions)
{
  for (std::size_t i = 0; i < positions.size (); ++i)
    positions.offset[i] = -(slanting.dot (positions.base[i]) - .8f) * slanting;
}

TEST (RayMotionTest, PointsEndOnTheirRaysAndTangentPlanes)
{
  Positions positions = besideAPlane ();
  moveAlongNormals (positions);
  const Vectors normals (positions.size (), slanting);
  moveAlongRays ({}, normals, 1, Execution (2), positions);
  for (std::size_t i = 0; i < positions.size (); ++i) {
    const Eigen::Vector3f moved = positions.inCloudUnit (i);
    EXPECT_NEAR (moved.dot (slanting), .8f, 1e-6f);
    EXPECT_LT (moved.normalized ().cross (positions.base[i].normalized ()).norm (), 1e-6f);
  }
}

TEST (RayMotionTest, PointsStayThatWouldGoTooFarOrHaveNoNormal)
{
  Positions positions = besideAPlane ();
  moveAlongNormals (positions);
  const Vectors offsets = positions.offset;
  moveAlongRays ({}, Vectors (positions.size (), slanting), 0, Execution (1), positions);
  EXPECT_EQ (positions.offset, offsets) << "no way is short enough";
  const float nan = std::numeric_limits<float>::quiet_NaN ();
  moveAlongRays ({}, Vectors (positions.size (), Eigen::Vector3f (nan, nan, nan)), 1, Execution (1), positions);
  EXPECT_EQ (positions.offset, offsets) << "no normals";
  moveAlongRays ({}, Vectors (positions.size (), Eigen::Vector3f (1, 0, 0)), 1, Execution (1), positions);
  for (std::size_t i = 0; i < positions.size (); ++i) {
    const bool grazes = std::abs (positions.base[i].normalized ().x ()) < .15f;
    EXPECT_EQ (positions.offset[i] == offsets[i], grazes) << i;
  }
}
} // namespace
