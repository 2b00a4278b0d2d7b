// SPDX-License-Identifier: BSD-3-Clause
#include "tool_runner.h"

#include <pcl_normal_smoothing/bilateral_normal_filter.h>
#include <pcl_normal_smoothing/hough_normal_estimation.h>
#include <pcl_normal_smoothing/normal_guided_point_update.h>
#include <pcl_normal_smoothing/wpca_normal_estimation.h>

#include <pcl/io/pcd_io.h>

#include <cmath>

using namespace pcl_normal_smoothing;

namespace
{
using Cloud = pcl::PointCloud<pcl::PointNormal>;

Cloud::Ptr
load (const std::string& path)
{
  auto cloud = pcl::make_shared<Cloud> ();
  EXPECT_EQ (pcl::io::loadPCDFile (path, *cloud), 0);
  return cloud;
}

void
expectSame (const Cloud& a, const Cloud& b)
{
  ASSERT_EQ (a.size (), b.size ());
  for (std::size_t i = 0; i < a.size (); ++i) {
    const auto same = [&] (float x, float y) { return x == y || (std::isnan (x) && std::isnan (y)); };
    for (int d = 0; d < 3; ++d) {
      EXPECT_TRUE (same (a[i].data[d], b[i].data[d])) << i;
      EXPECT_TRUE (same (a[i].data_n[d], b[i].data_n[d])) << i;
    }
    EXPECT_TRUE (same (a[i].curvature, b[i].curvature)) << i;
  }
}

class NormalTools : public ToolTest
{
protected:
  void
  SetUp () override
  {
    savePcd (makeWave (), path ("wave.pcd"));
    succeed ("pcl_wpca_normal_estimation wave.pcd wpca.pcd -k 12");
    input_ = load (path ("wpca.pcd"));
  }

  /** The result of the class for the wave, in a cloud with its points. */
  template <typename Estimation>
  Cloud
  estimated (Estimation& estimation)
  {
    auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> ();
    pcl::io::loadPCDFile (path ("wave.pcd"), *points);
    estimation.setInputCloud (points);
    estimation.setKSearch (12);
    pcl::PointCloud<pcl::Normal> normals;
    estimation.compute (normals);
    Cloud cloud;
    pcl::concatenateFields (*points, normals, cloud);
    return cloud;
  }

  Cloud::Ptr input_;
};
} // namespace

TEST_F (NormalTools, EstimatorsAreTheClasses)
{
  WPCANormalEstimation<pcl::PointXYZ, pcl::Normal> wpca;
  expectSame (*input_, estimated (wpca));
  HoughNormalEstimation<pcl::PointXYZ, pcl::Normal> hough;
  hough.setSeed (3);
  hough.setNumberOfRotations (2);
  succeed ("pcl_hough_normal_estimation wave.pcd hough.pcd -k 12 -seed 3 -rotations 2");
  expectSame (*load (path ("hough.pcd")), estimated (hough));
}

TEST_F (NormalTools, FiltersAreTheClasses)
{
  Cloud expected;
  BilateralNormalFilter<pcl::PointNormal> filter;
  filter.setInputCloud (input_);
  filter.setKSearch (9);
  filter.setNormalWeight (NormalWeight::MIXED);
  filter.setMixedThreshold (MixedThreshold::RMS);
  filter.setMaxIterations (3);
  filter.filter (expected);
  succeed ("pcl_bilateral_normal_filter wpca.pcd filtered.pcd -k 9 -weights mixed -mixed rms -normal_iterations 3");
  expectSame (*load (path ("filtered.pcd")), expected);

  NormalGuidedPointUpdate<pcl::PointNormal> update;
  update.setInputCloud (input_);
  update.setKSearch (9);
  update.setMaxIterations (3);
  update.setSigmaS (0.2);
  update.filter (expected);
  succeed ("pcl_normal_guided_point_update wpca.pcd moved.pcd -k 9 -point_iterations 3 -update_sigma_s 0.2");
  expectSame (*load (path ("moved.pcd")), expected);
}

TEST_F (NormalTools, OneAfterTheOtherIsThePipeline)
{
  succeed ("pcl_bilateral_normal_filter wpca.pcd filtered.pcd -k 12 -normal_iterations 2");
  succeed ("pcl_normal_guided_point_update filtered.pcd moved.pcd -k 12 -point_iterations 2");
  succeed ("pcl_normal_smoothing wave.pcd whole.pcd -k 12 -normals wpca -weights gaussian -normal_iterations 2 "
           "-update compensated -update_sigma_s 0.03 -sigma_s 0.3 -point_iterations 2");
  const Cloud::Ptr whole = load (path ("whole.pcd")), parts = load (path ("moved.pcd"));
  for (std::size_t i = 0; i < whole->size (); ++i)
    if (i != 7 && i != 100) {
      EXPECT_LT (((*whole)[i].getVector3fMap () - (*parts)[i].getVector3fMap ()).norm (), 1e-5f) << i;
    }
}

TEST_F (NormalTools, OtherFieldsStay)
{
  succeed ("pcl_bilateral_normal_filter wpca.pcd filtered.pcd");
  succeed ("pcl_normal_guided_point_update wpca.pcd moved.pcd");
  const tools::CloudFile wave = readPcdFile (path ("wave.pcd"));
  for (const std::string name : {"wpca.pcd", "filtered.pcd", "moved.pcd"}) {
    const tools::CloudFile out = readPcdFile (path (name));
    EXPECT_EQ (out.cloud->width, 20u);
    for (const std::string field : {"rgba", "intensity", "label", "quality", "histogram", "stamp"})
      EXPECT_EQ (bytesOf (out, field), bytesOf (wave, field)) << name << " " << field;
    EXPECT_EQ (bytesOf (out, "z") == bytesOf (wave, "z"), name != "moved.pcd") << name;
  }
  // Existing fields are overwritten, not added again.
  succeed ("pcl_hough_normal_estimation wpca.pcd hough.pcd");
  EXPECT_EQ (readPcdFile (path ("hough.pcd")).cloud->fields.size (),
             readPcdFile (path ("wpca.pcd")).cloud->fields.size ());
  EXPECT_NE (bytesOf (readPcdFile (path ("hough.pcd")), "normal_x"),
             bytesOf (readPcdFile (path ("wpca.pcd")), "normal_x"));
}

TEST_F (NormalTools, DoublePositionsFarAway)
{
  const Eigen::Vector3d far (5e6, -4e6, 3e3);
  tools::CloudFile near_wave = makeWave (pcl::PCLPointField::FLOAT64),
                   far_wave = makeWave (pcl::PCLPointField::FLOAT64, far);
  near_wave.origin = Eigen::Vector4f (0, 0, 100, 0);
  far_wave.origin = Eigen::Vector4f (5e6f, -4e6f, 3100, 0);
  savePcd (near_wave, path ("near.pcd"));
  savePcd (far_wave, path ("far.pcd"));
  for (const std::string name : {"near", "far"}) {
    succeed ("pcl_wpca_normal_estimation " + name + ".pcd " + name + "_n.pcd");
    succeed ("pcl_bilateral_normal_filter " + name + "_n.pcd " + name + "_f.pcd");
    succeed ("pcl_normal_guided_point_update " + name + "_f.pcd " + name + "_m.pcd");
  }
  const tools::CloudFile near_out = readPcdFile (path ("near_m.pcd")), far_out = readPcdFile (path ("far_m.pcd"));
  EXPECT_EQ (bytesOf (near_out, "normal_x"), bytesOf (far_out, "normal_x"));
  for (std::size_t i = 0; i < 300; ++i)
    if (i != 7 && i != 100) {
      EXPECT_LT ((positionOf (far_out, i) - far - positionOf (near_out, i)).norm (), 1e-6) << i;
    }
}
