// SPDX-License-Identifier: BSD-3-Clause
#include "point_file.h"
#include "worker_methods.h"

#include <cstdio>
#include <exception>
#include <stdexcept>

using namespace pcl_normal_smoothing::evaluation;

namespace
{
using Method = WorkerPoints (*) (const WorkerPoints&, const WorkerValues&);

const std::map<std::string, Method> methods {{"LOP", smoothWithLop},
                                             {"WLOP", smoothWithWlop},
                                             {"CGAL jet", smoothWithJets},
                                             {"CGAL bilateral", smoothBilaterally},
                                             {"PCL MLS", smoothWithMovingLeastSquares}};

WorkerValues
readValues (int count, char** texts)
{
  WorkerValues values;
  for (int i = 0; i < count; ++i) {
    const std::string text = texts[i];
    const auto sign = text.find ('=');
    if (sign == std::string::npos)
      throw std::runtime_error (text + " is not of the form name=value");
    values[text.substr (0, sign)] = std::stod (text.substr (sign + 1));
  }
  return values;
}

/** Converts the lengths among the values from spacings to the cloud's unit. */
void
scaleLengths (WorkerValues& values, double spacing)
{
  for (const char* name : {"radius", "h"})
    if (const auto value = values.find (name); value != values.end ())
      value->second *= spacing;
}

void
smooth (int argc, char** argv)
{
  const std::string method = argv[1], input = argv[2], output = argv[3];
  WorkerValues values = readValues (argc - 4, argv + 4);
  const WorkerPoints points = readPoints (input);
  scaleLengths (values, averageSpacing (points));
  const auto found = methods.find (method);
  if (found == methods.end ())
    throw std::runtime_error ("there is no method named " + method);
  writePoints (output, found->second (points, values));
}
} // namespace

int
main (int argc, char** argv)
{
  if (argc < 4) {
    std::fputs ("Smooths points by a method of another library, for pcl_smoothing_study.\n"
                "usage: pcl_smoothing_peer method input output [name=value ...]\n",
                stderr);
    return 1;
  }
  try {
    smooth (argc, argv);
    return 0;
  }
  catch (const std::exception& error) {
    std::fprintf (stderr, "%s\n", error.what ());
    return 1;
  }
}
