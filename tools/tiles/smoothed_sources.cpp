// SPDX-License-Identifier: BSD-3-Clause
#include "smoothed_sources.h"

#include "clouds/cloud_graph.h"
#include "files/tool_error.h"
#include "sources.h"
#include "tile_result.h"

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace tools
{
/** The results of all tiles in the order of the points' numbers, one window at a time. */
class SmoothedSources::ResultsInOrder
{
public:
  ResultsInOrder (const Plan& plan, std::uint64_t memory) : step_ (plan.result.bytes ())
  {
    window_ = std::clamp<std::uint64_t> (memory / 4 / (step_ + sizeof (std::uint32_t)), 1, 1u << 22);
    const std::size_t buffer = std::clamp<std::size_t> (memory / 4 / plan.tiles.size (), 1u << 12, 1u << 20);
    for (std::size_t tile = 0; tile < plan.tiles.size (); ++tile)
      readers_.emplace_back (plan, tile, buffer);
  }

  /** The record of a point; nullptr if the point is not finite. The numbers must increase from call to call.
    * \param[out] tile to which the point belongs */
  const std::uint8_t*
  find (std::uint64_t number, std::uint32_t& tile)
  {
    while (number >= begin_ + tiles_.size ())
      readWindow ();
    tile = tiles_[number - begin_];
    return tile == no_tile ? nullptr : &records_[(number - begin_) * step_];
  }

private:
  void
  readWindow ()
  {
    begin_ += tiles_.size ();
    tiles_.assign (window_, no_tile);
    records_.resize (window_ * step_);
    for (std::uint32_t tile = 0; tile < readers_.size (); ++tile)
      while (const std::uint8_t* record = readers_[tile].peek ()) {
        const std::uint64_t at = RecordLayout::numberOf (record) - begin_;
        if (at >= window_)
          break;
        std::copy_n (record, step_, &records_[at * step_]);
        tiles_[at] = tile;
        readers_[tile].skip ();
      }
  }

  std::size_t step_;
  std::uint64_t window_ = 0;
  std::uint64_t begin_ = 0;
  std::vector<ResultReader> readers_;
  std::vector<std::uint32_t> tiles_;  // of the points of the window
  std::vector<std::uint8_t> records_; // likewise
};

namespace
{
void
requireUnchanged (const Source& source, bool unchanged)
{
  if (!unchanged)
    throw FileError (source.path, "has changed since the tiles were planned", "run plan again, and the tiles");
}
} // namespace

SmoothedSources::SmoothedSources (const Plan& plan, std::uint64_t memory)
: plan_ (plan), results_ (std::make_unique<ResultsInOrder> (plan, memory))
{}

SmoothedSources::~SmoothedSources () = default;

CloudShape
SmoothedSources::shapeOf (const CloudShape& source) const
{
  CloudFile cloud = emptyCloud (source);
  if (plan_.save_normals)
    addNormalFields (cloud);
  CloudShape shape = source;
  shape.fields = cloud.cloud->fields;
  shape.point_step = cloud.cloud->point_step;
  return shape;
}

void
SmoothedSources::read (const Source& source, const Use& use)
{
  requireUnchanged (source, stateOf (source.path).first == source.bytes);
  PointFile file (source.path);
  const CloudFile empty = emptyCloud (source.shape);
  std::uint64_t number = source.first;
  std::vector<std::uint8_t> points;
  while (const std::size_t count = file.read (pointsAtOnce (source.shape), points)) {
    requireUnchanged (source, number + count <= source.first + source.shape.size ());
    CloudFile cloud = empty;
    cloud.cloud = pcl::make_shared<pcl::PCLPointCloud2> (*empty.cloud);
    cloud.cloud->data.swap (points);
    cloud.cloud->width = static_cast<pcl::uindex_t> (count);
    cloud.cloud->height = 1;
    cloud.cloud->row_step = cloud.cloud->width * cloud.cloud->point_step;
    if (plan_.save_normals)
      addNormalFields (cloud);
    putResults (number, *cloud.cloud);
    use (*cloud.cloud, tiles_);
    number += count;
    cloud.cloud->data.swap (points);
  }
  requireUnchanged (source, file.finish () == source.checksum);
}

void
SmoothedSources::putResults (std::uint64_t first, pcl::PCLPointCloud2& cloud)
{
  const VectorLayout positions = *VectorLayout::find (cloud, {"x", "y", "z"});
  const auto normals = VectorLayout::find (cloud, normal_fields);
  tiles_.resize (cloud.width);
  for (std::size_t i = 0; i < cloud.width; ++i) {
    const std::uint8_t* record = results_->find (first + i, tiles_[i]);
    if (!record)
      continue;
    positions.set (cloud.data.data (), i, plan_.result.positions ().get (record, 0));
    if (!plan_.save_normals)
      continue;
    const Eigen::Vector3d normal = plan_.result.normals ().get (record, 0);
    if (!std::isnan (normal.x ()))
      normals->set (cloud.data.data (), i, normal);
  }
}
} // namespace tools
} // namespace pcl_normal_smoothing
