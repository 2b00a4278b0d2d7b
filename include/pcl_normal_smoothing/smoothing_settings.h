// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/smoothing.h>

#include <optional>

namespace pcl_normal_smoothing
{
/** A set of parameters. Whatever is set explicitly holds over it, in any order. */
enum class SmoothingPreset
{
  DEFAULT, //!< the best quality: robust smoothing in rounds, by the noise that the cloud has
  FAST,    //!< the best at about a third of the cost: fewer rounds over smaller neighbourhoods
  PAPER    //!< PGU7 of Valdivia et al. 2013 with 5 normal and 7 point iterations, as on its scanned bust
};

/** The parameters of NormalSmoothing.
  *
  * The presets DEFAULT and FAST smooth in rounds, which need no parameter. Where one of the parameters of the paper's
  * chain is set (the normal filter's, the update's rule or sigma_s, or a search interval above 0), the chain runs in
  * their place: WPCA, k 15, Gaussian weights, 2 normal iterations, 2 compensated point iterations, apart from what is
  * set. Defaults of those parameters are the chain's, and PAPER's where they differ.
  *
  * Setters that take a std::optional set nothing by std::nullopt: what was set before is taken back. */
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

  /** Where the normals come from; in rounds: those of the first. Default NormalSource::WPCA, PAPER: PCA. */
  void
  setNormalSource (std::optional<NormalSource> source)
  {
    normal_source_ = source;
  }

  /** Which weight a neighbour's normal has in the filter. Chooses the chain. Default NormalWeight::GAUSSIAN. */
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

  /** No point ends farther from where it began, in the cloud's unit, range > 0. Default, and where it is infinity: five
    * times the largest noise in rounds, no limit in the chain. */
  void
  setMaxDisplacement (std::optional<double> distance)
  {
    max_displacement_ = distance;
  }

  /** Neighbours of moved points are searched anew after this many iterations of the point update, range >= 0; above 0
    * it chooses the chain, as rounds never search anew. Default 0: never. */
  void
  setSearchInterval (int iterations)
  {
    search_interval_ = iterations;
  }

  /** The normals point to the same side everywhere: nothing is flipped, and two close sheets stay apart. With
    * NormalSource::INPUT only: estimated normals have arbitrary signs, so that with them the run is an error. Default
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

  /** The noise may differ from place to place, as that of scanners does: sigma is then its median over the points, and
    * the cloud tells how it varies. For rounds. Default: true, but false where setNoiseSigma gives one sigma for
    * all. */
  void
  setNoiseVaries (std::optional<bool> varies)
  {
    noise_varies_ = varies;
  }

  /** Neighbourhoods may be too narrow to show the surface, and any noise: where points lie on the lines of a lidar that
    * turns, or in layers, for their coordinates come in steps, as those of depth cameras do, or where the noise is
    * wider than the points are apart. Where the cloud shows that, they grow, k as it is; or, in wide noise where they
    * would lose detail, points first move onto quadrics through 32 to 128 of them. For rounds, and with k nearest
    * neighbours, not where a radius bounds them; wide noise is looked for from k = 16 on. What rounding made of
    * coordinates (voxels, few digits) is looked for too. Default: true. */
  void
  setWidenNeighborhoods (bool widen)
  {
    widen_neighborhoods_ = widen;
  }

  /** Distance between neighbouring points, in the cloud's unit, range >= 0, for rounds; that of neighbours, where
    * neighbourhoods are widened. Default: estimated. */
  void
  setPointSpacing (std::optional<double> spacing)
  {
    point_spacing_ = spacing;
  }

  /** A neighbour that is farther than this from the mean of both points' tangent planes may lie on another sheet and is
    * not counted, in the cloud's unit, range >= 0, for rounds; infinity: all lie on one. Default: where the cloud shows
    * close sheets, .36 of the gap between them, at most the smaller of 4 sigma and 1.2 spacings; where it shows the
    * layers of a depth camera, infinity; else max (4 sigma, min (4 of the largest sigma, 1.2 spacings)), but infinity
    * where four of the largest sigma are more than three times that, and for FAST, but on the lines of a scan. */
  void
  setSheetDistance (std::optional<double> distance)
  {
    sheet_distance_ = distance;
  }

  /** Of NormalSource::HOUGH. Default 0. */
  void
  setSeed (std::uint64_t seed)
  {
    seed_ = seed;
  }

  /** The preset with all that was set explicitly; what the cloud has to tell is below 0.
    * \throw core::Error where the noise, the spacing or the sheet distance was set to what is no length, in rounds;
    * where float cannot hold a length */
  core::SmoothingOptions
  options () const;

  /** What the last run used, with what it estimated from the cloud; of a run that failed or was cancelled, nothing: as
    * constructed. Set explicitly, it gives the same result, where rounds.noise.field has regions with setNoiseVaries
    * (true) besides. */
  const core::SmoothingOptions&
  usedOptions () const
  {
    return used_options_;
  }

  /** k where neither k, nor a radius, nor a graph is set: 32 of DEFAULT, 16 of FAST, 15 of the chain in their place, 7
    * of PAPER. Of a larger one that is set, or of more neighbours within a radius, the rounds look at the nearest
    * 32. */
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
