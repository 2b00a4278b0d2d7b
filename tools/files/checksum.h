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
/** XXH3 with 64 bits: detects accidental changes. */
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

/** Checksum of bytes in memory. */
std::uint64_t
checksumOf (std::string_view bytes);

/** In 16 hexadecimal digits. */
std::string
checksumText (std::uint64_t checksum);
} // namespace tools
} // namespace pcl_normal_smoothing
