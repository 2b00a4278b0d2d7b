// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sheets/sheet_detection.h"
#include "sheets/sheet_separation.h"
#include <pcl_normal_smoothing/core/smoothing.h>

namespace pcl_normal_smoothing
{
namespace core
{
/** The order in which noise and sheets of a cloud are estimated, each from what is known before; for clouds
  * processed as a whole and in tiles. */
class SmoothingPreparation
{
public:
  virtual ~SmoothingPreparation () = default;

  /** Sets everything that is to be estimated. Changes nothing for the paper's chain.
    * \param[in,out] options that pass check; on return nothing is left to estimate; widen_neighborhoods is not read */
  void
  complete (SmoothingOptions& options);

  /** \param[in] normals as for smooth; kept while the result is used */
  static SheetSeparationOptions
  separation (const SmoothingOptions& options, const Vectors& normals);

  /** Whether what was separated is not sheets but the layers of coordinates in steps, as from depth cameras: then all
    * points lie on one sheet.
    * \param[in] before, separated the estimates before and after; an empty one (spacing 0) decides nothing */
  static bool
  areLayers (const NoiseEstimate& before, const NoiseEstimate& separated, const SheetEstimate& sheets);

protected:
  /** In neighbourhoods as they were searched. */
  virtual NoiseEstimate
  noiseBeforeSeparation () = 0;

  virtual SheetDetection
  sheets (const SheetScales& scales) = 0;

  /** From now on neighbourhoods keep to one sheet. \return false if none changes, so that the noise estimate would
    * be the same */
  virtual bool
  separate (const SmoothingOptions& options) = 0;

  /** After a call of separate. */
  virtual NoiseEstimate
  separatedNoise () = 0;

  /** Undoes separate. */
  virtual void
  undoSeparation () = 0;

  /** Whether neighbourhoods are as they were searched, and so show only a part of noise as wide as the spacing. */
  virtual bool
  underestimatesWideNoise () const
  {
    return true;
  }

  /** Whether neighbourhoods reach over the gaps between scan lines, and hence over edges to what lies behind. */
  virtual bool
  reachOverGaps () const
  {
    return false;
  }

private:
  /** Makes neighbourhoods keep to one sheet, unless what is separated are layers.
    * \param[in] before the noise as known so far
    * \param[in] may_be_layers the sheets are estimated, so they may be layers, which are joined again
    * \param[in,out] options in that case the sheet distance becomes infinite
    * \return the noise now; \a before if that is given or nothing changes */
  NoiseEstimate
  keepToSheets (const NoiseEstimate& before,
                const SheetEstimate& sheets,
                bool may_be_layers,
                SmoothingOptions& options);
};
} // namespace core
} // namespace pcl_normal_smoothing
