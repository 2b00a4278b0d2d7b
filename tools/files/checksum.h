// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace pcl_normal_smoothing
{
namespace tools
{
/** XXH3, 64 bits: tells what chance does to bytes. */
class Checksum
{
public:
  Checksum ();
  ~Checksum ();

  void
  add (std::string_view bytes);

  std::uint64_t
  value () const;

  /** In 16 hexadecimal digits. */
  std::string
  text () const;

private:
  struct State;

  std::unique_ptr<State> state_;
};

/** Of bytes that are all there. */
std::uint64_t
checksumOf (std::string_view bytes);

/** In 16 hexadecimal digits. */
std::string
checksumText (std::uint64_t checksum);
} // namespace tools
} // namespace pcl_normal_smoothing
