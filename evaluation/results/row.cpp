// SPDX-License-Identifier: BSD-3-Clause
#include "results/row.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Json = nlohmann::ordered_json;

struct MeasureColumn
{
  const char* name;
  double Measures::*value;
};

constexpr MeasureColumn measure_columns[] = {{"E_A", &Measures::area_error},
                                             {"E_k7", &Measures::variation_error_7},
                                             {"E_k15", &Measures::variation_error_15},
                                             {"E_k21", &Measures::variation_error_21},
                                             {"p2s_mean", &Measures::p2s_mean},
                                             {"p2s_rms", &Measures::p2s_rms},
                                             {"p2s_max", &Measures::p2s_max},
                                             {"p2s_ratio", &Measures::p2s_ratio},
                                             {"p2p_mean", &Measures::p2p_mean},
                                             {"p2p_ratio", &Measures::p2p_ratio},
                                             {"normal_angle", &Measures::normal_angle},
                                             {"edge_error", &Measures::edge_error},
                                             {"edge_fraction", &Measures::edge_fraction},
                                             {"spacing_p01", &Measures::spacing_p01},
                                             {"own_normal_angle", &Measures::own_normal_angle},
                                             {"exact_mean", &Measures::exact_mean},
                                             {"exact_ratio", &Measures::exact_ratio}};

/** Nine digits: more than the float coordinates carry. */
Json
numberOrNull (double number)
{
  if (!std::isfinite (number))
    return nullptr;
  char digits[40];
  const auto end = std::to_chars (digits, digits + sizeof digits, number, std::chars_format::general, 9).ptr;
  double rounded = 0;
  std::from_chars (digits, end, rounded);
  return rounded;
}

double
numberOf (const Json& value)
{
  return value.is_null () ? Measures::none : value.get<double> ();
}

Json
countOrNull (const std::optional<int>& count)
{
  return count ? Json (*count) : Json (nullptr);
}

std::optional<int>
countOf (const Json& value)
{
  return value.is_null () ? std::nullopt : std::optional<int> (value.get<int> ());
}

/** A field, quoted as in RFC 4180. */
std::string
csvField (const Json& value)
{
  if (value.is_null ())
    return {};
  if (!value.is_string ())
    return value.dump ();
  const auto text = value.get<std::string> ();
  if (text.find_first_of (",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char c : text)
    quoted += c == '"' ? std::string ("\"\"") : std::string (1, c);
  return quoted + "\"";
}

/** Joins the texts of all columns of a row. */
template <typename TextOf>
std::string
joined (const Json& columns, const TextOf& textOf)
{
  std::string line;
  for (const auto& [name, value] : columns.items ())
    line += (line.empty () && name == columns.begin ().key () ? "" : ",") + textOf (name, value);
  return line;
}
} // namespace

std::string
Row::key () const
{
  const auto number = [] (const std::optional<int>& n) { return n ? std::to_string (*n) : std::string (); };
  Json parts = {model,
                noise,
                sigma,
                seed,
                family,
                name,
                parameters,
                number (k),
                number (normal_iterations),
                number (point_iterations)};
  return parts.dump (-1, ' ', false, Json::error_handler_t::replace);
}

Json
toJson (const Row& row)
{
  Json json {{"model", row.model},
             {"points", row.points},
             {"noise", row.noise},
             {"sigma", row.sigma},
             {"seed", row.seed},
             {"family", row.family},
             {"name", row.name},
             {"parameters", row.parameters},
             {"k", countOrNull (row.k)},
             {"normal_iterations", countOrNull (row.normal_iterations)},
             {"point_iterations", countOrNull (row.point_iterations)},
             {"status", row.status},
             {"reason", row.reason},
             {"seconds", numberOrNull (row.seconds)}};
  for (const auto& [name, value] : measure_columns)
    json[name] = numberOrNull (row.measures.*value);
  json["cloud"] = row.cloud;
  return json;
}

Row
fromJson (const Json& json)
{
  Row row;
  json.at ("model").get_to (row.model);
  json.at ("points").get_to (row.points);
  json.at ("noise").get_to (row.noise);
  json.at ("sigma").get_to (row.sigma);
  json.at ("seed").get_to (row.seed);
  json.at ("family").get_to (row.family);
  json.at ("name").get_to (row.name);
  json.at ("parameters").get_to (row.parameters);
  row.k = countOf (json.at ("k"));
  row.normal_iterations = countOf (json.at ("normal_iterations"));
  row.point_iterations = countOf (json.at ("point_iterations"));
  json.at ("status").get_to (row.status);
  json.at ("reason").get_to (row.reason);
  row.seconds = numberOf (json.at ("seconds"));
  for (const auto& [name, value] : measure_columns)
    row.measures.*value = numberOf (json.at (name));
  json.at ("cloud").get_to (row.cloud);
  return row;
}

std::string
csvHeader ()
{
  return joined (toJson ({}), [] (const std::string& name, const Json&) { return name; });
}

std::string
toCsv (const Row& row)
{
  return joined (toJson (row), [] (const std::string&, const Json& value) { return csvField (value); });
}

} // namespace pcl_normal_smoothing::evaluation
