// SPDX-License-Identifier: BSD-3-Clause
#include "tile_merge.h"

#include "command_line/tool.h"
#include "files/tool_error.h"
#include "smoothed_sources.h"
#include "spill_file.h"
#include "tile_result.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
class Merge
{
public:
  Merge (const Plan& plan, const MergeRequest& request) : plan_ (plan), request_ (request) {}

  void
  run ()
  {
    checkNames ();
    requireResults ();
    if (!request_.output.empty ())
      writeOne ();
    else if (!request_.output_folder.empty ())
      writeSources ();
    else
      writeTiles ();
  }

private:
  static std::string
  pathIn (const std::string& folder, const Source& source)
  {
    return (fs::path (folder) / fs::path (source.path).filename ()).string ();
  }

  std::string
  tilePath (std::size_t tile) const
  {
    return (fs::path (request_.tile_folder) / fs::path (plan_.resultPath (tile)).stem ()).string () + ".pcd";
  }

  void
  checkNames () const
  {
    if (!request_.output.empty ())
      checkName (request_.output);
    if (!request_.output_folder.empty ())
      for (const Source& source : plan_.sources)
        checkName (pathIn (request_.output_folder, source));
    if (!request_.tile_folder.empty ())
      for (std::size_t tile = 0; tile < plan_.tiles.size (); ++tile)
        checkName (tilePath (tile));
    checkNamesDiffer ();
  }

  /** Refuses to replace a source, so that this can be run again. */
  void
  checkName (const std::string& path) const
  {
    std::error_code error;
    for (const Source& source : plan_.sources)
      if (fs::equivalent (path, source.path, error))
        throw FileError (path, "is a file that was planned", "name another output");
  }

  void
  checkNamesDiffer () const
  {
    std::map<std::string, std::string> paths;
    for (const Source& source : plan_.sources) {
      const auto [other, added] = paths.emplace (pathIn ("", source), source.path);
      if (!added && !request_.output_folder.empty ())
        throw FileError (source.path, "has the same name as " + other->second,
                         "rename one and plan again, or give -output or -tile_dir");
    }
  }

  void
  requireResults () const
  {
    std::uint64_t with_normal = 0;
    const std::vector<std::size_t> unfinished = unfinishedTiles (plan_, with_normal);
    std::string numbers;
    for (std::size_t i = 0; i < std::min<std::size_t> (unfinished.size (), 100); ++i)
      numbers += " " + std::to_string (unfinished[i]);
    if (!unfinished.empty ())
      throw FileError (plan_.folder,
                       std::to_string (unfinished.size ()) + " of " + std::to_string (plan_.tiles.size ()) +
                           " tiles have no complete result:" + numbers + (unfinished.size () > 100 ? " ..." : ""),
                       "run them");
    core::requireNormals (with_normal, plan_.options.normals);
  }

  void
  writeOne ()
  {
    SmoothedSources sources (plan_, request_.memory);
    CloudShape shape = sources.shapeOf (plan_.sources.front ().shape);
    if (plan_.sources.size () > 1) {
      shape.width = plan_.cloudSize ();
      shape.height = 1;
    }
    checkOutput (request_.output, request_.format);
    PointWriter writer (shape, request_.output, request_.format);
    for (const Source& source : plan_.sources)
      sources.read (source, [&] (const auto& cloud, const auto&) { writer.write (cloud.data.data (), cloud.width); });
    writer.commit ();
    std::printf ("%s: %s\n", request_.output.c_str (), counted (shape.size (), "point").c_str ());
  }

  void
  makeFolder (const std::string& folder) const
  {
    std::error_code error;
    if (fs::create_directories (folder, error); error)
      throw FileError (folder, "cannot be made (" + error.message () + ")", "name another folder for the output");
  }

  void
  writeSources ()
  {
    makeFolder (request_.output_folder);
    SmoothedSources sources (plan_, request_.memory);
    for (const Source& source : plan_.sources) {
      const std::string path = pathIn (request_.output_folder, source);
      checkOutput (path, request_.format);
      PointWriter writer (sources.shapeOf (source.shape), path, request_.format);
      sources.read (source, [&] (const auto& cloud, const auto&) { writer.write (cloud.data.data (), cloud.width); });
      writer.commit ();
      std::printf ("%s: %s\n", path.c_str (), counted (source.shape.size (), "point").c_str ());
    }
  }

  void
  writeTiles ()
  {
    makeFolder (request_.tile_folder);
    SmoothedSources sources (plan_, request_.memory);
    CloudShape shape = sources.shapeOf (plan_.sources.front ().shape);
    SpillFile points (request_.tile_folder, plan_.tiles.size (), request_.memory / 4);
    for (const Source& source : plan_.sources)
      sources.read (source, [&] (const auto& cloud, const auto& tiles) {
        const auto* data = reinterpret_cast<const char*> (cloud.data.data ());
        for (std::size_t i = 0; i < tiles.size (); ++i)
          if (tiles[i] != SmoothedSources::no_tile)
            points.add (tiles[i], {data + i * cloud.point_step, cloud.point_step});
      });
    for (std::size_t tile = 0; tile < plan_.tiles.size (); ++tile) {
      shape.width = plan_.tiles[tile].points;
      shape.height = 1;
      PointWriter writer (shape, tilePath (tile), request_.format);
      points.read (tile, [&] (std::string_view bytes) {
        writer.write (reinterpret_cast<const std::uint8_t*> (bytes.data ()), bytes.size () / shape.point_step);
      });
      writer.commit ();
    }
    std::printf ("%s: %s, %s\n", request_.tile_folder.c_str (), counted (plan_.tiles.size (), "tile").c_str (),
                 counted (plan_.points, "point").c_str ());
    if (plan_.points < plan_.cloudSize ())
      note (counted (plan_.cloudSize () - plan_.points, "point is", "points are") + " not finite: in no tile");
  }

  const Plan& plan_;
  const MergeRequest& request_;
};
} // namespace

void
mergeTiles (const Plan& plan, const MergeRequest& request)
{
  Merge (plan, request).run ();
}

std::vector<std::size_t>
unfinishedTiles (const Plan& plan, std::uint64_t& with_normal)
{
  std::vector<std::size_t> unfinished;
  with_normal = 0;
  for (std::size_t tile = 0; tile < plan.tiles.size (); ++tile) {
    std::uint64_t of_tile = 0;
    if (checkResult (plan, tile, of_tile) != ResultState::COMPLETE)
      unfinished.push_back (tile);
    with_normal += of_tile;
  }
  return unfinished;
}
} // namespace tools
} // namespace pcl_normal_smoothing
