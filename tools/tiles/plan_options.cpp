// SPDX-License-Identifier: BSD-3-Clause
#include "plan_options.h"

#include <array>
#include <cmath>
#include <type_traits>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
// JSON has no infinity.
constexpr const char* infinite = "inf";

using NoiseRegions = std::vector<core::RegionalField::Region>;

Json
regionsAsJson (const NoiseRegions& regions)
{
  Json json = Json::array ();
  for (const auto& [centre, reach, factor] : regions)
    json.push_back (std::array<double, 5> {centre.x (), centre.y (), centre.z (), reach, factor});
  return json;
}

NoiseRegions
regionsFromJson (const Json& json)
{
  NoiseRegions regions;
  for (const Json& region : json) {
    const auto [x, y, z, reach, factor] = region.get<std::array<float, 5>> ();
    regions.push_back ({{x, y, z}, reach, factor});
  }
  return regions;
}

class Writer
{
public:
  template <typename T>
  void
  operator() (const char* name, const T& value)
  {
    if constexpr (std::is_enum_v<T>)
      json[name] = static_cast<int> (value);
    else if constexpr (std::is_floating_point_v<T>)
      json[name] = std::isinf (value) ? Json (infinite) : Json (static_cast<double> (value));
    else if constexpr (std::is_same_v<T, NoiseRegions>)
      json[name] = regionsAsJson (value);
    else
      json[name] = value;
  }

  Json json;
};

class Reader
{
public:
  explicit Reader (const Json& json) : json_ (json) {}

  template <typename T>
  void
  operator() (const char* name, T& value) const
  {
    const Json& found = json_.at (name);
    if constexpr (std::is_enum_v<T>)
      value = static_cast<T> (found.get<int> ());
    else if constexpr (std::is_floating_point_v<T>)
      value = found == infinite ? std::numeric_limits<T>::infinity () : static_cast<T> (found.get<double> ());
    else if constexpr (std::is_same_v<T, NoiseRegions>)
      value = regionsFromJson (found);
    else
      value = found.get<T> ();
  }

private:
  const Json& json_;
};

template <typename Options, typename Use>
void
forEachOption (Options& options, Use& use)
{
  use ("in_rounds", options.in_rounds);
  use ("normals", options.normals);
  use ("hough_confidence", options.hough.confidence);
  use ("hough_tolerance", options.hough.tolerance);
  use ("hough_bands", options.hough.bands);
  use ("hough_rotations", options.hough.rotations);
  use ("hough_seed", options.hough.seed);
  use ("filter_weight", options.filter.weight);
  use ("filter_threshold", options.filter.threshold);
  use ("filter_sigma_s", options.filter.sigma_s);
  use ("filter_mixed_threshold", options.filter.mixed_threshold);
  use ("filter_oriented", options.filter.oriented);
  use ("filter_iterations", options.filter.iterations);
  use ("update_rule", options.update.rule);
  use ("update_sigma_s", options.update.sigma_s);
  use ("update_oriented", options.update.oriented);
  use ("update_iterations", options.update.iterations);
  use ("update_max_displacement", options.update.max_displacement);
  use ("update_search_interval", options.update.search_interval);
  use ("rounds_noise_sigma", options.rounds.noise.sigma);
  use ("rounds_noise_spacing", options.rounds.noise.spacing);
  use ("rounds_noise_field", options.rounds.noise.field.factors.regions);
  use ("noise_varies", options.noise_varies);
  use ("widen_neighborhoods", options.widen_neighborhoods);
  use ("rounds_count", options.rounds.count);
  use ("rounds_fast", options.rounds.fast);
  use ("rounds_oriented", options.rounds.oriented);
  use ("rounds_sheet_distance", options.rounds.sheet_distance);
  use ("rounds_max_displacement", options.rounds.max_displacement);
}
} // namespace

Json
optionsAsJson (const core::SmoothingOptions& options)
{
  Writer writer;
  forEachOption (options, writer);
  return writer.json;
}

core::SmoothingOptions
optionsFromJson (const Json& json)
{
  core::SmoothingOptions options;
  const Reader reader (json);
  forEachOption (options, reader);
  return options;
}

Json
queryAsJson (const core::NeighborQuery& query)
{
  Writer writer;
  writer ("k", query.k);
  writer ("radius", query.radius);
  writer ("distinct", query.distinct);
  return writer.json;
}

core::NeighborQuery
queryFromJson (const Json& json)
{
  core::NeighborQuery query;
  const Reader reader (json);
  reader ("k", query.k);
  reader ("radius", query.radius);
  reader ("distinct", query.distinct);
  return query;
}
} // namespace tools
} // namespace pcl_normal_smoothing
