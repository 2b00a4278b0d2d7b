// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

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

/** A number for messages: short, and not "0.000000" for what is small. */
std::string
numberText (double number);
} // namespace core
} // namespace pcl_normal_smoothing
