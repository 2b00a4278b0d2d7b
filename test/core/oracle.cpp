// SPDX-License-Identifier: BSD-3-Clause
#include "oracle.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <map>

namespace test_support
{
namespace core = pcl_normal_smoothing::core;
using pcl_normal_smoothing::MixedThreshold;
using pcl_normal_smoothing::NormalWeight;
using pcl_normal_smoothing::UpdateRule;

namespace
{
constexpr double pi = 3.14159265358979323846;

/** W of eq. 5. */
double
gaussian (double x, double sigma)
{
  return std::exp (-x * x / (2 * sigma * sigma));
}

/** The sign s of a neighbour's normal: -1 if it is to be flipped. */
double
flip (const Eigen::Vector3d& n_i, const Eigen::Vector3d& n_j, bool oriented)
{
  return !oriented && n_i.dot (n_j) <= 0 ? -1 : 1;
}

/** By singular values of the weighted, centred points; the library uses the eigenvalues of their covariance. */
OracleSurface
surfaceOf (const Points& points, const std::vector<double>& weights)
{
  double weight = 0;
  Eigen::Vector3d centroid (0, 0, 0);
  for (std::size_t j = 0; j < points.size (); ++j) {
    weight += weights[j];
    centroid += weights[j] * points[j];
  }
  centroid /= weight;
  Eigen::MatrixXd centred (3, points.size ());
  for (std::size_t j = 0; j < points.size (); ++j)
    centred.col (static_cast<Eigen::Index> (j)) = std::sqrt (weights[j]) * (points[j] - centroid);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd (centred, Eigen::ComputeFullU);
  const Eigen::Vector3d squares = svd.singularValues ().head<3> ().array ().square ();
  return {svd.matrixU ().col (2), squares[2] / squares.sum ()};
}

/** sigma_c of eq. 4: mean distance to the other points. */
double
meanDistance (const Points& points, std::size_t i, const std::vector<std::size_t>& row)
{
  double sum = 0;
  for (const std::size_t j : row)
    sum += (points[j] - points[i]).norm ();
  return sum / static_cast<double> (row.size () - 1);
}

/** T of eq. 7. */
double
thresholdOfEq7 (const Points& normals, std::size_t i, const std::vector<std::size_t>& row, bool oriented, bool rms)
{
  double sum = 0;
  for (const std::size_t j : row) {
    const Eigen::Vector3d n_j = flip (normals[i], normals[j], oriented) * normals[j];
    sum += std::pow ((normals[i] - n_j).dot (normals[i]), 2);
  }
  const auto k = static_cast<double> (row.size ());
  return rms ? std::sqrt (sum / k) : std::sqrt (sum) / k;
}

Eigen::Vector3d
filtered (const Points& points,
          const Points& normals,
          std::size_t i,
          const std::vector<std::size_t>& row,
          const core::NormalFilterOptions& options)
{
  const double sigma_c = meanDistance (points, i, row);
  const double mixed =
      thresholdOfEq7 (normals, i, row, options.oriented, options.mixed_threshold == MixedThreshold::RMS);
  const Eigen::Vector3d n_i = normals[i];
  Eigen::Vector3d sum (0, 0, 0);
  for (const std::size_t j : row) {
    const Eigen::Vector3d n_j = flip (n_i, normals[j], options.oriented) * normals[j];
    const double distance = (points[i] - points[j]).norm ();
    double weight = 0;
    switch (options.weight) {
    case NormalWeight::THRESHOLD: // eq. 3
      weight = n_i.dot (n_j) <= options.threshold ? 0 : std::pow (n_i.dot (n_j) - options.threshold, 2);
      break;
    case NormalWeight::GAUSSIAN: // eq. 4
      weight = gaussian (distance, sigma_c) * gaussian ((n_i - n_j).norm (), options.sigma_s);
      break;
    case NormalWeight::MIXED: { // eq. 6
      const double x = (n_i - n_j).dot (n_i);
      weight = x >= mixed ? 0 : gaussian (distance, sigma_c) * std::pow (x - mixed, 2);
      break;
    }
    }
    sum += weight * n_j; // eq. 2
  }
  return sum.norm () > 0 ? Eigen::Vector3d (sum.normalized ()) : n_i;
}

Eigen::Vector3d
moved (const Points& points,
       const Points& normals,
       std::size_t i,
       const std::vector<std::size_t>& row,
       const core::PointUpdateOptions& options)
{
  double sigma_c = 0;
  for (const std::size_t j : row)
    sigma_c = std::max (sigma_c, (points[j] - points[i]).norm ());
  Eigen::Vector3d sum (0, 0, 0);
  double weights = 0;
  for (const std::size_t j : row) {
    const Eigen::Vector3d n_j = flip (normals[i], normals[j], options.oriented) * normals[j];
    const Eigen::Vector3d difference = points[j] - points[i];
    const double weight =
        gaussian (difference.norm (), sigma_c) * gaussian (1 - normals[i].dot (n_j), options.sigma_s); // eq. 9
    const Eigen::Vector3d along = options.rule == UpdateRule::PAPER ? n_j : Eigen::Vector3d ((normals[i] + n_j) / 2);
    sum += n_j * (weight * along.dot (difference)); // eq. 8
    weights += weight;
  }
  return points[i] + sum / weights;
}

/** The cell of a direction in the upper half sphere, as band and column; cells are about as wide as they are high. */
std::pair<int, int>
cellOf (const Eigen::Vector3d& direction, int bands)
{
  const double height = pi / bands;
  const int band = static_cast<int> (std::acos (std::min (1.0, direction.z ())) / height);
  const double columns = std::max (1.0, std::round (2 * bands * std::sin (band * height)));
  const double turn = std::atan2 (direction.y (), direction.x ()) / (2 * pi) + 0.5;
  return {band, static_cast<int> (std::min (columns - 1, turn * columns))};
}
} // namespace

Points
inDouble (const Vectors& vectors)
{
  Points result;
  for (const auto& vector : vectors)
    result.push_back (vector.cast<double> ());
  return result;
}

Rows
nearestRows (const Points& points, std::size_t k)
{
  Rows rows;
  for (const auto& point : points) {
    std::vector<std::pair<double, std::size_t>> all;
    for (std::size_t j = 0; j < points.size (); ++j)
      all.emplace_back ((points[j] - point).norm (), j);
    std::partial_sort (all.begin (), all.begin () + static_cast<std::ptrdiff_t> (k), all.end ());
    rows.emplace_back ();
    for (std::size_t j = 0; j < k; ++j)
      rows.back ().push_back (all[j].second);
  }
  return rows;
}

OracleSurface
oraclePca (const Points& points, const std::vector<std::size_t>& row)
{
  Points of_row;
  for (const std::size_t j : row)
    of_row.push_back (points[j]);
  return surfaceOf (of_row, std::vector<double> (row.size (), 1));
}

OracleSurface
oracleWpca (const Points& points, std::size_t i, const std::vector<std::size_t>& row)
{
  Points others;
  std::vector<double> weights;
  for (const std::size_t j : row)
    if (points[j] != points[i]) {
      others.push_back (points[j]);
      weights.push_back (1 / (points[j] - points[i]).norm ());
    }
  return surfaceOf (others, weights);
}

Points
oracleFilter (const Points& points, const Rows& rows, Points normals, const core::NormalFilterOptions& options)
{
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const Points last = normals;
    for (std::size_t i = 0; i < points.size (); ++i)
      normals[i] = filtered (points, last, i, rows[i], options);
  }
  return normals;
}

Points
oracleUpdate (Points points, const Rows& rows, const Points& normals, const core::PointUpdateOptions& options)
{
  for (int iteration = 0; iteration < options.iterations; ++iteration) {
    const Points last = points;
    for (std::size_t i = 0; i < points.size (); ++i)
      points[i] = moved (last, normals, i, rows[i], options);
  }
  return points;
}

Eigen::Vector3d
oracleHough (const Points& points, const std::vector<std::size_t>& row, int bands)
{
  Eigen::Vector3d mean (0, 0, 0);
  for (std::uint64_t turn = 0; turn < 25; ++turn) {
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond (gaussianNoise (70, 4 * turn), gaussianNoise (70, 4 * turn + 1),
                            gaussianNoise (70, 4 * turn + 2), gaussianNoise (70, 4 * turn + 3))
            .normalized ();
    std::map<std::pair<int, int>, std::pair<int, Eigen::Vector3d>> cells;
    auto winner = cells.end ();
    for (std::size_t a = 0; a < row.size (); ++a)
      for (std::size_t b = a + 1; b < row.size (); ++b)
        for (std::size_t c = b + 1; c < row.size (); ++c) {
          Eigen::Vector3d normal = rotation * (points[row[b]] - points[row[a]]).cross (points[row[c]] - points[row[a]]);
          normal *= (normal.z () < 0 ? -1 : 1) / normal.norm ();
          const auto cell = cells.try_emplace (cellOf (normal, bands), 0, Eigen::Vector3d::Zero ()).first;
          ++cell->second.first;
          cell->second.second += normal;
          if (winner == cells.end () || cell->second.first > winner->second.first)
            winner = cell;
        }
    const Eigen::Vector3d normal = rotation.inverse () * winner->second.second.normalized ();
    mean += mean.dot (normal) < 0 ? -normal : normal;
  }
  return mean.normalized ();
}
} // namespace test_support
