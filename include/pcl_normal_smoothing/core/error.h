// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
/** A request cannot be met: the message names the value and what to do instead. */
struct Error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/** The progress callback asked to stop; nothing has been written. */
struct Cancelled : std::runtime_error
{
  Cancelled () : std::runtime_error ("cancelled by the progress callback") {}
};

/** A number for messages: short, and without rounding small values to "0.000000". */
std::string
numberText (double number);
} // namespace core
} // namespace pcl_normal_smoothing
