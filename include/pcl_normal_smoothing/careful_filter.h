// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/search_settings.h>

#include <pcl/filters/filter.h>

namespace pcl_normal_smoothing
{
/** The common part of the filters for point types: PCL's filter with settings, but without loss of data.
  * \tparam Settings SearchSettings, or derived from it */
template <typename PointT, typename Settings = SearchSettings<PointT>>
class CarefulFilter : public pcl::Filter<PointT>, public Settings
{
public:
  using PointCloud = pcl::PointCloud<PointT>;

  /** Like pcl::Filter::filter, but on an error a cloud filtered in place stays as it is, and any other output is empty,
    * also if no input is set. Called through a pointer to pcl::Filter, PCL's version runs: there an error in place
    * empties the cloud, and without an input the output keeps its content.
    * \param[out] output the filtered input */
  void
  filter (PointCloud& output)
  {
    this->filterInto (this->filter_name_, this->input_.get (), output,
                      [this] (PointCloud& result) { pcl::Filter<PointT>::filter (result); });
  }
};
} // namespace pcl_normal_smoothing
