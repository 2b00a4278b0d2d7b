// SPDX-License-Identifier: BSD-3-Clause
#include "normal_smoothing_nodelet.h"

#include <pcl_conversions/pcl_conversions.h>
#include <pluginlib/class_list_macros.hpp>

namespace pcl_normal_smoothing_ros
{
using Smoothing = pcl_normal_smoothing::NormalSmoothing<pcl::PCLPointCloud2>;

namespace
{
/** Sets only those parameters that are not left to the preset or to the cloud. */
Smoothing
smoothingFor (const NormalSmoothingConfig& config)
{
  Smoothing smoothing;
  smoothing.setPreset (static_cast<pcl_normal_smoothing::SmoothingPreset> (config.preset));
  smoothing.setKSearch (config.radius_search > 0 ? 0 : config.k_search);
  smoothing.setRadiusSearch (config.radius_search);
  smoothing.setMaxNeighborDistance (config.max_neighbor_distance);
  smoothing.setNumberOfThreads (static_cast<unsigned> (config.threads));
  if (config.point_iterations >= 0)
    smoothing.setPointIterations (config.point_iterations);
  if (config.noise_sigma >= 0)
    smoothing.setNoiseSigma (config.noise_sigma);
  if (config.noise_varies >= 0)
    smoothing.setNoiseVaries (config.noise_varies == 1);
  smoothing.setWidenNeighborhoods (config.widen_neighborhoods);
  if (config.point_spacing >= 0)
    smoothing.setPointSpacing (config.point_spacing);
  if (config.sheet_distance >= 0)
    smoothing.setSheetDistance (config.sheet_distance);
  if (config.max_displacement > 0)
    smoothing.setMaxDisplacement (config.max_displacement);
  return smoothing;
}
} // namespace

bool
NormalSmoothing::child_init (ros::NodeHandle& node, bool& has_service)
{
  has_service = true;
  server_ = boost::make_shared<dynamic_reconfigure::Server<NormalSmoothingConfig>> (node);
  server_->setCallback ([this] (const NormalSmoothingConfig& config, std::uint32_t) { configure (config); });
  return true;
}

void
NormalSmoothing::configure (const NormalSmoothingConfig& config)
{
  const boost::mutex::scoped_lock lock (mutex_);
  smoothing_ = smoothingFor (config);
  tf_input_frame_ = config.input_frame;
  tf_output_frame_ = config.output_frame;
}

void
NormalSmoothing::filter (const PointCloud2::ConstPtr& input, const IndicesPtr& indices, PointCloud2& output)
{
  const boost::mutex::scoped_lock lock (mutex_);
  auto cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
  pcl_conversions::toPCL (*input, *cloud);
  smoothing_.setInputCloud (cloud);
  smoothing_.setIndices (indices ? pcl::make_shared<pcl::Indices> (*indices) : pcl::IndicesPtr ());
  pcl::PCLPointCloud2 smoothed;
  smoothing_.filter (smoothed);
  if (!smoothing_.getErrorMessage ().empty ())
    NODELET_ERROR ("[%s] %s", getName ().c_str (), smoothing_.getErrorMessage ().c_str ());
  pcl_conversions::moveFromPCL (smoothed, output);
  output.header = input->header; // PCL's header has no nanoseconds
}
} // namespace pcl_normal_smoothing_ros

PLUGINLIB_EXPORT_CLASS (pcl_normal_smoothing_ros::NormalSmoothing, nodelet::Nodelet)
