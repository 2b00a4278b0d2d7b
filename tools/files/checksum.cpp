// SPDX-License-Identifier: BSD-3-Clause
#include "checksum.h"

#include <xxhash.h>

#include <cstdint>
#include <cstdio>
#include <new>

namespace pcl_normal_smoothing
{
namespace tools
{
struct Checksum::State
{
  XXH3_state_t* xxh3 = XXH3_createState ();

  ~State ()
  {
    XXH3_freeState (xxh3);
  }
};

Checksum::Checksum () : state_ (std::make_unique<State> ())
{
  if (!state_->xxh3)
    throw std::bad_alloc ();
  XXH3_64bits_reset (state_->xxh3);
}

Checksum::~Checksum () = default;

void
Checksum::add (std::string_view bytes)
{
  XXH3_64bits_update (state_->xxh3, bytes.data (), bytes.size ());
}

std::uint64_t
Checksum::value () const
{
  return XXH3_64bits_digest (state_->xxh3);
}

std::string
Checksum::text () const
{
  return checksumText (value ());
}

std::uint64_t
checksumOf (std::string_view bytes)
{
  return XXH3_64bits (bytes.data (), bytes.size ());
}

std::string
checksumText (std::uint64_t checksum)
{
  char text[17];
  std::snprintf (text, sizeof text, "%016llx", static_cast<unsigned long long> (checksum));
  return text;
}
} // namespace tools
} // namespace pcl_normal_smoothing
