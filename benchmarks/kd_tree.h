// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds.h"

namespace pcl_normal_smoothing::benchmarks
{
/** The usual way to search: fills a pcl::search::KdTree and queries the \a k neighbours of every point. */
void
searchByKdTree (const Cloud::Ptr& cloud, int k, int threads);
} // namespace pcl_normal_smoothing::benchmarks
