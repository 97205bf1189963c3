// SPDX-License-Identifier: LGPL-2.1-or-later
// Rows of the history, fields that are not finite, continuing after a cut, and refusing other columns and two
// of one name.
#include <softgrain/base/exceptions.h>
#include <softgrain/output/history.h>

#include <fstream>
#include <iostream>
#include <limits>

namespace
{
softgrain::HistoryRow row(const double time, const double step, const double force)
{
  return {{"time_s", time}, {"step", step}, {"dt_s", 0.5}, {"top_force_N_per_m", force}};
}

void show()
{
  std::cout << std::ifstream("history.csv").rdbuf() << '\n';
}
} // namespace

int main()
{
  using namespace softgrain;
  {
    HistoryWriter history(".");
    history.resume(7); // nothing is there yet
    history.write(row(0, 0, std::numeric_limits<double>::quiet_NaN()));
    history.write(row(0.5, 1, -1. / 3));
    history.write(row(1, 2, std::numeric_limits<double>::infinity()));
    show();
  }
  std::ofstream("history.csv", std::ios::app) << "1.5,3,0.";
  HistoryWriter history(".");
  history.resume(1);
  history.write(row(1, 2, 1e-20));
  show();
  // A row of the state that the run goes on from stays until the next one takes its place.
  {
    HistoryWriter from_two(".");
    from_two.resume(2, {}, false);
    show();
    from_two.write(row(1.5, 3, 7));
    show();
  }
  // A table whose first line was being written when the program died has no rows yet.
  std::ofstream("new.csv") << "time_s,ste";
  HistoryWriter begun(".", "new.csv");
  begun.resume(1);
  std::cout << "new: " << begun.is_new() << "\n\n";
  for (const unsigned int wrong : {0, 1, 2})
    try
    {
      if (wrong == 0)
        HistoryWriter(".", "twice.csv")
            .write({{"time_s", 0.}, {"step", 3.}, {"a", 1.}, {"b", 2.}, {"a", 3.}});
      else if (wrong == 1)
        history.write({{"time_s", 0.}, {"step", 3.}});
      else
      {
        std::ofstream("history.csv") << "a,b\n1,2\n";
        HistoryWriter(".").resume(1);
      }
    }
    catch (const InputError &error)
    {
      std::cout << error.what() << '\n';
    }
}
