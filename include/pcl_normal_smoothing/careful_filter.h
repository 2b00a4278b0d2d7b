// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/search_settings.h>

#include <pcl/filters/filter.h>

namespace pcl_normal_smoothing
{
/** What the filters for point types have in common: PCL's filter, with settings, that loses nothing.
  * \tparam Settings SearchSettings, or derived of it */
template <typename PointT, typename Settings = SearchSettings<PointT>>
class CarefulFilter : public pcl::Filter<PointT>, public Settings
{
public:
  using PointCloud = pcl::PointCloud<PointT>;

  /** As pcl::Filter's, with more care: on an error a cloud that is filtered in place stays as it is, and any other
    * output is empty, also where no input is set. Called through a pointer to pcl::Filter, it is PCL's: there an error
    * in place empties the cloud, and without an input the output keeps what it held.
    * \param[out] output the filtered input */
  void
  filter (PointCloud& output)
  {
    this->filterInto (this->filter_name_, this->input_.get (), output,
                      [this] (PointCloud& result) { pcl::Filter<PointT>::filter (result); });
  }
};
} // namespace pcl_normal_smoothing
