// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheets/sheet_detection.h"
#include "sheets/sheet_separation.h"
#include <pcl_normal_smoothing/core/smoothing.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The order in which the noise and the sheets of a cloud are estimated, each from what was before, for a cloud that is
  * seen as a whole or in tiles. */
class SmoothingPreparation
{
public:
  virtual ~SmoothingPreparation () = default;

  /** Sets what is to be estimated. Nothing changes for the paper's chain.
    * \param[in,out] options that pass check; on return without anything to estimate; widen_neighborhoods is not read */
  void
  complete (SmoothingOptions& options);

  /** \param[in] normals as for smooth; kept while the result is used */
  static SheetSeparationOptions
  separation (const SmoothingOptions& options, const Vectors& normals);

  /** Whether what was told apart is no sheets but the layers of coordinates in steps, as depth cameras give them: then
    * all lies on one sheet.
    * \param[in] before, separated the estimates before and after; sigma 0: too little is left to tell */
  static bool
  areLayers (const NoiseEstimate& before, const NoiseEstimate& separated, const SheetEstimate& sheets);

protected:
  /** With neighbourhoods as they were searched. */
  virtual NoiseEstimate
  noiseBeforeSeparation () = 0;

  virtual SheetDetection
  sheets (const SheetScales& scales) = 0;

  /** From now on neighbourhoods keep to one sheet. \return false: none changes, and noise by quadrics would be the
    * same */
  virtual bool
  separate (const SmoothingOptions& options) = 0;

  /** After separate. */
  virtual NoiseEstimate
  separatedNoise () = 0;

  /** Takes separate back. */
  virtual void
  undoSeparation () = 0;

  /** Neighbourhoods are as they were searched, and so show but a part of noise that is as wide as the points are
    * apart. */
  virtual bool
  underestimatesWideNoise () const
  {
    return true;
  }

  /** Neighbourhoods reach over the gaps between the lines of a scan, and so over edges to what lies behind. */
  virtual bool
  reachOverGaps () const
  {
    return false;
  }

private:
  /** Neighbourhoods keep to one sheet, unless what is told apart is layers.
    * \param[in] before the noise as it is known so far
    * \param[in] may_be_layers the sheets are estimated; what was told apart may be layers, which are joined again
    * \param[in,out] options the distance of the sheets becomes infinite then
    * \return the noise now; \a before where it is given, or nothing changes */
  NoiseEstimate
  keepToSheets (const NoiseEstimate& before,
                const SheetEstimate& sheets,
                bool may_be_layers,
                SmoothingOptions& options);
};
} // namespace core
} // namespace pcl_normal_smoothing
