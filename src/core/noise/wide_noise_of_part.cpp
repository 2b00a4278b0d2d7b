// SPDX-License-Identifier: BSD-3-Clause
#include "wide_noise_of_part.h"

#include "../nodes_where.h"
#include "../quantile.h"
#include "local_residuals.h"
#include "noise_field_estimate.h"
#include "noise_of_sample.h"
#include "noise_reach.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Ratios of LocalResiduals. The first is that of noise of .7 spacings, with residuals of .85 of it; larger noise, half
// or more of it hidden, has at most .8. Below the second, residuals show nearly all of the noise.
constexpr double hidden_ratio = .6, shown_ratio = .45;
// Upper bounds on the growth of residuals by a halving, for medians of 48 points. Residuals of noise grow up to 1.27
// times, and hardly once it is shown; those of detail twofold and more.
constexpr double max_growth = 1.5, max_growth_shown = 1.25;
// Two sheets look like hidden noise, but their heights are bimodal. For the 32 nearest, medians over neighbouring
// places are .42 for noise, .35 to .54 at single places, and .5 to .77 for thin walls. The first bound is for all
// places where noise is shown, the second for one.
constexpr float max_bimodality = .46f, max_bimodality_of_place = .55f;
// Noise that was never hidden must show within this many halvings to be told from detail; and it may grow less, as
// nothing is at stake but an underestimated sigma.
constexpr int most_halvings_to_show = 3;
constexpr double max_growth_plain = 1.15, max_growth_plain_of_two = 1.2;
// Of a sample of 4,096; fewer places than a neighbourhood has points may be there by chance.
constexpr std::size_t least_part = 32;
constexpr std::size_t region_size = 16; // small, as values are medians already
// Below 0: the field averages over regions, and near places should not grow for the sake of far ones.
constexpr float halvings_beside = -1;
constexpr double min_variation = 1.8; // ratio of sigmas; even noise seems to vary by 1.6

/** The noise of a place, as shown after that number of halvings; sigma 0 if it is not shown. */
struct ShownNoise
{
  int halvings = 0;
  float sigma = 0;
};

/** sigma, corrected for what quadrics through 16 points follow: fitted, for ratios up to shown_ratio. */
float
sigmaOfShown (const LocalResiduals& residuals, std::size_t s)
{
  const double above = std::max (0.0, residuals.ratio (s) - .3);
  return static_cast<float> (residuals.sigmas[s] / (1 - 1.7 * above * above));
}

bool
isHidden (LocalResidualsOfCloud& cloud, std::size_t s)
{
  return cloud.after (0).ratio (s) >= hidden_ratio;
}

/** A quick check. */
bool
mayHideNoise (const NoiseSample& sample)
{
  const auto hidden = nodesWhere (sample.of_nodes.size (), [&] (std::size_t s) {
    const NoiseSample::Residuals& residuals = sample.of_nodes[s];
    return sigmaOfLargest (residuals) > hidden_ratio * spacingAt (residuals);
  });
  return hidden.size () >= least_part;
}

/** The noise of a place where it is hidden; not shown if there is detail, or if no number of halvings shows a
  * surface. */
ShownNoise
hiddenNoise (LocalResidualsOfCloud& cloud, std::size_t s)
{
  for (int halvings = 1; halvings < cloud.mostHalvings (); ++halvings) {
    const LocalResiduals& shown = cloud.after (halvings);
    if (shown.growthFrom (cloud.after (halvings - 1), s) > max_growth)
      break;
    if (shown.ratio (s) < shown_ratio)
      return cloud.after (halvings + 1).growthFrom (shown, s) < max_growth_shown
                 ? ShownNoise {halvings, sigmaOfShown (shown, s)}
                 : ShownNoise ();
  }
  return {};
}

/** \return sigma of a place where little or nothing is hidden; 0 if there is detail */
float
plainSigma (LocalResidualsOfCloud& cloud, std::size_t s)
{
  for (int halvings = 0; halvings < std::min (most_halvings_to_show, cloud.mostHalvings () - 1); ++halvings)
    if (const LocalResiduals& shown = cloud.after (halvings); shown.ratio (s) < shown_ratio)
      return cloud.after (halvings + 1).growthFrom (shown, s) < max_growth_plain &&
                     cloud.after (halvings + 2).growthFrom (shown, s) < max_growth_plain_of_two
                 ? sigmaOfShown (shown, s)
                 : 0;
  return 0;
}

/** Bimodality of the heights around places where noise is shown, after the halvings that show it; 0 at other places. */
std::vector<float>
bimodalities (const std::vector<ShownNoise>& noise, const ThinnedNoise& thinned)
{
  std::vector<float> of_places (noise.size ());
  for (int halvings = 1; halvings < thinned.mostHalvings (); ++halvings) {
    const auto shown = nodesWhere (noise.size (), [&] (std::size_t s) { return noise[s].halvings == halvings; });
    if (shown.empty ())
      continue;
    const std::vector<Differences> differences = thinned.differencesAfter (halvings);
    for (const std::uint32_t s : shown)
      of_places[s] = static_cast<float> (bimodality (differences[s]));
  }
  return of_places;
}

/** The median, by sigma, of the noise at some places, at least one. */
ShownNoise
usualNoise (const std::vector<std::uint32_t>& places, const std::vector<ShownNoise>& noise)
{
  std::vector<ShownNoise> shown;
  for (const std::uint32_t s : places)
    shown.push_back (noise[s]);
  const auto middle = shown.begin () + static_cast<std::ptrdiff_t> (shown.size () / 2);
  std::nth_element (shown.begin (), middle, shown.end (), [] (const ShownNoise& a, const ShownNoise& b) {
    return std::make_pair (a.sigma, a.halvings) < std::make_pair (b.sigma, b.halvings);
  });
  return *middle;
}

float
medianOf (const std::vector<std::uint32_t>& places, const std::vector<float>& values)
{
  std::vector<float> of_places;
  for (const std::uint32_t s : places)
    of_places.push_back (values[s]);
  return quantile (of_places, .5);
}

/** The hidden noise at the places of the sample; sigma 0 where nothing is hidden. */
std::vector<ShownNoise>
hiddenNoise (LocalResidualsOfCloud& cloud, const ThinnedNoise& thinned)
{
  std::vector<ShownNoise> noise (cloud.size ()), usual (cloud.size ());
  const auto hidden = nodesWhere (cloud.size (), [&] (std::size_t s) { return isHidden (cloud, s); });
  if (hidden.size () < least_part)
    return usual;
  for (const std::uint32_t s : hidden)
    noise[s] = hiddenNoise (cloud, s);
  const auto isShown = [&noise] (std::size_t s) { return noise[s].sigma > 0; };
  const std::vector<float> of_heights = bimodalities (noise, thinned);
  std::vector<float> around_shown;
  for (const std::uint32_t s : hidden) {
    std::vector<std::uint32_t> shown = cloud.around (s);
    shown.erase (std::remove_if (shown.begin (), shown.end (), [&] (auto other) { return !isShown (other); }),
                 shown.end ());
    if (3 * shown.size () < cloud.around (s).size ())
      continue; // few of them, hence by chance
    around_shown.push_back (medianOf (shown, of_heights));
    if (around_shown.back () < max_bimodality_of_place)
      usual[s] = usualNoise (shown, noise);
  }
  return quantile (around_shown, .5) < max_bimodality ? usual : std::vector<ShownNoise> (cloud.size ());
}

/** halvingsWithoutLoss of noise_reach.h for the places that hide noise. */
int
halvingsWithoutLoss (LocalResidualsOfCloud& cloud, const std::vector<ShownNoise>& noise)
{
  int without_loss = 0;
  for (; without_loss < most_halvings_without_loss; ++without_loss) {
    std::vector<float> growths;
    for (std::size_t s = 0; s < noise.size (); ++s)
      if (const int wider = noise[s].halvings + without_loss + 1; noise[s].sigma > 0 && wider <= cloud.mostHalvings ())
        growths.push_back (static_cast<float> (cloud.after (wider).growthFrom (cloud.after (noise[s].halvings), s)));
    if (growths.empty () || quantile (growths, .5) > max_growth_without_loss)
      break;
  }
  return without_loss;
}

/** Sigma over the cloud's spacing on the surface, derived from the thinned cloud: inside a ball of noise the nearest
  * are farther apart. */
float
ratioToSpacing (const ShownNoise& noise, LocalResidualsOfCloud& cloud, std::size_t s)
{
  const float of_thinned = cloud.after (noise.halvings).spacings[s];
  return noise.sigma / of_thinned * std::exp2 (.5f * static_cast<float> (noise.halvings));
}

/** Sigma at the places of the sample, hidden or not. */
std::vector<LocalValue>
sigmasOf (const std::vector<ShownNoise>& hidden, const NoiseSample& sample, LocalResidualsOfCloud& cloud)
{
  const NoiseEstimate unthinned = noiseOfSample (sample);
  std::vector<LocalValue> sigmas;
  for (std::size_t s = 0; s < hidden.size (); ++s) {
    const Eigen::Vector3f& place = sample.of_nodes[s].place;
    const float read = unthinned.sigma * unthinned.field.factorAt (place);
    sigmas.push_back ({place, hidden[s].sigma > 0 ? hidden[s].sigma : std::max (plainSigma (cloud, s), read)});
  }
  return sigmas;
}

/** Number of halvings of the cloud needed at the places of the sample. */
std::vector<LocalValue>
halvingsOf (const std::vector<ShownNoise>& hidden,
            const NoiseSample& sample,
            std::uint32_t row_length,
            LocalResidualsOfCloud& cloud)
{
  std::vector<LocalValue> ratios;
  for (std::size_t s = 0; s < hidden.size (); ++s)
    ratios.push_back ({sample.of_nodes[s].place, hidden[s].sigma > 0 ? ratioToSpacing (hidden[s], cloud, s) : 0});
  std::vector<LocalValue> halvings = halvingsToReach (halvingsWithoutLoss (cloud, hidden), ratios, row_length);
  for (std::size_t s = 0; s < hidden.size (); ++s)
    if (!(hidden[s].sigma > 0))
      halvings[s].value = halvings_beside;
  return halvings;
}

/** Whether the noise varies enough; wide noise that is the same everywhere is sought in wide_noise.cpp. */
bool
varies (const std::vector<float>& sigmas)
{
  return quantile (sigmas, .95) > min_variation * quantile (sigmas, .05);
}
} // namespace

WideNoise
wideNoiseOfPart (ThinnedNoise& thinned, const Execution& execution)
{
  const NoiseSample& sample = thinned.sample (0);
  const float spacing = thinned.noise (0).spacing;
  if (!(spacing > 0) || sample.short_rows > 0 || sample.of_nodes.size () < LocalResidualsOfCloud::points_of_median ||
      !mayHideNoise (sample))
    return {};
  LocalResidualsOfCloud cloud (thinned, execution);
  const std::vector<ShownNoise> hidden = hiddenNoise (cloud, thinned);
  if (nodesWhere (hidden.size (), [&] (std::size_t s) { return hidden[s].sigma > 0; }).size () < least_part)
    return {};
  const std::vector<LocalValue> sigmas = sigmasOf (hidden, sample, cloud);
  std::vector<float> values;
  for (const LocalValue& sigma : sigmas)
    values.push_back (sigma.value);
  WideNoise noise;
  noise.sigma = quantile (values, .5);
  if (!(noise.sigma > 0) || !varies (values)) // most of the cloud is clean, or the noise is the same everywhere
    return {};
  noise.field = relativeField (regionalMedians (sigmas, spacing, region_size), noise.sigma);
  noise.halvings = regionalMedians (halvingsOf (hidden, sample, thinned.rowLength (), cloud), spacing, region_size);
  noise.is_everywhere = false;
  return noise;
}
} // namespace core
} // namespace pcl_normal_smoothing
