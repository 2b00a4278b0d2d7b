// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common_options.h"

#include <pcl_normal_smoothing/smoothing_settings.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Parameters without the class that smooths by them. */
class MethodSettings : public SmoothingSettings
{};

/** What holds without an option: the text for the help, from a text for a set of parameters. */
using Standard = std::function<std::string (const std::function<std::string (const core::SmoothingOptions&)>&)>;

/** That of settings as they are now. */
Standard
standardOf (const SmoothingSettings& settings);

/** -weights -mixed -threshold -sigma_s -normal_iterations */
void
addFilterOptions (Options& options, const Standard& standard, SmoothingSettings& settings);

/** -update -update_sigma_s */
void
addUpdateOptions (Options& options, const Standard& standard, SmoothingSettings& settings);

/** -point_iterations -max_displacement \param[in] iterations what the first one counts, for the help */
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

/** \param[in] k that is set; 0 = none
  * \throw UsageError where an option does not fit the others */
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

/** All options of the method but -widen_neighborhoods. \param[in] save_normals told -save_normals */
void
addMethodOptions (Options& options,
                  SmoothingSettings& settings,
                  SearchOptions& search,
                  const std::function<void (bool)>& save_normals);

/** The parameters that a smoothing used, in one line, as options that give the same smoothing again. */
std::string
asOptions (SmoothingPreset preset, const core::SmoothingOptions& used, const SearchOptions& search, int preset_k);
} // namespace tools
} // namespace pcl_normal_smoothing
