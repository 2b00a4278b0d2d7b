// SPDX-License-Identifier: BSD-3-Clause
#include "study/families.h"
#include "sweep/sweep.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
Row
rowOf (const Case& noisy_case, const Combination& combination)
{
  Row row = noisy_case.row ("sweep", combination.name (), combination.parameters ());
  row.k = combination.k;
  row.normal_iterations = combination.normal_iterations;
  row.point_iterations = combination.point_iterations;
  return row;
}

/** Whether there is a row with all requested measures. */
bool
isAnswered (const StudyOptions& options, const Results& results, const std::string& key)
{
  return results.answered (key) &&
         (options.sweep_measures == MeasureSet::PAPER || std::isfinite (results.find (key)->measures.p2s_mean));
}

std::vector<Combination>
missing (const StudyOptions& options, const Case& noisy_case, const Results& results)
{
  std::vector<Combination> combinations;
  if (options.sweep && noisy_case.isFirst ())
    for (const Combination& combination : allCombinations ())
      if (!isAnswered (options, results, rowOf (noisy_case, combination).key ()))
        combinations.push_back (combination);
  return combinations;
}

/** The error of each cloud: its distance to the mesh or, unless that was measured for all of them, its area error. */
std::vector<double>
errorsOf (const std::vector<Row>& rows)
{
  const bool all_measured =
      std::all_of (rows.begin (), rows.end (), [] (const Row& row) { return std::isfinite (row.measures.p2s_mean); });
  std::vector<double> errors;
  for (const Row& row : rows)
    errors.push_back (all_measured ? row.measures.p2s_mean : row.measures.area_error);
  return errors;
}

/** Whether both clouds are kept already, or there is no sweep. */
bool
extremesAreKept (const CaseWork& work)
{
  const std::vector<Combination> all = allCombinations ();
  return !work.options.sweep || !work.noisy_case.isFirst () ||
         2 <= std::count_if (all.begin (), all.end (), [&] (const auto& c) {
           const Row* row = work.results.find (rowOf (work.noisy_case, c).key ());
           return row && !row->cloud.empty ();
         });
}

/** Keeps the clouds with the lowest and the highest error, which are only known once all rows exist. */
void
keepExtremes (const CaseWork& work, Sweep& sweep)
{
  std::vector<Combination> all = allCombinations ();
  const auto rowFor = [&] (const Combination& c) { return *work.results.find (rowOf (work.noisy_case, c).key ()); };
  all.erase (std::remove_if (all.begin (), all.end (), [&] (const auto& c) { return !rowFor (c).ok (); }), all.end ());
  if (all.empty ())
    return;
  for (const Combination& combination : all)
    if (Row row = rowFor (combination); !row.cloud.empty ()) {
      row.cloud.clear ();
      work.results.put (row);
    }
  std::vector<Row> rows;
  std::transform (all.begin (), all.end (), std::back_inserter (rows), rowFor);
  const std::vector<double> errors = errorsOf (rows);
  const auto [best, worst] = std::minmax_element (errors.begin (), errors.end ());
  for (const auto& [error, stem] : {std::pair (best, "sweep_best"), std::pair (worst, "sweep_worst")}) {
    const Combination& combination = all[static_cast<std::size_t> (error - errors.begin ())];
    sweep.run ({combination}, [&, stem = stem] (const Combination& c, const Smoothed& smoothed) {
      Row row = rowFor (c);
      work.keepCloud (stem, smoothed.points, smoothed.normals, row);
      work.results.put (row);
    });
  }
}
} // namespace

void
planSweep (const StudyOptions& options, const Case& noisy_case, const Results& results, Progress& progress)
{
  for (std::size_t i = missing (options, noisy_case, results).size (); i > 0; --i)
    progress.plan (Work::SWEEP, noisy_case.model.mesh.vertices.size ());
}

void
workOnSweep (const CaseWork& work)
{
  const std::vector<Combination> combinations = missing (work.options, work.noisy_case, work.results);
  if (combinations.empty () && extremesAreKept (work))
    return;
  Sweep sweep (work.noisy);
  sweep.run (combinations, [&] (const Combination& combination, const Smoothed& smoothed) {
    Row row = rowOf (work.noisy_case, combination);
    row.seconds = smoothed.seconds;
    work.answer (Work::SWEEP, row, smoothed.points, smoothed.normals, work.options.sweep_measures);
  });
  keepExtremes (work, sweep);
}

} // namespace pcl_normal_smoothing::evaluation
