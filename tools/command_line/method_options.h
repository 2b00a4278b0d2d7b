// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common_options.h"

#include <pcl_normal_smoothing/smoothing_settings.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** The settings alone, without a class that smooths by them. */
class MethodSettings : public SmoothingSettings
{};

/** The default of an option, as text for the help. Its argument gives the text for one set of parameters. */
using Standard = std::function<std::string (const std::function<std::string (const core::SmoothingOptions&)>&)>;

/** The defaults are the current values of \a settings. */
Standard
standardOf (const SmoothingSettings& settings);

/** -weights -mixed -threshold -sigma_s -normal_iterations */
void
addFilterOptions (Options& options, const Standard& standard, SmoothingSettings& settings);

/** -update -update_sigma_s */
void
addUpdateOptions (Options& options, const Standard& standard, SmoothingSettings& settings);

/** -point_iterations -max_displacement \param[in] iterations what -point_iterations counts, for the help */
void
addMotionOptions (Options& options,
                  const std::string& iterations,
                  const Standard& standard,
                  SmoothingSettings& settings);

/** -noise_sigma -noise_varies -point_spacing -sheet_distance */
void
addNoiseOptions (Options& options, SmoothingSettings& settings);

/** -widen_neighborhoods */
void
addWideningOption (Options& options, SmoothingSettings& settings);

/** \param[in] k as given; 0 = not given
  * \throw UsageError if an option contradicts the others */
void
checkOptions (const core::SmoothingOptions& method, int k = 0);

/** Which options make the paper's chain run, for the help. */
extern const char* const presets_and_chain;

/** -preset -normals */
void
addPresetOptions (Options& options, SmoothingSettings& settings);

/** -oriented */
void
addOrientedOption (Options& options, SmoothingSettings& settings);

/** All options of the method except -widen_neighborhoods. \param[in] save_normals called with -save_normals */
void
addMethodOptions (Options& options,
                  SmoothingSettings& settings,
                  SearchOptions& search,
                  const std::function<void (bool)>& save_normals);

/** The parameters that a smoothing used, in one line, as options that reproduce it. */
std::string
asOptions (SmoothingPreset preset, const core::SmoothingOptions& used, const SearchOptions& search, int preset_k);
} // namespace tools
} // namespace pcl_normal_smoothing
