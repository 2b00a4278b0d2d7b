// SPDX-License-Identifier: BSD-3-Clause
// A normal filter with a custom weight in place of the paper's: it uses the arrays of `core`, without any class of
// PCL.
#include <pcl_normal_smoothing/core/chain/point_update.h>
#include <pcl_normal_smoothing/core/rounds/robust_smoothing.h>
#include <pcl_normal_smoothing/input_checks.h>

#include <cmath>
#include <iostream>
#include <random>

namespace core = pcl_normal_smoothing::core;

/** A right-angled edge, z = -|x|, with noise of 0.003; a point about every 0.02. */
core::Positions
makeEdge ()
{
  std::mt19937 random (1);
  std::normal_distribution<float> noise (0, 0.003f);
  core::Positions edge;
  for (int i = -50; i <= 50; ++i)
    for (int j = 0; j < 100; ++j) {
      const float x = 0.0141421f * static_cast<float> (i);
      edge.base.emplace_back (x, 0.02f * static_cast<float> (j), noise (random) - std::abs (x));
    }
  edge.offset.assign (edge.size (), Eigen::Vector3f::Zero ());
  return edge;
}

/** One iteration; the weight is Tukey's biweight of the angle between two normals, zero from 40 degrees on. */
core::Vectors
filterByAngle (const core::NeighborGraph& graph, const core::Vectors& normals, const core::Execution& execution)
{
  core::Vectors filtered (normals.size ());
  core::parallelFor (graph.size (), execution, [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero ();
      const core::Row row = graph.row (i);
      for (std::size_t j = 0; j < row.size (); ++j) {
        const float cosine = normals[i].dot (normals[row[j]]);
        const float share = std::acos (std::min (std::abs (cosine), 1.0f)) / (40 * float (M_PI) / 180);
        const float weight = share < 1 ? (1 - share * share) * (1 - share * share) : 0;
        sum += (cosine < 0 ? -weight : weight) * normals[row[j]];
      }
      filtered[i] = sum.normalized ();
    }
  });
  return filtered;
}

double
meanDistanceToEdge (const core::Positions& points)
{
  double sum = 0;
  for (std::size_t i = 0; i < points.size (); ++i) {
    const Eigen::Vector3f point = points.base[i] + points.offset[i];
    sum += std::abs (point.z () + std::abs (point.x ())) * M_SQRT1_2;
  }
  return sum / static_cast<double> (points.size ());
}

int
main ()
{
  const core::Execution execution;
  const core::Positions cloud = makeEdge ();
  const auto graph = core::NeighborGraph::build (cloud, pcl_normal_smoothing::makeNeighborQuery (15, 0, 0), execution);
  core::Positions nodes = core::gather (cloud, graph->order ()); // finite points, in the order of the graph
  core::Vectors normals = core::startNormals (*graph, nodes, execution);
  for (int iteration = 0; iteration < 4; ++iteration)
    normals = filterByAngle (*graph, normals, execution);
  core::PointUpdateOptions update;
  update.rule = pcl_normal_smoothing::UpdateRule::COMPENSATED;
  update.sigma_s = 0.03f;
  update.iterations = 2;
  core::updatePoints (graph, normals, update, {}, execution, nodes);
  const double before = meanDistanceToEdge (cloud), after = meanDistanceToEdge (nodes);
  std::cout << "mean distance to the edge: " << before << " before, " << after << " after\n";
  return after < 0.6 * before ? 0 : 1;
}
