// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/core/sheets/sheet_detection.h>
#include <pcl_normal_smoothing/core/sheets/sheet_separation.h>
#include <pcl_normal_smoothing/core/smoothing.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** Lets the data tell what smoothing in rounds has to know: the layers that neighbourhoods must see past, which neighbours lie on
  * another sheet, the noise of the cloud, and what follows from it. Nothing changes for the paper's chain.
  * \param[in] normals read only for NormalSource::INPUT
  * \param[in] execution progress stands still meanwhile
  * \param[in,out] graph on return with neighbourhoods that see past layers and noise, and without neighbours on other sheets
  * \param[in,out] options that pass check; on return without anything to estimate, and widening neighbourhoods where these had to be; given
  * again, they give the same graph and positions
  * \param[in,out] positions of the nodes; where the noise is wider than the spacing their offsets change: see
  * core/noise/quadric_projection.h */
void
prepareSmoothing (const Vectors& normals,
                  const Execution& execution,
                  NeighborGraph::ConstPtr& graph,
                  SmoothingOptions& options,
                  Positions& positions);

/** The order in which the noise and the sheets of a cloud are estimated, each from what was before, for a cloud that is seen as a
  * whole or in tiles. */
class SmoothingPreparation
{
public:
  virtual ~SmoothingPreparation () = default;

  /** \param[in,out] options as for prepareSmoothing */
  void
  complete (SmoothingOptions& options);

  /** \param[in] normals as for prepareSmoothing; kept while the result is used */
  static SheetSeparationOptions
  separation (const SmoothingOptions& options, const Vectors& normals);

  /** Whether what was told apart is no sheets but the layers of coordinates in steps, as depth cameras give them: then all
    * lies on one sheet.
    * \param[in] before, separated the estimates before and after; sigma 0: too little is left to tell */
  static bool
  areLayers (const NoiseEstimate& before, const NoiseEstimate& separated, const SheetEstimate& sheets);

protected:
  /** With neighbourhoods as they were searched. */
  virtual NoiseEstimate
  noiseBeforeSeparation () = 0;

  virtual SheetDetection
  sheets (const SheetScales& scales) = 0;

  /** From now on neighbourhoods keep to one sheet. \return false: none changes, and noise by quadrics would be the same */
  virtual bool
  separate (const SmoothingOptions& options) = 0;

  /** After separate. */
  virtual NoiseEstimate
  separatedNoise () = 0;

  /** Takes separate back. */
  virtual void
  undoSeparation () = 0;

  /** Neighbourhoods are as they were searched, and so show but a part of noise that is as wide as the points are apart. */
  virtual bool
  underestimatesWideNoise () const
  {
    return true;
  }

private:
  /** \return the noise now that neighbourhoods keep to one sheet
    * \param[in] may_be_layers the sheets are estimated; what was told apart may be layers, which are joined again
    * \param[in,out] options the distance of the sheets becomes infinite then */
  NoiseEstimate
  noiseOfSheets (const NoiseEstimate& before,
                 const SheetEstimate& sheets,
                 bool may_be_layers,
                 SmoothingOptions& options);
};
} // namespace core
} // namespace pcl_normal_smoothing
