// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/error.h>
#include <pcl_normal_smoothing/input_checks.h>
#include <pcl_normal_smoothing/smoothing_settings.h>

#include <cmath>
#include <string>

namespace pcl_normal_smoothing
{
namespace
{
core::SmoothingOptions
presetOptions (SmoothingPreset preset)
{
  core::SmoothingOptions options;
  if (preset == SmoothingPreset::PAPER) { // PGU7, section III of the paper, Fig. 9
    options.normals = NormalSource::PCA;
    options.filter.iterations = 5;
    options.update.rule = UpdateRule::PAPER;
    options.update.sigma_s = 1.0f / 3;
    options.update.iterations = 7;
    return options;
  }
  options.filter.iterations = 2;
  options.update.iterations = 2;
  options.rounds.noise = {-1, -1};
  options.rounds.fast = preset == SmoothingPreset::FAST;
  options.rounds.count = options.rounds.fast ? 3 : 6;
  options.rounds.sheet_distance = -1;
  return options;
}

/** Overwrites \a option with what the user set, if anything. */
template <typename Option, typename Set>
void
overwrite (Option& option, const std::optional<Set>& set)
{
  if (set)
    option = static_cast<Option> (*set);
}

/** The same for a length. \throw core::Error naming the \a setter, if the value exceeds the range of float */
void
overwriteLength (float& length, const std::optional<double>& set, const std::string& name, const std::string& setter)
{
  if (set)
    length = floatLength (*set, name, setter);
}

/** Checks a length that was set. It must not be negative: internally, that means "to be estimated".
  * \throw core::Error naming the \a setter, if it is invalid */
void
checkLength (const std::optional<double>& set, const std::string& name, const std::string& setter, bool finite = true)
{
  if (set && (!(*set >= 0) || (finite && std::isinf (*set))))
    throw core::Error (name + " is " + core::numberText (*set) + ": give " + setter +
                       " a length of at least 0, or do not call it and have it estimated");
}
} // namespace

core::SmoothingOptions
SmoothingSettings::options () const
{
  core::SmoothingOptions options = presetOptions (preset_);
  options.in_rounds = !choosesChain ();
  overwrite (options.normals, normal_source_);
  overwrite (options.filter.weight, normal_weight_);
  overwrite (options.filter.threshold, threshold_);
  overwrite (options.filter.sigma_s, sigma_s_);
  overwrite (options.filter.mixed_threshold, mixed_threshold_);
  overwrite (options.filter.iterations, normal_iterations_);
  overwrite (options.update.rule, update_rule_);
  overwrite (options.update.sigma_s, update_sigma_s_);
  overwrite (options.update.iterations, point_iterations_);
  overwrite (options.rounds.count, point_iterations_);
  overwriteLength (options.update.max_displacement, max_displacement_, "the maximal displacement",
                   "setMaxDisplacement");
  options.rounds.max_displacement = options.update.max_displacement;
  if (options.in_rounds) { // the chain uses none of these
    checkLength (noise_sigma_, "the noise's sigma", "setNoiseSigma");
    checkLength (point_spacing_, "the spacing", "setPointSpacing");
    checkLength (sheet_distance_, "the sheet distance", "setSheetDistance", false);
  }
  overwriteLength (options.rounds.noise.sigma, noise_sigma_, "the noise's sigma", "setNoiseSigma");
  overwriteLength (options.rounds.noise.spacing, point_spacing_, "the spacing", "setPointSpacing");
  overwriteLength (options.rounds.sheet_distance, sheet_distance_, "the sheet distance", "setSheetDistance");
  options.noise_varies = noise_varies_.value_or (!noise_sigma_);
  options.widen_neighborhoods = widen_neighborhoods_;
  options.update.search_interval = search_interval_;
  options.filter.oriented = options.update.oriented = options.rounds.oriented = oriented_;
  options.hough.seed = seed_;
  return options;
}

bool
SmoothingSettings::choosesChain () const
{
  return preset_ == SmoothingPreset::PAPER || normal_weight_ || threshold_ || sigma_s_ || mixed_threshold_ ||
         normal_iterations_ || update_rule_ || update_sigma_s_ || search_interval_ != 0;
}

int
SmoothingSettings::presetK () const
{
  if (preset_ == SmoothingPreset::PAPER)
    return 7;
  if (choosesChain ())
    return 15;
  return preset_ == SmoothingPreset::FAST ? 16 : 32;
}
} // namespace pcl_normal_smoothing
