// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>

#include <optional>

namespace pcl_normal_smoothing
{
/** A set of parameters. Explicitly set values take precedence, in any order. */
enum class SmoothingPreset
{
  DEFAULT, //!< the best quality: robust smoothing in rounds, based on the noise of the cloud
  FAST,    //!< the best at about a third of the cost: fewer rounds over smaller neighbourhoods
  PAPER    //!< PGU7 of Valdivia et al. 2013 with 5 normal and 7 point iterations, as on its scanned bust
};

/** The parameters of NormalSmoothing.
  *
  * The presets DEFAULT and FAST smooth in rounds, which need no parameter. If a parameter of the paper's chain is
  * set (of the normal filter, the update's rule or sigma_s, or a search interval above 0), the chain runs instead:
  * WPCA, k 15, Gaussian weights, 2 normal iterations, 2 compensated point iterations, except for what is set. The
  * defaults given below for those parameters are the chain's, and PAPER's where they differ.
  *
  * std::nullopt, passed to a setter that takes a std::optional, undoes an earlier call: the preset or the cloud decides
  * again. */
class SmoothingSettings
{
public:
  /** Default SmoothingPreset::DEFAULT. */
  void
  setPreset (SmoothingPreset preset)
  {
    preset_ = preset;
  }

  SmoothingPreset
  getPreset () const
  {
    return preset_;
  }

  /** The source of the normals; in rounds, of the initial ones. Default NormalSource::WPCA, PAPER: PCA. */
  void
  setNormalSource (std::optional<NormalSource> source)
  {
    normal_source_ = source;
  }

  /** How the filter weights the normals of neighbours. Chooses the chain. Default NormalWeight::GAUSSIAN. */
  void
  setNormalWeight (std::optional<NormalWeight> weight)
  {
    normal_weight_ = weight;
  }

  /** T of eq. 3, range [0, 1). Chooses the chain. Default 0.65. */
  void
  setThreshold (std::optional<double> threshold)
  {
    threshold_ = threshold;
  }

  /** sigma_s of eq. 5, of the normal filter, range > 0. Chooses the chain. Default 0.3. */
  void
  setSigmaS (std::optional<double> sigma_s)
  {
    sigma_s_ = sigma_s;
  }

  /** The threshold of eq. 7. Chooses the chain. Default MixedThreshold::PRINTED. */
  void
  setMixedThreshold (std::optional<MixedThreshold> threshold)
  {
    mixed_threshold_ = threshold;
  }

  /** Iterations of the normal filter, range >= 0. Chooses the chain. Default 2, PAPER: 5. */
  void
  setNormalIterations (std::optional<int> iterations)
  {
    normal_iterations_ = iterations;
  }

  /** How points move. Chooses the chain. Default UpdateRule::COMPENSATED, PAPER: UpdateRule::PAPER. */
  void
  setUpdateRule (std::optional<UpdateRule> rule)
  {
    update_rule_ = rule;
  }

  /** sigma_s of eq. 9, of the point update, range > 0. Chooses the chain. Default 0.03, PAPER: 1/3. */
  void
  setUpdateSigmaS (std::optional<double> sigma_s)
  {
    update_sigma_s_ = sigma_s;
  }

  /** Iterations of the point update (2, PAPER: 7), range >= 0; rounds of DEFAULT (6) and FAST (3), range 0 to 6. */
  void
  setPointIterations (std::optional<int> iterations)
  {
    point_iterations_ = iterations;
  }

  /** Upper bound on the distance of a point from its start, in the cloud's unit, range > 0. Default, and if
    * infinite: five times the largest noise in rounds, no limit in the chain. */
  void
  setMaxDisplacement (std::optional<double> distance)
  {
    max_displacement_ = distance;
  }

  /** Neighbours of moved points are searched again after this many iterations of the point update, range >= 0. Above
    * 0 it chooses the chain, as rounds never search again. Default 0: never. */
  void
  setSearchInterval (int iterations)
  {
    search_interval_ = iterations;
  }

  /** The normals are consistently oriented: none is flipped, and two close sheets stay apart. With
    * NormalSource::INPUT only: estimated normals have arbitrary signs, and the run ends with an error. Default
    * false. */
  void
  setNormalsOriented (bool oriented)
  {
    oriented_ = oriented;
  }

  /** Standard deviation of the noise along the normal, in the cloud's unit, range >= 0, for rounds. Default: estimated
    * from the cloud, see SurfaceNoiseEstimation. */
  void
  setNoiseSigma (std::optional<double> sigma)
  {
    noise_sigma_ = sigma;
  }

  /** Whether the noise may differ from place to place, as that of scanners does: sigma is then its median over the
    * points, and its variation is estimated from the cloud. For rounds. Default: true, but false if setNoiseSigma
    * gives a single sigma. */
  void
  setNoiseVaries (std::optional<bool> varies)
  {
    noise_varies_ = varies;
  }

  /** Neighbourhoods may be too narrow to show the surface, or any noise: if points lie on the lines of a rotating
    * lidar, or in layers, as coordinates come in steps like those of depth cameras, or if the noise is wider than
    * the spacing. If the cloud shows that, they grow, with k unchanged; or, in wide noise where they would lose
    * detail, points first move onto quadrics through 32 to 128 of them. For rounds with k nearest neighbours, not if
    * a radius bounds them; wide noise is looked for only from k = 16 on. Rounding of coordinates (voxels, few
    * digits) is looked for too. Default: true. */
  void
  setWidenNeighborhoods (bool widen)
  {
    widen_neighborhoods_ = widen;
  }

  /** Distance between neighbouring points, in the cloud's unit, range >= 0, for rounds. Where neighbourhoods are
    * widened it is the larger distance between neighbours in those. Default: estimated. */
  void
  setPointSpacing (std::optional<double> spacing)
  {
    point_spacing_ = spacing;
  }

  /** A neighbour farther than this from the mean of both points' tangent planes may lie on another sheet and does
    * not count, in the cloud's unit, range >= 0, for rounds; infinity: all lie on one sheet. Default, the first that
    * applies:
    * - the cloud shows close sheets: .36 of the gap between them, at most the smaller of 4 sigma and 1.2 spacings;
    * - it shows the layers of a depth camera: infinity;
    * - FAST, except on scan lines: infinity;
    * - else D = max (4 sigma, min (4 times the largest sigma, 1.2 spacings)), or infinity if 4 times the largest
    *   sigma is more than 3 D. */
  void
  setSheetDistance (std::optional<double> distance)
  {
    sheet_distance_ = distance;
  }

  /** Seed of NormalSource::HOUGH. Default 0. */
  void
  setSeed (std::uint64_t seed)
  {
    seed_ = seed;
  }

  /** The preset with everything that was set explicitly; values to be estimated are below 0.
    * \throw core::Error if the noise, the spacing or the sheet distance was set to an invalid length, in rounds; or
    * if float cannot hold a length */
  core::SmoothingOptions
  options () const;

  /** The options of the last run, with the values estimated from the cloud; after a failed or cancelled run, as
    * constructed. Set explicitly, they give the same result; if rounds.noise.field has regions, call setNoiseVaries
    * (true) too. */
  const core::SmoothingOptions&
  usedOptions () const
  {
    return used_options_;
  }

  /** k if neither k, nor a radius, nor a graph is set: 32 for DEFAULT, 16 for FAST, 15 for the chain that replaces
    * them, 7 for PAPER. The rounds use at most the nearest 32, even if a larger k is set or a radius contains more. */
  int
  presetK () const;

protected:
  ~SmoothingSettings () = default;

  core::SmoothingOptions used_options_;

private:
  bool
  choosesChain () const;

  SmoothingPreset preset_ = SmoothingPreset::DEFAULT;
  std::optional<NormalSource> normal_source_;
  std::optional<NormalWeight> normal_weight_;
  std::optional<double> threshold_;
  std::optional<double> sigma_s_;
  std::optional<MixedThreshold> mixed_threshold_;
  std::optional<int> normal_iterations_;
  std::optional<UpdateRule> update_rule_;
  std::optional<double> update_sigma_s_;
  std::optional<int> point_iterations_;
  std::optional<double> max_displacement_;
  std::optional<double> noise_sigma_;
  std::optional<bool> noise_varies_;
  bool widen_neighborhoods_ = true;
  std::optional<double> point_spacing_;
  std::optional<double> sheet_distance_;
  int search_interval_ = 0;
  bool oriented_ = false;
  std::uint64_t seed_ = 0;
};
} // namespace pcl_normal_smoothing
