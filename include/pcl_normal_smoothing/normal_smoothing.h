// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_normal_smoothing/careful_filter.h>
#include <pcl_normal_smoothing/input_normals.h>
#include <pcl_normal_smoothing/normal_smoothing_base.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <pcl/point_types.h>

namespace pcl_normal_smoothing
{
/** Smooths a noisy point-sampled surface without rounding its edges: estimates normals, filters them, moves the points
  * to fit them. After Valdivia, Cedrim, Petronetto, Paiva and Nonato, "Normal Correction Towards Smoothing Point-based
  * Surfaces" (SIBGRAPI 2013); SmoothingPreset::PAPER is their method.
  *
  * Reads xyz (and, for NormalSource::INPUT, the normals of the points or of setInputNormals); writes xyz, and the
  * normals that the points fit if PointT has them. Everything else stays: all other fields, the number and order of
  * points, the organisation; a point that is not finite stays as it is and is no point's neighbour. With setIndices
  * the whole cloud is smoothed and the indexed points are written.
  *
  * In rounds, points in exactly one place count once and move together, unless the neighbour graph that is set has a
  * node for each.
  *
  * If no k, radius or graph is set, the preset chooses k; a k that is set must be at least 7 in rounds, in the chain
  * 4 for WPCA and 3 for PCA and Hough. The result is bit for bit the same for any number of threads. On an error the
  * output is empty, see filter and getErrorMessage. */
template <typename PointT>
class NormalSmoothing : public CarefulFilter<PointT, NormalSmoothingBase<PointT>>, public InputNormals
{
public:
  using Ptr = pcl::shared_ptr<NormalSmoothing<PointT>>;
  using ConstPtr = pcl::shared_ptr<const NormalSmoothing<PointT>>;
  using PointCloud = pcl::PointCloud<PointT>;

  NormalSmoothing ()
  {
    this->filter_name_ = "NormalSmoothing";
  }

protected:
  /** \param[out] output the smoothed input */
  void
  applyFilter (PointCloud& output) override;
};

/** The same for a cloud with any fields: reads and writes x y z, float or double; every other field stays byte for
  * byte. Fields normal_x normal_y normal_z are read for NormalSource::INPUT, and written with setSaveNormals. */
template <>
class PCL_EXPORTS NormalSmoothing<pcl::PCLPointCloud2> : public pcl::Filter<pcl::PCLPointCloud2>,
                                                         public NormalSmoothingBase<pcl::PointXYZ>
{
public:
  using Ptr = pcl::shared_ptr<NormalSmoothing<pcl::PCLPointCloud2>>;
  using ConstPtr = pcl::shared_ptr<const NormalSmoothing<pcl::PCLPointCloud2>>;

  NormalSmoothing ()
  {
    filter_name_ = "NormalSmoothing";
  }

  /** Whether the normals that the points fit are written to the fields normal_x normal_y normal_z, which the input
    * must have. Default false. */
  void
  setSaveNormals (bool save)
  {
    save_normals_ = save;
  }

  bool
  getSaveNormals () const
  {
    return save_normals_;
  }

  /** Like pcl::Filter::filter, but on an error a cloud filtered in place stays as it is, and any other output is empty,
    * also if no input is set. Called through a pointer to pcl::Filter, PCL's version runs: there an error in place
    * empties the cloud, and without an input the output keeps its content.
    * \param[out] output the smoothed input */
  void
  filter (pcl::PCLPointCloud2& output)
  {
    this->filterInto (this->filter_name_, this->input_.get (), output,
                      [this] (pcl::PCLPointCloud2& result) { runInto (result); });
  }

protected:
  void
  applyFilter (pcl::PCLPointCloud2& output) override;

private:
  /** Does what pcl::Filter::filter does with an output that is not the input. Calling that would make every program
    * load libpcl_filters, which takes two thirds of a tool's start-up time. */
  void
  runInto (pcl::PCLPointCloud2& output)
  {
    if (!initCompute ())
      return;
    applyFilter (output);
    deinitCompute ();
  }

  void
  smooth (pcl::PCLPointCloud2& output);

  bool save_normals_ = false;
};
} // namespace pcl_normal_smoothing

#ifdef PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/impl/normal_smoothing.hpp>
#endif
