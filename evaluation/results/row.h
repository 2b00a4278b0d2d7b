// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measures/measures.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace pcl_normal_smoothing::evaluation
{

/** One result of the study: what was smoothed, how, and how good the result is. */
struct Row
{
  std::string model;
  std::size_t points = 0;
  std::string noise; // GN or GR
  double sigma = 0;  // in mean edge lengths of the clean mesh
  std::uint64_t seed = 0;
  std::string family; // noisy, ours, sweep, peer
  std::string name;
  std::string parameters;
  std::optional<int> k, normal_iterations, point_iterations;
  std::string status = "ok"; // or failed, absent
  std::string reason;
  double seconds = Measures::none;
  Measures measures;
  std::string cloud; // path in the study's folder; empty if none is kept

  bool
  ok () const
  {
    return status == "ok";
  }

  /** Equal for rows that answer the same question, with or without a result. */
  std::string
  key () const;
};

/** The first line of the table, without line end. */
std::string
csvHeader ();

/** A line of the table (RFC 4180), without line end; missing numbers are empty. */
std::string
toCsv (const Row& row);

/** Missing numbers are null. */
nlohmann::ordered_json
toJson (const Row& row);

/** \throw nlohmann::json::exception if a column is missing or of another type */
Row
fromJson (const nlohmann::ordered_json& json);

} // namespace pcl_normal_smoothing::evaluation
