// SPDX-License-Identifier: BSD-3-Clause
#include "method_options.h"

#include "files/field_values.h"
#include "files/tool_error.h"

#include <pcl_normal_smoothing/core/error.h>

#include <cmath>
#include <limits>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr std::int64_t max_iterations = 1000000;
const char* const rounds_section = "Of the rounds, which the presets default and fast smooth in";

const Words<SmoothingPreset> presets {{"default", SmoothingPreset::DEFAULT},
                                      {"fast", SmoothingPreset::FAST},
                                      {"paper", SmoothingPreset::PAPER}};
const Words<NormalSource> sources {{"pca", NormalSource::PCA},
                                   {"wpca", NormalSource::WPCA},
                                   {"hough", NormalSource::HOUGH},
                                   {"input", NormalSource::INPUT}};
const Words<NormalWeight> weights {{"threshold", NormalWeight::THRESHOLD},
                                   {"gaussian", NormalWeight::GAUSSIAN},
                                   {"mixed", NormalWeight::MIXED}};
const Words<MixedThreshold> mixed_thresholds {{"printed", MixedThreshold::PRINTED}, {"rms", MixedThreshold::RMS}};
const Words<UpdateRule> rules {{"paper", UpdateRule::PAPER}, {"compensated", UpdateRule::COMPENSATED}};

std::string
textOf (float number)
{
  std::string text;
  appendFloat (number, text);
  return text;
}

std::string
textOf (int number)
{
  return std::to_string (number);
}

/** Default of -max_displacement in the rounds, or in the chain. */
std::string
limitOf (const core::SmoothingOptions& method)
{
  if (method.in_rounds)
    return "5 noise_sigma, the largest";
  return std::isfinite (method.update.max_displacement) ? textOf (method.update.max_displacement) : "no limit";
}

const std::string no_length = "inf";

std::string
optionIfFinite (const std::string& name, float number)
{
  return std::isfinite (number) ? name + textOf (number) : std::string ();
}

std::string
lengthOrNone (float length)
{
  return std::isfinite (length) ? textOf (length) : no_length;
}

/** The text for the default preset, then those for the other presets and the paper's chain if they differ. */
std::string
ofPresets (const std::function<std::string (const MethodSettings&)>& text)
{
  MethodSettings settings;
  const std::string standard = text (settings);
  std::string all = standard;
  for (const auto& [name, preset] : presets) {
    settings.setPreset (preset);
    if (text (settings) != standard)
      all += "; preset " + name + ": " + text (settings);
  }
  MethodSettings chain;
  chain.setNormalWeight (NormalWeight::GAUSSIAN);
  if (text (chain) != standard)
    all += "; the chain in place of rounds: " + text (chain);
  return all;
}

/** A Standard that lists the defaults of the presets. */
std::string
presetStandard (const std::function<std::string (const core::SmoothingOptions&)>& text)
{
  return ofPresets ([&] (const MethodSettings& settings) { return text (settings.options ()); });
}
} // namespace

const char* const presets_and_chain =
    "The presets default and fast smooth in rounds, by the noise that they find. With an option of the paper's chain\n"
    "(-weights -mixed -threshold -sigma_s -normal_iterations -update -update_sigma_s) that chain runs in their place.";

Standard
standardOf (const SmoothingSettings& settings)
{
  return [method = settings.options ()] (const auto& text) { return text (method); };
}

void
addPresetOptions (Options& options, SmoothingSettings& settings)
{
  options.add ("-preset", wordList (presets), "parameters to begin with; every other option holds over it", "default",
               choiceOption<SmoothingPreset> (presets, [&] (auto preset) { settings.setPreset (preset); }));
  options.add ("-normals", wordList (sources), "where the first normals come from",
               presetStandard ([] (const auto& method) { return wordFor (sources, method.normals); }),
               choiceOption<NormalSource> (sources, [&] (auto source) { settings.setNormalSource (source); }));
}

void
addFilterOptions (Options& options, const Standard& standard, SmoothingSettings& settings)
{
  options.add ("-weights", wordList (weights), "weight of a neighbour's normal",
               standard ([] (const auto& method) { return wordFor (weights, method.filter.weight); }),
               choiceOption<NormalWeight> (weights, [&] (auto weight) { settings.setNormalWeight (weight); }));
  options.add ("-mixed", wordList (mixed_thresholds),
               "threshold of -weights mixed: as the paper prints it, or root mean square",
               standard ([] (const auto& method) { return wordFor (mixed_thresholds, method.filter.mixed_threshold); }),
               choiceOption<MixedThreshold> (mixed_thresholds, [&] (auto kind) { settings.setMixedThreshold (kind); }));
  options.add ("-threshold", "T", "of -weights threshold: cosine up to which a normal does not count, 0 to 1",
               standard ([] (const auto& method) { return textOf (method.filter.threshold); }),
               numberOption (0, 1, [&] (double threshold) { settings.setThreshold (threshold); }));
  options.add ("-sigma_s", "S", "of -weights gaussian: standard deviation of the difference of two unit normals",
               standard ([] (const auto& method) { return textOf (method.filter.sigma_s); }),
               positiveOption ([&] (double sigma) { settings.setSigmaS (sigma); }));
  options.add ("-normal_iterations", "N", "iterations of the normal filter",
               standard ([] (const auto& method) { return textOf (method.filter.iterations); }),
               integerOption (0, max_iterations,
                              [&] (auto n) { settings.setNormalIterations (static_cast<int> (n)); }));
}

void
addUpdateOptions (Options& options, const Standard& standard, SmoothingSettings& settings)
{
  options.add ("-update", wordList (rules), "how points move; the paper's way inflates curved surfaces",
               standard ([] (const auto& method) { return wordFor (rules, method.update.rule); }),
               choiceOption<UpdateRule> (rules, [&] (auto rule) { settings.setUpdateRule (rule); }));
  options.add ("-update_sigma_s", "S", "standard deviation of 1 - cosine of two normals in the point update",
               standard ([] (const auto& method) { return textOf (method.update.sigma_s); }),
               positiveOption ([&] (double sigma) { settings.setUpdateSigmaS (sigma); }));
}

void
addMotionOptions (Options& options,
                  const std::string& iterations,
                  const Standard& standard,
                  SmoothingSettings& settings)
{
  options.add ("-point_iterations", "N", iterations,
               standard ([] (const auto& m) { return textOf (m.in_rounds ? m.rounds.count : m.update.iterations); }),
               integerOption (0, max_iterations, [&] (auto n) { settings.setPointIterations (static_cast<int> (n)); }));
  options.add ("-max_displacement", "D",
               "farthest that a point may end from where it began, but for rounding, in the cloud's unit",
               standard (limitOf), positiveOption ([&] (double distance) { settings.setMaxDisplacement (distance); }));
}

void
addNoiseOptions (Options& options, SmoothingSettings& settings)
{
  const double limit = std::numeric_limits<float>::infinity ();
  options.add ("-noise_sigma", "S", "standard deviation of the noise along the normal, in the cloud's unit",
               "estimated from the cloud",
               numberOption (0, limit, [&] (double sigma) { settings.setNoiseSigma (sigma); }));
  options.add ("-noise_varies", "0|1", "1: the noise may differ from place to place, sigma is its median",
               "1; 0 with -noise_sigma", switchOption ([&] (bool varies) { settings.setNoiseVaries (varies); }));
  options.add ("-point_spacing", "D", "distance between neighbouring points, in the cloud's unit",
               "estimated from the cloud", numberOption (0, limit, [&] (double d) { settings.setPointSpacing (d); }));
  const OptionReader length = numberOption (0, limit, [&] (double d) { settings.setSheetDistance (d); });
  options.add (
      "-sheet_distance", "D|inf",
      "a neighbour farther off the tangent planes may lie on another sheet, in the cloud's unit; "
      "inf: all lie on one",
      "from the cloud: by the gap where close sheets are seen, inf for layers of a depth camera, else 4 noise_sigma "
      "and more; for fast inf, but on the lines of a scan",
      [&, length] (const std::string& text) {
        text == no_length ? settings.setSheetDistance (std::numeric_limits<double>::infinity ()) : length (text);
      });
}

void
addWideningOption (Options& options, SmoothingSettings& settings)
{
  options.section (rounds_section);
  options.add ("-widen_neighborhoods", "0|1",
               "1: neighbourhoods grow where scan lines, steps of coordinates or wide noise hide the surface from them",
               "1", switchOption ([&] (bool widen) { settings.setWidenNeighborhoods (widen); }));
  options.section ("");
}

void
checkOptions (const core::SmoothingOptions& method, int k)
{
  if (method.filter.oriented && method.normals != NormalSource::INPUT)
    throw UsageError (
        "-oriented 1 is said of normals that are estimated, whose signs are arbitrary: give -normals input");
  try {
    core::check (method);
    core::checkNeighborCount (method, k);
  }
  catch (const core::Error& error) {
    throw UsageError (error.what ());
  }
}

void
addOrientedOption (Options& options, SmoothingSettings& settings)
{
  options.add ("-oriented", "0|1", "1: the input's normals point to the same side everywhere, none is flipped", "0",
               switchOption ([&] (bool oriented) { settings.setNormalsOriented (oriented); }));
}

void
addMethodOptions (Options& options,
                  SmoothingSettings& settings,
                  SearchOptions& search,
                  const std::function<void (bool)>& save_normals)
{
  addPresetOptions (options, settings);
  search.addTo (options, ofPresets ([] (const MethodSettings& s) { return std::to_string (s.presetK ()); }), 3,
                " (4 with -normals wpca, 7 in rounds); rounds use the nearest 32 at most");
  addMotionOptions (options,
                    "rounds of the presets default and fast, at most 6; iterations of the chain's point update",
                    presetStandard, settings);
  addOrientedOption (options, settings);
  options.add ("-save_normals", "0|1", "1: write the normals that the points fit to normal_x normal_y normal_z", "0",
               switchOption (save_normals));
  addSeedOption (options, "0", [&settings] (std::uint64_t seed) { settings.setSeed (seed); });
  options.section (rounds_section);
  addNoiseOptions (options, settings);
  options.section ("Of the paper's chain");
  addFilterOptions (options, presetStandard, settings);
  addUpdateOptions (options, presetStandard, settings);
  options.section ("");
}

std::string
asOptions (SmoothingPreset preset, const core::SmoothingOptions& method, const SearchOptions& search, int preset_k)
{
  std::string line = "-preset " + wordFor (presets, preset) + " -normals " + wordFor (sources, method.normals);
  if (search.radius > 0)
    line += " -radius " + textOf (static_cast<float> (search.radius));
  else
    line += " -k " + std::to_string (search.k > 0 ? search.k : preset_k);
  if (search.max_radius > 0)
    line += " -max_radius " + textOf (static_cast<float> (search.max_radius));
  if (method.in_rounds)
    line += " -point_iterations " + textOf (method.rounds.count) + " -noise_sigma " +
            textOf (method.rounds.noise.sigma) + " -noise_varies " + (method.rounds.noise.field.isEven () ? "0" : "1") +
            " -widen_neighborhoods " + (method.widen_neighborhoods ? "1" : "0") + " -point_spacing " +
            textOf (method.rounds.noise.spacing) + " -sheet_distance " + lengthOrNone (method.rounds.sheet_distance) +
            optionIfFinite (" -max_displacement ", method.rounds.max_displacement);
  else
    line += " -weights " + wordFor (weights, method.filter.weight) + " -mixed " +
            wordFor (mixed_thresholds, method.filter.mixed_threshold) + " -threshold " +
            textOf (method.filter.threshold) + " -sigma_s " + textOf (method.filter.sigma_s) + " -normal_iterations " +
            textOf (method.filter.iterations) + " -update " + wordFor (rules, method.update.rule) +
            " -update_sigma_s " + textOf (method.update.sigma_s) + " -point_iterations " +
            textOf (method.update.iterations) + optionIfFinite (" -max_displacement ", method.update.max_displacement);
  return line + " -oriented " + (method.filter.oriented ? "1" : "0") + " -seed " + std::to_string (method.hough.seed);
}
} // namespace tools
} // namespace pcl_normal_smoothing
