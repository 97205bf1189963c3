// SPDX-License-Identifier: LGPL-2.1-or-later
// What summary.json looks like, and that a number that is not finite is not written as one.
#include <softgrain/output/summary.h>

#include <fstream>
#include <iostream>
#include <limits>

int main()
{
  using namespace softgrain;
  Summary summary;
  summary.status = "completed";
  summary.model = "mpm";
  summary.points.name = "material_points";
  summary.steps = 100;
  summary.wall_seconds = 2;
  summary.points.number = 1000;
  summary.errors.momentum = std::numeric_limits<double>::quiet_NaN();
  summary.phases = {{"assembly", 1.5}, {"contact", 0.5}};
  summary.version = "0.1.0";
  write_summary(".", summary);
  std::cout << std::ifstream("summary.json").rdbuf() << (peak_memory() > 1000000 ? "plausible" : "too little")
            << '\n';
}
