// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/normal_smoothing.h>
#include <pcl_normal_smoothing_ros/NormalSmoothingConfig.h>

#include <pcl_ros/filters/filter.h>

namespace pcl_normal_smoothing_ros
{
/** Smooths the clouds from ~input and publishes them on ~output, with all their fields, their frame and their stamp;
  * ~indices, queues and TF frames work as in every filter of pcl_ros. On an error the published cloud is empty, and the
  * log gives the reason. */
class NormalSmoothing : public pcl_ros::Filter
{
protected:
  bool
  child_init (ros::NodeHandle& node, bool& has_service) override;

  void
  filter (const PointCloud2::ConstPtr& input, const IndicesPtr& indices, PointCloud2& output) override;

private:
  void
  configure (const NormalSmoothingConfig& config);

  boost::shared_ptr<dynamic_reconfigure::Server<NormalSmoothingConfig>> server_;
  pcl_normal_smoothing::NormalSmoothing<pcl::PCLPointCloud2> smoothing_;
};
} // namespace pcl_normal_smoothing_ros
