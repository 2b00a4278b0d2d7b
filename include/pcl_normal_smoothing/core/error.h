// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

namespace pcl_normal_smoothing
{
namespace core
{
/** What was asked for cannot be done: the message names the value and what to do instead. */
struct Error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** The progress callback asked to stop; nothing has been written. */
struct Cancelled : std::runtime_error
{
  Cancelled () : std::runtime_error ("cancelled by the progress callback") {}
};
} // namespace core
} // namespace pcl_normal_smoothing
