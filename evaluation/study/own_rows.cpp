// SPDX-License-Identifier: BSD-3-Clause
#include "study/families.h"

#include <pcl_normal_smoothing/normal_smoothing.h>

#include <chrono>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Cloud = pcl::PointCloud<pcl::PointNormal>;

const std::vector<std::pair<std::string, SmoothingPreset>> presets {{"default", SmoothingPreset::DEFAULT},
                                                                    {"fast", SmoothingPreset::FAST},
                                                                    {"paper", SmoothingPreset::PAPER}};

/** The rows of the noisy cloud and of the presets, in this order. */
std::vector<Row>
rowsOf (const Case& noisy_case)
{
  std::vector<Row> rows {noisy_case.row ("noisy", "noisy", "")};
  for (const auto& preset : presets)
    rows.push_back (noisy_case.row ("ours", preset.first, "-preset " + preset.first));
  return rows;
}

Cloud::Ptr
toCloud (const tools::Points& points)
{
  auto cloud = pcl::make_shared<Cloud> ();
  for (const Eigen::Vector3d& point : points) {
    cloud->emplace_back ();
    cloud->back ().getVector3fMap () = point.cast<float> ();
  }
  return cloud;
}

void
smooth (const CaseWork& work, Row row, SmoothingPreset preset)
{
  NormalSmoothing<pcl::PointNormal> smoothing;
  smoothing.setPreset (preset);
  smoothing.setInputCloud (toCloud (work.noisy));
  Cloud smoothed;
  const auto start = std::chrono::steady_clock::now ();
  smoothing.filter (smoothed);
  row.seconds = std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
  if (!smoothing.getErrorMessage ().empty ())
    return work.refuse (Work::OWN, row, "failed", smoothing.getErrorMessage ());
  tools::Points points, normals;
  for (const pcl::PointNormal& point : smoothed) {
    points.push_back (point.getVector3fMap ().cast<double> ());
    normals.push_back (point.getNormalVector3fMap ().cast<double> ());
  }
  work.answer (Work::OWN, row, points, normals, MeasureSet::ALL, work.noisy_case.isFirst () ? "ours_" + row.name : "");
}
} // namespace

void
planOwn (const StudyOptions&, const Case& noisy_case, const Results& results, Progress& progress)
{
  for (const Row& row : rowsOf (noisy_case))
    if (!results.answered (row.key ()))
      progress.plan (Work::OWN, row.points);
}

void
workOnOwn (const CaseWork& work)
{
  const std::vector<Row> rows = rowsOf (work.noisy_case);
  if (!work.results.answered (rows[0].key ()))
    work.answer (Work::OWN, rows[0], work.noisy, {}, MeasureSet::ALL, work.noisy_case.isFirst () ? "noisy" : "");
  for (std::size_t i = 0; i < presets.size (); ++i)
    if (!work.results.answered (rows[i + 1].key ()))
      smooth (work, rows[i + 1], presets[i].second);
}

} // namespace pcl_normal_smoothing::evaluation
