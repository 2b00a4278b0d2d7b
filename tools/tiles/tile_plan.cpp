// SPDX-License-Identifier: BSD-3-Clause
#include "tile_plan.h"

#include "clouds/cloud_graph.h"
#include "command_line/tool.h"
#include "files/signal_pause.h"
#include "files/tool_error.h"
#include "partition.h"
#include "sources.h"
#include "spill_file.h"
#include "tile_noise.h"

#include <core/noise/noise_sample.h>
#include <core/search/hash_sample.h>
#include <core/sheets/sheet_estimate.h>
#include <pcl_normal_smoothing/core/error.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

namespace fs = std::filesystem;

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
// What the program and its libraries take without any points.
constexpr std::uint64_t program_bytes = 120u << 20;
// Tiles are planned a little smaller than they may be, as they are divided by a sample.
constexpr double filling = 0.95;

/** True also for temporary files that a killed process has left. No cloud has such a name. */
bool
isOfPlan (const std::string& name)
{
  static const std::regex names (
      R"(plan(\.\w{6})?\.json|cells(\.\w{6})?\.bin|tile_\d{6,}(\.\w{6})?\.(points|result)|spill\.\w{6})");
  return std::regex_match (name, names);
}

[[noreturn]] void
failIn (const std::string& folder, const std::string& what, const std::error_code& error)
{
  throw FileError (folder, what + " (" + error.message () + ")", "name another folder for the tiles");
}

class Planner
{
public:
  explicit Planner (const PlanRequest& request)
  : request_ (request), execution_ (request.threads), sources_ (request.files)
  {
    plan_.folder = request.folder;
    plan_.request = request.text;
    plan_.save_normals = request.save_normals;
    setLayouts ();
  }

  Plan
  run (const std::function<std::string (const core::SmoothingOptions&)>& parameters)
  {
    clearFolder ();
    look ();
    distribute ();
    writeTiles ();
    completeOptions (plan_, sample_, hashes_.limitFor (core::sheet_sample_size), execution_);
    plan_.sources = sources_.list ();
    plan_.parameters = parameters (plan_.options.inUnit (1 / plan_.unit));
    for (const char* name : {"/cells.bin", "/plan.json"})
      removeOnInterruption (plan_.folder + name);
    savePlan (plan_);
    keepOnInterruption ();
    return std::move (plan_);
  }

private:
  /** \throw core::Error if a required field is missing, or the cloud is empty */
  void
  setLayouts ()
  {
    CloudFile cloud = emptyCloud (sources_.shape ());
    const auto bytesOf = [] (const VectorLayout& layout) {
      return layout.scalar () == VectorLayout::Scalar::FLOAT32 ? sizeof (float) : sizeof (double);
    };
    positions_ = positionLayoutOf (cloud);
    const std::size_t position_bytes = bytesOf (*positions_);
    const bool reads_normals = request_.options.normals == NormalSource::INPUT;
    if (reads_normals)
      normals_ = normalLayoutOf (cloud, normals_advice);
    plan_.record = RecordLayout (position_bytes, reads_normals ? bytesOf (*normals_) : 0);
    if (request_.save_normals)
      addNormalFields (cloud);
    plan_.result =
        RecordLayout (position_bytes, request_.save_normals ? bytesOf (normalLayoutOf (cloud, normals_advice)) : 0);
    if (sources_.size () == 0)
      throw core::Error ("the cloud is empty: give one that samples a surface");
  }

  void
  makeFolder ()
  {
    const SignalPause pause;
    std::error_code error;
    if (fs::create_directories (plan_.folder, error))
      removeOnInterruption (plan_.folder);
    if (error)
      failIn (plan_.folder, "cannot be made", error);
  }

  void
  clearFolder ()
  {
    makeFolder ();
    std::vector<fs::path> old {plan_.folder + "/plan.json"}; // first: without it the rest is worthless
    std::error_code error;
    for (fs::directory_iterator entry (plan_.folder, error); entry != fs::directory_iterator ();
         entry.increment (error)) {
      const fs::path path = entry->path ();
      if (!isOfPlan (path.filename ().string ()))
        throw FileError (plan_.folder, "holds other files (" + path.filename ().string () + ")",
                         "name a new folder for the tiles");
      old.push_back (path);
    }
    for (auto path = old.begin (); !error && path != old.end (); ++path)
      fs::remove (*path, error);
    if (error)
      failIn (plan_.folder, "cannot be cleared", error);
  }

  /** Reads all points once, for their unit and a sample by which to divide them. */
  void
  look ()
  {
    std::vector<std::uint64_t> wanted = unitSample (sources_.size ());
    std::sort (wanted.begin (), wanted.end ());
    auto next = wanted.begin ();
    std::vector<Eigen::Vector3d> of_unit;
    const std::uint64_t stride = std::max<std::uint64_t> (1, sources_.size () / sampleSize ());
    // Not simply every n-th: scanners write lines of equal length.
    const auto sampled = [stride] (std::uint64_t i) { return i * stride + i * 2654435761u % stride; };
    std::uint64_t next_sampled = 0;
    sources_.read ([&] (std::uint64_t first, const std::uint8_t* points, std::size_t count) {
      for (; next != wanted.end () && *next < first + count; ++next) {
        const Eigen::Vector3d point = positions_->get (points, static_cast<std::size_t> (*next - first));
        if (point.allFinite ())
          of_unit.push_back (point);
      }
      for (; sampled (next_sampled) < first + count; ++next_sampled) {
        const Eigen::Vector3d point = positions_->get (points, sampled (next_sampled) - first);
        if (point.allFinite ())
          partition_sample_.push_back (point);
      }
    });
    if (sources_.faces () > 0)
      note (counted (sources_.faces (), "face", "faces") + " of the files left out: the output are clouds");
    plan_.unit = unitOf (of_unit);
    plan_.options = request_.options.inUnit (plan_.unit);
    plan_.query = request_.query.inUnit (plan_.unit);
  }

  std::uint64_t
  sampleSize () const
  {
    const std::uint64_t for_tiles = 4096 * (sources_.size () / maxPoints () + 1);
    return std::min (std::max<std::uint64_t> (for_tiles, 1u << 16), request_.memory / 8 / sizeof (Eigen::Vector3d) + 1);
  }

  std::uint64_t
  maxPoints () const
  {
    return request_.max_points;
  }

  /** Reads all points again, and sorts them into buckets, one per part of space. */
  void
  distribute ()
  {
    const double parts = static_cast<double> (sources_.size ()) / (filling * static_cast<double> (maxPoints ()));
    const auto most_parts = static_cast<double> (request_.memory / 8 / 8192 + 1);
    const Partition partition (std::move (partition_sample_),
                               static_cast<std::size_t> (std::ceil (std::min (parts, most_parts))));
    buckets_ = std::make_unique<SpillFile> (plan_.folder, partition.size (), request_.memory / 4);
    std::string record (plan_.record.bytes (), '\0');
    auto* bytes = reinterpret_cast<std::uint8_t*> (record.data ());
    sources_.read ([&] (std::uint64_t first, const std::uint8_t* points, std::size_t count) {
      const core::Positions read = readPositions ({*positions_, points, count}, plan_.unit, core::Execution (1));
      for (const std::uint32_t i : core::finiteElements (read)) {
        const std::uint64_t number = first + i;
        std::memcpy (bytes, &number, sizeof number);
        const Eigen::Vector3d place = positions_->get (points, i);
        plan_.record.positions ().set (bytes, 0, place);
        if (normals_)
          plan_.record.normals ().set (bytes, 0, normals_->get (points, i));
        buckets_->add (partition.partOf (place), record);
        hashes_.add (core::hashOf (read, i));
        ++plan_.points;
      }
    });
    bucket_count_ = partition.size ();
    checkPointCount (plan_.points, plan_.query.k);
  }

  void
  writeTiles ()
  {
    // Cells of some hundreds of points: enough to see how far the neighbours are, and not so few that the list of cells
    // becomes too long.
    const std::uint64_t most_cells = std::max<std::uint64_t> (request_.memory / 8 / (3 * sizeof (Cell)), 1024);
    const std::uint64_t cell_points = std::max ({std::min<std::uint64_t> (maxPoints () / 256, 256),
                                                 2 * std::uint64_t (plan_.query.k) + 1, plan_.points / most_cells});
    TileWriter writer (plan_, maxPoints (), cell_points, hashes_.limitFor (core::noise_sample_size), execution_);
    // A bucket that is larger than expected from the sample is read in pieces.
    const std::uint64_t piece =
        std::clamp<std::uint64_t> (request_.memory / 3 / (2 * plan_.record.bytes () + 64), 4096, most_points_of_tile);
    for (std::size_t bucket = 0; bucket < bucket_count_; ++bucket) {
      std::vector<std::uint8_t> records;
      const std::uint64_t size = buckets_->size (bucket), step = plan_.record.bytes ();
      records.reserve (std::min (size, (piece + 1) * step));
      buckets_->read (bucket, [&] (std::string_view bytes) {
        for (std::size_t at = 0; at < bytes.size (); at += step) {
          records.insert (records.end (), bytes.begin () + static_cast<std::ptrdiff_t> (at),
                          bytes.begin () + static_cast<std::ptrdiff_t> (at + step));
          if (records.size () < piece * step)
            continue;
          writer.add (records);
          records.clear ();
        }
      });
      writer.add (records);
    }
    buckets_.reset ();
    sample_ = writer.sample ();
  }

  const PlanRequest& request_;
  core::Execution execution_;
  Sources sources_;
  Plan plan_;
  std::optional<VectorLayout> positions_, normals_; // layouts in the files
  std::vector<Eigen::Vector3d> partition_sample_;
  std::unique_ptr<SpillFile> buckets_;
  std::size_t bucket_count_ = 0;
  core::SmallestHashes hashes_ {core::noise_sample_size};
  std::vector<SamplePoint> sample_;
};
} // namespace

Plan
makePlan (const PlanRequest& request, const std::function<std::string (const core::SmoothingOptions&)>& parameters)
{
  try {
    return Planner (request).run (parameters);
  }
  catch (...) {
    removeTemporaryFile ();
    throw;
  }
}

std::optional<Plan>
findPlan (const PlanRequest& request)
{
  try {
    const Plan plan = loadPlan (request.folder);
    const bool same = plan.request == request.text &&
                      std::all_of (plan.sources.begin (), plan.sources.end (), [] (const Source& source) {
                        return stateOf (source.path) == std::pair (source.bytes, source.changed);
                      });
    return same ? std::optional<Plan> (plan) : std::nullopt;
  }
  catch (const FileError&) {
    return std::nullopt;
  }
}

std::uint64_t
pointsWithin (std::uint64_t memory, const core::SmoothingOptions& options, const core::NeighborQuery& query)
{
  core::SmoothingOptions noisy = options;
  noisy.rounds.noise = {1, 1}; // so that all filters run
  const double k = query.k > 0 ? query.k : 64;
  const double bytes = 250 + 4 * k;
  const double loaded = static_cast<double> (std::max (memory, 2 * program_bytes) - program_bytes) / bytes;
  // A tile is a square of the surface with a halo along its sides; a hop goes as far as the k-th neighbour.
  const double halo = 1.2 * (core::smoothingDepth (noisy) + 3) * std::sqrt (k / M_PI);
  const double side = std::max (std::sqrt (loaded) - 2 * halo, std::sqrt (loaded) / 2);
  return static_cast<std::uint64_t> (std::min (side * side, double {most_points_of_tile}));
}
} // namespace tools
} // namespace pcl_normal_smoothing
