// SPDX-License-Identifier: BSD-3-Clause
//
// usage: large_cloud output.pcd points
// Writes a noisy wave of this many points, in scan lines, without holding them in memory.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace
{
/** A number in [0, 1) that depends only on \a i. */
float
noise (std::uint64_t i)
{
  i = (i ^ (i >> 30)) * 0xBF58476D1CE4E5B9u;
  i = (i ^ (i >> 27)) * 0x94D049BB133111EBu;
  return static_cast<float> ((i ^ (i >> 31)) >> 40) / (1u << 24);
}
} // namespace

int
main (int argc, char** argv)
{
  if (argc != 3) {
    std::fprintf (stderr, "usage: large_cloud output.pcd points\n");
    return 1;
  }
  const std::uint64_t count = std::strtoull (argv[2], nullptr, 10);
  const auto side = static_cast<std::uint64_t> (std::ceil (std::sqrt (static_cast<double> (count))));
  std::ofstream file (argv[1], std::ios::binary);
  file << "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " << count
       << "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << count << "\nDATA binary\n";
  for (std::uint64_t i = 0; i < count; ++i) {
    const float x = 0.01f * static_cast<float> (i % side), y = 0.01f * static_cast<float> (i / side);
    const float point[3] = {x, y, std::sin (x) * std::cos (y) + 0.004f * (noise (i) + noise (i + count) - 1)};
    file.write (reinterpret_cast<const char*> (point), sizeof point);
  }
  return file.good () ? 0 : 2;
}
