// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/session.h"

#include "command_line/tool.h"

#include <pcl_normal_smoothing/core/chain/surface_estimation.h>
#include <pcl_normal_smoothing/core/noise/noise_estimate.h>
#include <pcl_normal_smoothing/core/rounds/robust_smoothing.h>
#include <pcl_normal_smoothing/input_checks.h>

#include <algorithm>
#include <chrono>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr int display_k = 16;          // for curvature, and the estimate of the spacing
constexpr int normals_k = 8;           // few, so that noise shows
constexpr std::size_t most_graphs = 6; // 13 MB each for 100,000 points with 32 neighbours

/** Parses options as if they were on a command line. */
void
parse (Options& known, const std::map<std::string, std::string>& options)
{
  std::vector<std::string> words {"pcl_normal_smoothing_viewer"};
  for (const auto& [name, text] : options)
    words.insert (words.end (), {name, text});
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back (word.data ());
  known.parse (static_cast<int> (arguments.size ()), arguments.data ());
}
} // namespace

ViewerSession::ViewerSession (const std::string& cloud_path, const std::string& mesh_path)
: file_ (loadInput (cloud_path)), cloud_ (readPositions (positionsOf (file_), core::Execution ()))
{
  checkPointCount (core::finiteElements (cloud_).size (), 0);
  display_graph_ = core::NeighborGraph::build (cloud_, makeNeighborQuery (display_k, 0, 0), core::Execution ());
  noisy_ = smoothed_ = surfaceOf (file_);
  spacing_ = core::estimateNoise (*display_graph_, noisy_.nodes, core::Execution ()).inCloudUnit (cloud_.unit).spacing;
  if (!mesh_path.empty ())
    useMesh (mesh_path);
}

void
ViewerSession::useMesh (const std::string& path)
{
  const Mesh mesh = loadMesh (path);
  mesh_distance_.emplace (mesh);
  if (mesh.vertices.size () != display_graph_->size () || display_graph_->size () != file_.size ())
    return;
  std::vector<std::uint32_t> node_of (file_.size ());
  for (std::uint32_t node = 0; node < display_graph_->size (); ++node)
    node_of[display_graph_->order ()[node]] = node;
  for (const auto& [a, b, c] : mesh.triangles)
    triangles_.push_back ({node_of[a], node_of[b], node_of[c]});
}

Surface
ViewerSession::surfaceOf (const CloudFile& file) const
{
  const core::Execution execution;
  Surface surface;
  surface.nodes = core::gather (readPositions (positionsOf (file), cloud_.unit, execution), display_graph_->order ());
  surface.normals = core::startNormals (*display_graph_, surface.nodes, execution, normals_k);
  return surface;
}

core::NeighborGraph::ConstPtr
ViewerSession::graphFor (const core::NeighborQuery& query, unsigned threads)
{
  const auto kept = std::find_if (graphs_.begin (), graphs_.end (), [&] (const KeptGraph& other) {
    return other.query.k == query.k && other.query.radius == query.radius && other.query.distinct == query.distinct;
  });
  if (kept != graphs_.end ())
    graphs_.splice (graphs_.begin (), graphs_, kept);
  else
    graphs_.push_front (
        {query, core::NeighborGraph::build (cloud_, query.inUnit (cloud_.unit), core::Execution (threads))});
  if (graphs_.size () > most_graphs)
    graphs_.pop_back ();
  return graphs_.front ().graph;
}

void
ViewerSession::smooth (const std::map<std::string, std::string>& options)
{
  SmoothingJob job;
  Options known;
  job.addOptions (known);
  parse (known, options);
  job.check (known);
  CloudFile result = file_;
  job.prepare (result);
  const auto begin = std::chrono::steady_clock::now ();
  job.run (result, job.threads (), {}, graphFor (job.query (), job.threads ()));
  seconds_ = std::chrono::duration<double> (std::chrono::steady_clock::now () - begin).count ();
  parameters_ = job.parameters ();
  smoothed_ = surfaceOf (result);
  result_ = std::move (result);
}

std::vector<float>
ViewerSession::values (const Surface& surface, Colouring colouring) const
{
  switch (colouring) {
  case Colouring::DISPLACEMENT:
    return displacements ();
  case Colouring::CURVATURE:
    return curvatures (surface);
  case Colouring::DISTANCE:
    return distances (surface);
  }
  return {};
}

std::vector<float>
ViewerSession::displacements () const
{
  const core::Positions &from = noisy_.nodes, &to = smoothed_.nodes;
  std::vector<float> numbers;
  for (std::size_t i = 0; i < from.size (); ++i)
    numbers.push_back (
        static_cast<float> (from.unit * ((to.base[i] - from.base[i]) + (to.offset[i] - from.offset[i])).norm ()));
  return numbers;
}

std::vector<float>
ViewerSession::curvatures (const Surface& surface) const
{
  std::vector<float> numbers;
  for (const auto& local :
       core::estimateSurfaces (*display_graph_, surface.nodes, core::pcaSurface, core::Execution ()))
    numbers.push_back (local.variation);
  return numbers;
}

std::vector<float>
ViewerSession::distances (const Surface& surface) const
{
  std::vector<float> numbers (surface.nodes.size ());
  core::parallelFor (numbers.size (), core::Execution (), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      numbers[i] = static_cast<float> (mesh_distance_->of (surface.position (i)));
  });
  return numbers;
}
} // namespace tools
} // namespace pcl_normal_smoothing
