// SPDX-License-Identifier: LGPL-2.1-or-later
// Laws that know time, in a block between walls: a Maxwell solid relaxes as its modulus does, whatever the
// scheme, and a confined block that grows presses as the closed form says; its wish for shorter steps is
// heeded and counted, and balances hold. Histories are in the snapshot, a restart repeats every bit, and a
// law without a symmetric tangent is refused.
#include "block.h"
#include "scene_of.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/constitutive/law_registry.h>
#include <softgrain/constitutive/neo_hookean.h>
#include <softgrain/model/memory_state.h>

#include <iomanip>
#include <iostream>

using namespace softgrain;

namespace
{
/// neo_hookean, but for what it says of its tangent.
template <int dim>
class Skew final : public constitutive::Law<dim>
{
public:
  std::string title() const override { return "Skew"; }
  bool symmetric_tangent() const override { return false; }
  double wave_modulus() const override { return law.wave_modulus(); }
  double poisson_ratio() const override { return law.poisson_ratio(); }
  std::size_t update(const constitutive::Inputs<dim> &in,
                     const constitutive::Outputs<dim> &out) const override
  {
    return law.update(in, out);
  }

private:
  constitutive::NeoHookean<dim> law;
};
[[maybe_unused]] const bool registered = constitutive::register_law<Skew>("skew", "For this test.");

const std::string maxwell = R"(
    set Law = maxwell
    subsection Maxwell
      set Young's modulus  = 1e6
      set Poisson's ratio  = 0.3
      set Shares           = 0.5, 0.3
      set Relaxation times = 0.5, 4
    end)";
const std::string growth = R"(
    set Law = growth
    subsection Growth
      set Young's modulus = 1e6
      set Poisson's ratio = 0.3
      set Rate            = 0.4 * t
    end)";

double column(const mpm::MpmModel &model, const std::string &wanted)
{
  for (const auto &[name, value] : model.extra_history())
    if (name == wanted)
      return value;
  return -1.;
}

double mean(const Snapshot<2> &snapshot, const std::string &name)
{
  for (const NamedField &field : snapshot.points.extra)
    if (field.name == name)
    {
      double sum = 0;
      for (const double value : field.values)
        sum += value / field.values.size();
      return sum;
    }
  return -1;
}

void relax(const std::string &scheme, const std::vector<std::string> &more)
{
  // Pressed by 5 % in the first microsecond, the sides free to move.
  std::vector<std::string> changes = {"Time/Scheme=" + scheme, "Walls/top/Drive=position",
                                      "Walls/top/Position=min(t/1e-6, 1) * 0.5e-3"};
  changes.insert(changes.end(), more.begin(), more.end());
  const auto model = scene_of_text(block(maxwell), changes);
  run_until(*model, 1e-6);
  const double at_once = model->walls()[1].normal_force;
  const Energies before = model->energies();
  std::cout << scheme << ": force / expected\n";
  const auto modulus = [](const double t) { return 0.2 + 0.5 * std::exp(-t / 0.5) + 0.3 * std::exp(-t / 4); };
  for (const double end : {0.5, 2.})
  {
    run_until(*model, end);
    const double held = end - 1e-6;
    std::cout << "  at " << end << " s: " << model->walls()[1].normal_force / (at_once * modulus(held))
              << '\n';
  }
  const Energies e = model->energies();
  std::cout << "  dissipated since / fall of the energy: "
            << (e.dissipated - before.dissipated) / (before.elastic - e.elastic) << '\n';
}
} // namespace

int main()
{
  std::cout << std::setprecision(6);
  relax("quasi_static", {});

  const auto grows = scene_of_text(block(growth, box));
  run_until(*grows, 2.);
  const double E = 1e6, nu = 0.3, lambda = E * nu / (1 + nu) / (1 - 2 * nu), mu = E / 2 / (1 + nu),
               g = std::exp(0.8);
  std::cout << "confined growth, force of the wall / expected: "
            << grows->walls()[1].normal_force / (-0.01 * g * (mu * (1 / g - 1) - lambda * std::log(g)))
            << '\n'
            << "steps cut by the law: " << (column(*grows, "law_cuts") > 0 ? "yes" : "no") << '\n';
  const Energies e = grows->energies();
  std::cout << "growth in the snapshot / expected: " << mean(grows->snapshot(), "growth") / g
            << ", energy brought in / stored: " << (e.external_work - e.dissipated) / e.elastic << '\n';

  for (const std::string &law : {maxwell, growth})
  {
    const std::vector<std::string> pressed = {"Walls/top/Drive=position", "Walls/top/Position=0.2e-3*t"};
    const auto whole = scene_of_text(block(law, box), pressed),
               half = scene_of_text(block(law, box), pressed), rest = scene_of_text(block(law, box), pressed);
    MemoryState middle;
    for (unsigned int i = 0; i < 3; ++i)
    {
      whole->advance(0.25);
      half->advance(0.25);
    }
    half->save(middle);
    rest->load(middle);
    for (unsigned int i = 0; i < 3; ++i)
    {
      whole->advance(0.25);
      rest->advance(0.25);
    }
    const Snapshot<2> a = whole->snapshot(), b = rest->snapshot();
    bool same = a.time == b.time && a.points.stress == b.points.stress && a.points.extra.size() > 0;
    for (unsigned int i = 0; i < a.points.extra.size(); ++i)
      same = same && a.points.extra[i].values == b.points.extra[i].values;
    std::cout << "restarted, " << a.points.extra.size()
              << " numbers of history, every bit the same: " << (same ? "yes" : "no") << '\n';
  }
  try
  {
    scene_of_text(block("set Law = skew", box));
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
  std::cout << "explicit steps take it: "
            << (scene_of_text(block("set Law = skew", box), {"Time/Scheme=explicit", "Time/Time step=0"})
                            ->advance(1.)
                            .dt > 0.
                    ? "yes"
                    : "no")
            << '\n';
}
