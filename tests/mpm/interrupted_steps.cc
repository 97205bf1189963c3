// SPDX-License-Identifier: LGPL-2.1-or-later
// A signal ends a step at any moment, in held steps too: the state is then that before the step, bit for bit,
// and going on from there gives the run that was never stopped.
#include "scene_of.h"

#include <softgrain/base/interruption.h>
#include <softgrain/base/mpi_session.h>
#include <softgrain/base/parallel.h>
#include <softgrain/model/state_file.h>

#include <chrono>
#include <iostream>
#include <thread>

using namespace softgrain;

namespace
{
/// All that a checkpoint would hold, as text.
class Listing final : public StateWriter
{
public:
  void write(const std::string &name, const std::vector<double> &values) override { list(name, values); }
  void write(const std::string &name, const std::vector<std::uint64_t> &values) override
  {
    list(name, values);
  }
  void write(const std::string &name, const std::string &value) override { text << name << value; }

  std::ostringstream text;

private:
  template <typename T>
  void list(const std::string &name, const std::vector<T> &values)
  {
    text << std::hexfloat << name;
    for (const T &value : values)
      text << ' ' << value;
  }
};

std::string state(const mpm::MpmModel &model)
{
  Listing listing;
  model.save(listing);
  return listing.text.str();
}

void step(mpm::MpmModel &model)
{
  StepReport report = model.advance(1.);
  model.settle(report);
}

/// Asks for the end after some time; the step may have been done by then.
class Signal
{
public:
  explicit Signal(const double seconds)
      : waiting(
            [seconds]
            {
              std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
              request_interruption();
            })
  {
  }
  ~Signal()
  {
    waiting.join();
    forget_interruption();
  }

private:
  std::thread waiting;
};

void interrupt(const std::string &what, const std::vector<std::string> &changes)
{
  constexpr unsigned int n_steps = 3, n_signals = 4;
  std::vector<std::string> few = {"Packing/Number=12", "Packing/Packing fraction=0.6",
                                  "Mesh/Cell size=6.4e-4", "Walls/top/Velocity=20",
                                  "Stop/Packing fraction=0"};
  few.insert(few.end(), changes.begin(), changes.end());
  const std::string file = "gallery/thirty_grains_quasi_static_mpm.prm";
  const auto whole = shipped_scene(file, few), stopped = shipped_scene(file, few);
  unsigned int n_stopped = 0, n_changed = 0;
  for (unsigned int i = 0; i < n_steps; ++i)
  {
    const auto begin = std::chrono::steady_clock::now();
    step(*whole);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::string before = state(*stopped);
    for (unsigned int k = 0; k < n_signals; ++k)
    {
      const Signal signal((k + 0.5) / n_signals * seconds);
      try
      {
        step(*stopped);
        break; // it was done before the signal
      }
      catch (const Interrupted &)
      {
        ++n_stopped;
        n_changed += state(*stopped) != before;
      }
    }
    while (stopped->step() < whole->step())
      step(*stopped);
  }
  std::cout << what << ": interrupted more than twice " << (n_stopped > 2 ? "yes" : "no")
            << ", left something behind " << n_changed << ", in the end "
            << (state(*stopped) == state(*whole) ? "as if never stopped" : "different") << std::endl;
}
} // namespace

int main(int, char **argv)
{
  const MPISession mpi(argv);
  set_n_threads(1);
  interrupt("driven", {});
  interrupt("driven, friction", {"Contact/Friction=0.5"});
  interrupt("pressed",
            {"Mesh/Cell size=9e-4", "Walls/top/Drive=pressure", "Walls/top/Velocity=0",
             "Walls/top/Pressure=3e9*t", "Walls/right/Drive=pressure", "Walls/right/Pressure=3e9*t"});
}
