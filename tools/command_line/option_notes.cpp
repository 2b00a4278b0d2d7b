// SPDX-License-Identifier: BSD-3-Clause
#include "option_notes.h"

#include "tool.h"

#include <core/limits.h>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** Those of the options \a names that were given, as a list. */
std::string
givenOf (const std::vector<std::string>& names, const Options& options)
{
  std::string list;
  for (const std::string& name : names)
    if (options.given (name))
      list += (list.empty () ? "" : " ") + name;
  return list;
}
} // namespace

void
noteSurprises (const Options& options, const core::SmoothingOptions& method, int k)
{
  if (method.in_rounds && k > static_cast<int> (core::max_row_length))
    note ("of the " + std::to_string (k) + " neighbours of -k the rounds use the nearest " +
          std::to_string (core::max_row_length));
  if (method.in_rounds)
    return;
  const std::map<std::string, std::string> given = options.given ();
  const auto preset = given.find ("-preset");
  const bool meant =
      given.count ("-weights") + given.count ("-update") > 0 || (preset != given.end () && preset->second == "paper");
  const std::string of_chain =
      givenOf ({"-mixed", "-threshold", "-sigma_s", "-normal_iterations", "-update_sigma_s"}, options);
  if (!meant && !of_chain.empty ())
    note (of_chain + ": of the paper's chain, which now runs in place of the rounds");
  const std::string of_rounds =
      givenOf ({"-noise_sigma", "-noise_varies", "-widen_neighborhoods", "-point_spacing", "-sheet_distance"}, options);
  if (!of_rounds.empty ())
    note (of_rounds + ": for the rounds of the presets default and fast, not used here");
}
} // namespace tools
} // namespace pcl_normal_smoothing
