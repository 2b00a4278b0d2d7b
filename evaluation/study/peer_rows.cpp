// SPDX-License-Identifier: BSD-3-Clause
#include "peer.h"
#include "study/families.h"
#include "study/parallel_peers.h"

#include <algorithm>
#include <filesystem>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
Row
rowOf (const Case& noisy_case, const PeerSetting& setting)
{
  return noisy_case.row ("peer", setting.peer, setting.parameters + (setting.is_default ? " (default)" : ""));
}

/** The row of the peer's setting with the lowest distance to the mesh; nullptr if none succeeded. */
const Row*
bestRow (const Case& noisy_case, const std::string& peer, const Results& results)
{
  const Row* best = nullptr;
  for (const PeerSetting& setting : peerSettings ()) {
    const Row* row = setting.peer == peer ? results.find (rowOf (noisy_case, setting).key ()) : nullptr;
    if (row && row->ok () && (!best || row->measures.p2s_mean < best->measures.p2s_mean))
      best = row;
  }
  return best;
}

/** For the first seed, all settings; for the others, only the best of the first, as the defaults are the slowest. */
bool
isWanted (const StudyOptions& options, const Case& noisy_case, const PeerSetting& setting, const Results& results)
{
  if (noisy_case.isFirst ())
    return setting.is_default || !options.small;
  Case first = noisy_case;
  first.seed = 1;
  const Row* best = bestRow (first, setting.peer, results);
  return best && best->key () == rowOf (first, setting).key ();
}

/** Number of peers without a best setting to repeat for another seed, either not yet or because all failed. */
std::size_t
peersWithoutBest (const StudyOptions& options, const Case& noisy_case, const Results& results)
{
  if (!options.peers || noisy_case.isFirst ())
    return 0;
  Case first = noisy_case;
  first.seed = 1;
  const std::vector<PeerSetting> settings = peerSettings ();
  return static_cast<std::size_t> (std::count_if (settings.begin (), settings.end (), [&] (const PeerSetting& setting) {
    return setting.is_default && !bestRow (first, setting.peer, results);
  }));
}

std::vector<PeerSetting>
missing (const StudyOptions& options, const Case& noisy_case, const Results& results)
{
  std::vector<PeerSetting> settings;
  if (options.peers)
    for (const PeerSetting& setting : peerSettings ())
      if (isWanted (options, noisy_case, setting, results) && !results.answered (rowOf (noisy_case, setting).key ()))
        settings.push_back (setting);
  return settings;
}

/** "CGAL_jet_default" */
std::string
cloudStem (const PeerSetting& setting, const char* which)
{
  std::string stem = setting.peer + "_" + which;
  std::replace (stem.begin (), stem.end (), ' ', '_');
  return stem;
}

/** Stem under which to keep a result's cloud: that of the default, or of the best so far, replacing the previous best;
  * empty if it is not kept. */
std::string
stemToKeep (const CaseWork& work, const PeerSetting& setting, const Row* best_before, const Row& row)
{
  if (!work.noisy_case.isFirst ())
    return {};
  if (setting.is_default)
    return cloudStem (setting, "default");
  return best_before && best_before->measures.p2s_mean <= row.measures.p2s_mean ? "" : cloudStem (setting, "best");
}

/** The cloud of the peer's best setting is about to be replaced: clears it from the row that refers to it. */
void
forgetBestCloud (const CaseWork& work, const PeerSetting& better)
{
  const std::string path = work.cloudPath (cloudStem (better, "best"));
  for (const PeerSetting& setting : peerSettings ())
    if (const Row* named = work.results.find (rowOf (work.noisy_case, setting).key ()); named && named->cloud == path) {
      Row row = *named;
      row.cloud.clear ();
      work.results.put (row);
    }
}

void
take (const CaseWork& work, const PeerSetting& setting, const PeerResult& result)
{
  Row row = rowOf (work.noisy_case, setting);
  row.seconds = result.seconds > 0 ? result.seconds : Measures::none;
  if (!result.failure.empty ())
    return work.refuse (Work::PEER, row, "failed", result.failure);
  const Row* found = bestRow (work.noisy_case, setting.peer, work.results);
  const std::optional<Row> best_before = found ? std::optional<Row> (*found) : std::nullopt;
  work.answer (Work::PEER, row, result.points, {});
  row = *work.results.find (row.key ());
  if (!row.ok ())
    return;
  const std::string stem = stemToKeep (work, setting, best_before ? &*best_before : nullptr, row);
  if (stem.empty ())
    return;
  if (!setting.is_default)
    forgetBestCloud (work, setting);
  work.keepCloud (stem, result.points, {}, row);
  work.results.put (row);
}
} // namespace

void
planPeers (const StudyOptions& options, const Case& noisy_case, const Results& results, Progress& progress)
{
  const std::size_t count =
      missing (options, noisy_case, results).size () + peersWithoutBest (options, noisy_case, results);
  for (std::size_t i = 0; i < count; ++i)
    progress.plan (Work::PEER, noisy_case.model.mesh.vertices.size ());
}

void
workOnPeers (const CaseWork& work)
{
  for (std::size_t i = peersWithoutBest (work.options, work.noisy_case, work.results); i > 0; --i)
    work.progress.skip (Work::PEER, work.noisy.size ());
  std::vector<PeerSetting> settings;
  for (const PeerSetting& setting : missing (work.options, work.noisy_case, work.results))
    if (const auto reason = whyAbsent (setting.peer))
      work.refuse (Work::PEER, rowOf (work.noisy_case, setting), "absent", *reason);
    else
      settings.push_back (setting);
  PeerRun run;
  run.time_limit = work.options.time_limit;
  run.work_folder = work.options.folder + "/work";
  std::error_code error; // if there is no folder, runPeer reports it
  std::filesystem::create_directories (run.work_folder, error);
  runPeers (settings, work.noisy, run,
            [&] (std::size_t i, const PeerResult& result) { take (work, settings[i], result); });
  std::filesystem::remove_all (run.work_folder, error);
}

} // namespace pcl_normal_smoothing::evaluation
