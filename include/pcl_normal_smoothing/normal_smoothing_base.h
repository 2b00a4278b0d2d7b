// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/search_settings.h>
#include <pcl_normal_smoothing/smoothing_run.h>
#include <pcl_normal_smoothing/smoothing_settings.h>

#include <functional>
#include <optional>
#include <string>

namespace pcl_normal_smoothing
{
/** The part of NormalSmoothing that is common to clouds of every kind.
  * \tparam PointT of the search object */
template <typename PointT>
class NormalSmoothingBase : public SearchSettings<PointT>, public SmoothingSettings
{
protected:
  ~NormalSmoothingBase () = default;

  void
  beginRun () override
  {
    used_options_ = {};
  }

  int
  defaultK () const override
  {
    return presetK ();
  }

  void
  checkK (int k) const override
  {
    core::checkNeighborCount (options (), k);
  }

  bool
  joinsCopies () const override
  {
    return options ().in_rounds;
  }

  /** Searches neighbours and smooths; afterwards usedOptions are those of this run.
    * \param[in] positions, normals of the whole cloud; normals for NormalSource::INPUT
    * \param[in] indices of the points to be written
    * \param[in] cloud given to the search object, if one is set
    * \throw core::Error if the settings or the cloud do not allow it */
  SmoothingRun
  runSmoothing (const std::string& class_name,
                const VectorView& positions,
                const std::optional<VectorView>& normals,
                const pcl::Indices& indices,
                const std::function<typename SearchSettings<PointT>::SearchCloudConstPtr ()>& cloud);
};
} // namespace pcl_normal_smoothing
