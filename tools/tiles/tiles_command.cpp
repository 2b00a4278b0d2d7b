// SPDX-License-Identifier: BSD-3-Clause
#include "tiles_command.h"

#include "command_line/option_notes.h"
#include "command_line/tool.h"
#include "files/tool_error.h"
#include "tile_result.h"
#include "tile_run.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr double gigabyte = 1e9;

std::uint64_t
halfOfMemory ()
{
  return static_cast<std::uint64_t> (sysconf (_SC_PHYS_PAGES)) * static_cast<std::uint64_t> (sysconf (_SC_PAGESIZE)) /
         2;
}

/** "3", "3-5" or "3/8": the numbers before and after the separator; false if the text is none of these. */
bool
parseTiles (const std::string& text, std::size_t& first, char& kind, std::size_t& second)
{
  const char* end = text.data () + text.size ();
  auto read = std::from_chars (text.data (), end, first);
  if (read.ec != std::errc ())
    return false;
  second = first;
  kind = read.ptr == end ? '-' : *read.ptr++;
  if (read.ptr != end)
    read = std::from_chars (read.ptr, end, second);
  return read.ec == std::errc () && read.ptr == end && (kind == '-' ? first <= second : kind == '/' && first < second);
}
} // namespace

void
TilesCommand::addOptions (Options& options)
{
  options.describe (
      std::string (
          "Smooths clouds of any size in tiles: gives, to the bit, what pcl_normal_smoothing would give for all of it\n"
          "with -widen_neighborhoods 0: neighbourhoods stay as they are, and 1 is refused.\n"
          "plan parts the points of some files in tiles, run smooths them, one, some or all, on any number of\n"
          "machines that see the folder, merge puts the files together again; list tells which tiles are still to be\n"
          "run. Every step can be run again: what is done stays.\n") +
          presets_and_chain,
      {"plan|run|merge|list", "folder", "input.pcd|ply..."});
  options.add ("-memory", "G",
               "of plan and merge: gigabytes that they may take, at least 0.01, and that run will have for a tile",
               "half of this machine's", numberOption (0.01, 1e6, [this] (double size) {
                 memory_ = static_cast<std::uint64_t> (size * gigabyte);
               }));
  addPlanOptions (options);
  addRunOptions (options);
  addMergeOptions (options);
}

void
TilesCommand::addPlanOptions (Options& options)
{
  options.add ("-max_points", "N", "of plan: points of a tile, without those around it that run loads too",
               "what fits into -memory", integerOption (1, most_points_of_tile, [this] (std::int64_t points) {
                 request_.max_points = static_cast<std::uint64_t> (points);
               }));
  addMethodOptions (options, method_, search_, [this] (bool save) { request_.save_normals = save; });
  options.add ("-widen_neighborhoods", "0", "tiles keep neighbourhoods as they are; 1 is refused", "0",
               switchOption ([this] (bool widen) { method_.setWidenNeighborhoods (widen); }));
}

void
TilesCommand::addRunOptions (Options& options)
{
  options.add (
      "-tile", "I|I-J|I/N|all",
      "of run: the tile of that number from 0 on, those from I to J, or every N-th from I on; a tile that is done is "
      "left out",
      "all", [this] (const std::string& text) {
        std::size_t first, second;
        char kind;
        if (text != "all" && !parseTiles (text, first, kind, second))
          throw UsageError ("'" + text + "' is not all, N, FIRST-LAST, or I/N for every N-th from I on, I below N");
        tiles_ = text;
      });
}

void
TilesCommand::addMergeOptions (Options& options)
{
  const auto into = [] (std::string& text) { return [&text] (const std::string& given) { text = given; }; };
  options.add ("-output_dir", "B", "of merge: write the files that were given to plan, by their names, to this folder",
               "none", into (merge_.output_folder));
  options.add ("-output", "F.pcd|ply", "of merge: write one file, the points of all files in their order", "none",
               into (merge_.output));
  options.add ("-tile_dir", "T", "of merge: write a file for every tile, without points that are not finite", "none",
               into (merge_.tile_folder));
  format_.addTo (options);
}

void
TilesCommand::work (const Options& options)
{
  memory_ = memory_ > 0 ? memory_ : halfOfMemory ();
  const std::string step = options.file (0);
  if (step == "plan")
    plan (options);
  else if (step == "run")
    run (options);
  else if (step == "merge")
    merge (options);
  else if (step == "list")
    list (options);
  else
    throw UsageError ("there is no step '" + step + "': give plan, run, merge or list");
}

void
TilesCommand::requireOnly (const Options& options, const std::string& step, const std::vector<std::string>& known) const
{
  for (const auto& [name, text] : options.given ())
    if (std::find (known.begin (), known.end (), name) == known.end ())
      throw UsageError ("option " + name + " is none of " + step +
                        ": how points are smoothed is said to plan; see pcl_normal_smoothing_tiles -h");
  if (step != "plan" && !options.file (2).empty ())
    throw UsageError (options.file (2) + ": files are given to plan only");
}

void
TilesCommand::readRequest (const Options& options)
{
  for (const char* name : {"-tile", "-output_dir", "-output", "-tile_dir", "-format"})
    if (options.given (name))
      throw UsageError (std::string ("option ") + name + " is none of plan");
  for (std::size_t i = 2; !options.file (i).empty (); ++i)
    request_.files.push_back (options.file (i));
  if (const std::string extension = extensionOf (options.file (1)); extension == ".pcd" || extension == ".ply")
    throw UsageError (options.file (1) + ": the folder for the tiles comes first: plan folder input...");
  if (request_.files.empty ())
    throw UsageError ("no file is given: plan needs PCD or PLY files");
  request_.folder = options.file (1);
  request_.options = method_.options ();
  if (options.given ("-widen_neighborhoods") && request_.options.widen_neighborhoods)
    throw UsageError (
        "-widen_neighborhoods 1: a tile keeps the neighbourhoods as they are, for wider ones might span all of "
        "the cloud: give 0, or leave the option out");
  checkOptions (request_.options, search_.k);
  noteSurprises (options, request_.options, search_.k);
  request_.query = search_.query (method_.presetK ());
  request_.query.distinct = request_.options.in_rounds;
  request_.threads = search_.threads;
  request_.memory = memory_;
  if (request_.max_points == 0)
    request_.max_points = pointsWithin (memory_, request_.options, request_.query);
  for (const auto& [name, text] : options.given ()) // not what follows from this machine's memory
    request_.text += name == "-threads" ? "" : name + " " + text + " ";
  for (const std::string& file : request_.files)
    request_.text += "\n" + std::filesystem::absolute (file).lexically_normal ().string ();
}

void
TilesCommand::plan (const Options& options)
{
  readRequest (options);
  const std::optional<Plan> found = findPlan (request_);
  const Plan plan = found ? *found : makePlan (request_, [this] (const core::SmoothingOptions& used) {
    return asOptions (method_.getPreset (), used, search_, method_.presetK ());
  });
  if (plan.options.in_rounds && plan.options.rounds.count > 0 && plan.options.rounds.noise.sigma == 0)
    note ("no noise was found, nothing moves: give -noise_sigma if there is some");
  std::uint64_t largest = 0;
  for (const Tile& tile : plan.tiles)
    largest = std::max (largest, tile.points);
  std::printf ("%s: %s in %s of at most %llu%s\nparameters: %s\n", plan.folder.c_str (),
               counted (plan.points, "point").c_str (), counted (plan.tiles.size (), "tile").c_str (),
               static_cast<unsigned long long> (largest), found ? ", planned before" : "", plan.parameters.c_str ());
}

std::vector<std::size_t>
TilesCommand::chosenTiles (std::size_t count) const
{
  std::size_t first = 0, second = count - 1, step = 1;
  char kind = '-';
  if (tiles_ != "all")
    parseTiles (tiles_, first, kind, second);
  if (kind == '/') {
    step = second;
    second = count - 1;
  }
  else if (second >= count)
    throw UsageError ("there is no tile " + std::to_string (second) + ": the last one is " +
                      std::to_string (count - 1));
  std::vector<std::size_t> tiles;
  for (std::size_t tile = first; tile <= second; tile += step)
    tiles.push_back (tile);
  return tiles;
}

void
TilesCommand::run (const Options& options)
{
  requireOnly (options, "run", {"-tile", "-threads", "-memory"});
  const Plan plan = loadPlan (options.file (1));
  for (const std::size_t tile : chosenTiles (plan.tiles.size ())) {
    std::uint64_t with_normal = 0;
    if (checkResult (plan, tile, with_normal) == ResultState::COMPLETE) {
      std::printf ("tile %zu: done before\n", tile);
      continue;
    }
    const TileRun done = runTile (plan, tile, search_.threads);
    std::printf ("tile %zu: %s, %llu around, %s\n", tile, counted (done.points, "point").c_str (),
                 static_cast<unsigned long long> (done.around), counted (done.searches, "search", "searches").c_str ());
    std::fflush (stdout);
  }
}

void
TilesCommand::merge (const Options& options)
{
  requireOnly (options, "merge", {"-output_dir", "-output", "-tile_dir", "-format", "-memory"});
  const int given = options.given ("-output_dir") + options.given ("-output") + options.given ("-tile_dir");
  if (given != 1)
    throw UsageError ("merge needs one of -output_dir, -output and -tile_dir");
  if (format_.format == FileFormat::COMPRESSED)
    throw UsageError ("-format compressed holds one field after the other: merge writes ascii or binary");
  merge_.format = format_.format;
  merge_.memory = memory_;
  mergeTiles (loadPlan (options.file (1)), merge_);
}

void
TilesCommand::list (const Options& options)
{
  requireOnly (options, "list", {});
  std::uint64_t with_normal = 0;
  for (const std::size_t tile : unfinishedTiles (loadPlan (options.file (1)), with_normal))
    std::printf ("%zu\n", tile);
}
} // namespace tools
} // namespace pcl_normal_smoothing
