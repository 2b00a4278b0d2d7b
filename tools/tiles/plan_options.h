// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>

#include <nlohmann/json.hpp>

namespace pcl_normal_smoothing
{
namespace tools
{
using Json = nlohmann::ordered_json;

/** Every number of the options, exact to the bit. Except rounds.along_rays and rounds.noise.hidden_by: only widening
  * sets them, and tiles do not widen neighbourhoods. */
Json
optionsAsJson (const core::SmoothingOptions& options);

/** \throw nlohmann::json::exception if one is missing */
core::SmoothingOptions
optionsFromJson (const Json& json);

Json
queryAsJson (const core::NeighborQuery& query);

core::NeighborQuery
queryFromJson (const Json& json);
} // namespace tools
} // namespace pcl_normal_smoothing
