// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_contact_schemes_program_bar_h
#define softgrain_tests_mpm_contact_schemes_program_bar_h

// The program itself, not a copy of its scheme: a bar of material points, one cell high and without Poisson's
// effect, meets a wall; two disks meet. With hats the bar is that of finite elements with lumped mass.
#include "../scene_of.h"
#include "impacts.h"

namespace softgrain::schemes
{
constexpr char program_scene[] = R"(
subsection Mesh
  set Lower     = -0.04, -0.03
  set Upper     = 1.04, 0.04
  set Cell size = 0.01
end
subsection Material points
  set Shape function = linear
end
subsection Materials
  set Names = gel
  subsection gel
    set Law     = linear_elastic
    set Density = 1
    subsection Linear elastic
      set Young's modulus = 1
      set Poisson's ratio = 0
    end
  end
end
subsection Bodies
  set Names = bar
  subsection bar
    set Shape    = rectangle
    set Center   = 0.5, 0.005
    set Size     = 1, 0.01
    set Velocity = -1e-3; 0
  end
end
subsection Walls
  set Names = left
end
subsection Stop
  set End time = 10
end
)";

struct ProgramImpact
{
  ImpactMeasures measures;
  unsigned int steps = 0, attempts = 0, newton_iterations = 0;
};

/// Impact of the bar in the program, @p changes as on the command line.
inline ProgramImpact
program_bar_meets_wall(const double cfl, const double phase, std::vector<std::string> changes)
{
  const double dt = cfl / n_cells, start = (1. + phase) * dt;
  const Fall fall{1., 1., 1., start * impact_speed, impact_speed, 0.};
  std::ostringstream gap, step;
  gap.precision(17);
  step.precision(17);
  gap << "Walls/left/Point=" << -fall.gap << ", 0";
  step << "Time/Time step=" << dt;
  changes.push_back(gap.str());
  changes.push_back(step.str());
  const auto model = scene_of_text(program_scene, changes);
  const mpm::Body<2> &body = model->bodies()[0];
  const double width = 0.01, end = start + 1.5 * fall.round_trip();
  const ExactBar exact(fall, end + dt);
  ProgramImpact impact{ImpactMeasures(
      {start, start + fall.round_trip(), impact_speed, 0.5 * impact_speed * impact_speed, impact_speed})};
  double momentum = body.nodes.momentum()[0];
  while (model->time() < end * (1. - 1e-9))
  {
    const double from = model->time();
    const StepReport report = model->advance(10. * dt);
    double sum = 0.;
    unsigned int n = 0;
    for (unsigned int i = 0; i < body.nodes.mass.size(); ++i)
    {
      const double x = body.field.place(i)[0];
      if (x < -1e-9 || x > 1. + 1e-9)
        continue; // control points of B-splines outside of the bar
      const double difference = body.nodes.displacement[2 * i] - exact.displacement(x, model->time());
      sum += difference * difference;
      ++n;
    }
    double gap_now = 1e300;
    const Snapshot<2> now_there = model->snapshot();
    for (const auto &outline : now_there.bodies[0].outline)
      for (const auto &place : outline)
        gap_now = std::min(gap_now, place[0] + fall.gap);
    const Energies energies = model->energies();
    const double now = body.nodes.momentum()[0];
    impact.measures.look(from, model->time(), (now - momentum) / width,
                         (energies.kinetic + energies.elastic) / width, gap_now, std::sqrt(sum / n));
    momentum = now;
    ++impact.steps;
    impact.attempts += report.attempts;
    impact.newton_iterations += report.newton_iterations;
  }
  impact.measures.restitution = momentum / width / impact_speed;
  return impact;
}

struct DiskImpact
{
  double gained = 0., kept = 0., restitution = 0., penetration = 0.; ///< as of bars; penetration in cells
  unsigned int steps = 0, newton_iterations = 0;
};

/// Two disks of gallery/two_disks.prm meet at the end of the step that @p phase says.
inline DiskImpact program_disks(const double cfl, const double phase, std::vector<std::string> changes)
{
  changes.insert(changes.end(), {"Time/CFL multiple=" + std::to_string(cfl), "Mesh/Lower=-0.0213, -0.006",
                                 "Mesh/Upper=0.0213, 0.006"});
  // The disks come from so far away that they meet within the second step.
  const double step = shipped_scene("gallery/two_disks.prm", changes)->wanted_step(),
               half_way = (1. + phase) * step;
  for (const std::string side : {"left", "right"})
  {
    std::ostringstream centre;
    centre.precision(17);
    centre << "Bodies/" << side << "/Center=" << (side == "left" ? -1. : 1.) * (5e-3 + half_way) << ", 0";
    changes.push_back(centre.str());
  }
  const auto model = shipped_scene("gallery/two_disks.prm", changes);
  const double energy = model->energies().kinetic;
  DiskImpact impact;
  run_until(*model, 1.2e-3 + half_way,
            [&](const StepReport &report)
            {
              const Energies now = model->energies();
              impact.kept = (now.kinetic + now.elastic) / energy - 1.;
              impact.gained = std::max(impact.gained, impact.kept);
              impact.penetration = std::max(impact.penetration, report.max_penetration / 6e-4);
              impact.newton_iterations += report.newton_iterations;
              ++impact.steps;
            });
  const auto &bodies = model->bodies();
  impact.restitution = 0.5 * (bodies[1].nodes.momentum()[0] / bodies[1].nodes.mass.sum() -
                              bodies[0].nodes.momentum()[0] / bodies[0].nodes.mass.sum());
  return impact;
}

/// The block of verification/sliding_block.prm on a level plane, from 0.2 m/s with friction 0.3: it stops
/// after 67 ms and 6.67 mm. @return the errors of the way, and of the velocity after 0.2 s, over that at the
/// start
inline std::pair<double, double> program_block(const double dt, const std::string &theta)
{
  const auto model =
      shipped_scene("verification/sliding_block.prm",
                    {"Loads/Gravity=0, -10", "Bodies/block/Velocity=0.2; 0", "Mesh/Cell size=2.1e-3",
                     "Time/Time step=" + std::to_string(dt), "Time/Theta=" + theta});
  run_until(*model, 0.2);
  const BodyState<2> block = model->snapshot().bodies[0];
  return {block.center[0] / (0.04 / 6.) - 1., block.velocity[0] / 0.2};
}
} // namespace softgrain::schemes

#endif
