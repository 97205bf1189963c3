// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_app_stub_model_h
#define softgrain_tests_app_stub_model_h

// The smallest model that a run can be made of: every body is one mass on a spring, walls follow their
// formulas. The midpoint rule keeps its energy to rounding.
#include <softgrain/app/command_line.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/geometry/shape.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/model/state_file.h>
#include <softgrain/scene/wall_drive.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iostream>
#include <sstream>

namespace softgrain
{
class StubModel : public Model<2>
{
public:
  StubModel(const Scene<2> &scene, const double dt, const unsigned int fails_at, const unsigned int stops_at)
      : scene(scene), dt(dt), fails_at(fails_at), stops_at(stops_at)
  {
    for (const WallDescription<2> &wall : scene.walls)
    {
      WallState<2> state;
      state.name = wall.name;
      state.point = wall.point;
      state.normal = wall.normal;
      state.position = wall.normal[0] != 0 ? wall.point[0] : wall.point[1];
      wall_states.push_back(state);
    }
  }

  /// Its walls stand whatever drives them.
  void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &) override {}
  std::string name() const override { return "stub"; }

  StepReport advance(const double dt_limit) override
  {
    if (n_steps + 1 == fails_at)
      throw ComputationError("body 'a': the step failed at t = " + std::to_string(t) + " s");
    if (n_steps + 1 == stops_at)
      std::raise(SIGTERM);
    StepReport report;
    report.dt = std::min(dt, dt_limit);
    const double h = report.dt / 2, denominator = 1 + h * h;
    const double x_new = ((1 - h * h) * x + 2 * h * v) / denominator;
    v = ((1 - h * h) * v - 2 * h * x) / denominator;
    x = x_new;
    for (unsigned int w = 0; w < wall_states.size(); ++w)
    {
      wall_states[w].velocity = scene.walls[w].drive->demand({t, 0., 0.}).velocity;
      wall_states[w].point += report.dt * wall_states[w].velocity * wall_states[w].normal;
      wall_states[w].position =
          wall_states[w].normal[0] != 0 ? wall_states[w].point[0] : wall_states[w].point[1];
    }
    t += report.dt;
    ++n_steps;
    report.newton_iterations = 2;
    report.contact_residual = 1e-12 * n_steps;
    return report;
  }

  double time() const override { return t; }
  std::size_t step() const override { return n_steps; }

  Snapshot<2> snapshot() const override
  {
    Snapshot<2> result;
    result.time = t;
    result.step = n_steps;
    for (const BodyDescription<2> &description : scene.bodies)
    {
      BodyState<2> body;
      body.name = description.name;
      body.outline = description.shape->outline(0.1);
      body.area = body.reference_area = body.mass = description.shape->area();
      body.center = description.center;
      result.bodies.push_back(body);
    }
    result.walls = wall_states;
    result.energies = energies();
    return result;
  }

  std::vector<WallState<2>> walls() const override { return wall_states; }

  Energies energies() const override
  {
    Energies result;
    result.kinetic = v * v / 2;
    result.elastic = x * x / 2;
    return result;
  }

  double solid_area() const override
  {
    double sum = 0;
    for (const BodyDescription<2> &body : scene.bodies)
      sum += body.shape->area();
    return sum;
  }

  double coordination() const override { return 0; }
  double momentum_error() const override { return 0; }
  std::size_t n_points() const override { return scene.bodies.size(); }
  std::size_t n_bodies() const override { return scene.bodies.size(); }
  SizeReport size_report() const override { return {{"time step", std::to_string(dt) + " s"}}; }
  std::vector<std::pair<std::string, double>> extra_history() const override { return {{"spring_m", x}}; }
  std::map<std::string, double> phases() const override { return {{"spring", 0.}}; }

  void save(StateWriter &writer) const override
  {
    writer.write("stub/state", std::vector<double>{t, x, v});
    writer.write("stub/step", std::vector<std::uint64_t>{n_steps});
    std::vector<double> points;
    for (const WallState<2> &wall : wall_states)
      points.insert(points.end(), {wall.point[0], wall.point[1]});
    writer.write("stub/walls", points);
  }

  void load(StateReader &reader) override
  {
    const std::vector<double> state = reader.read_doubles("stub/state", 3);
    t = state.at(0);
    x = state.at(1);
    v = state.at(2);
    n_steps = reader.read_integers("stub/step", 1)[0];
    const std::vector<double> points = reader.read_doubles("stub/walls", 2 * wall_states.size());
    for (unsigned int w = 0; w < wall_states.size(); ++w)
    {
      wall_states[w].point = dealii::Point<2>(points.at(2 * w), points.at(2 * w + 1));
      wall_states[w].position =
          wall_states[w].normal[0] != 0 ? wall_states[w].point[0] : wall_states[w].point[1];
    }
  }

private:
  const Scene<2> scene;
  const double dt;
  const unsigned int fails_at, stops_at;
  std::vector<WallState<2>> wall_states;
  double t = 0, x = 1, v = 0;
  std::size_t n_steps = 0;
};

class StubFactory : public ModelFactory
{
public:
  void declare_parameters(dealii::ParameterHandler &prm) const override
  {
    prm.enter_subsection("Stub");
    prm.declare_entry("Time step", "0.01", dealii::Patterns::Double(1e-300), "Units: s.");
    prm.declare_entry("Fails at step", "0", dealii::Patterns::Integer(0), "Units: none.");
    prm.declare_entry("Stopped at step", "0", dealii::Patterns::Integer(0), "Units: none.");
    prm.leave_subsection();
    prm.enter_subsection("Contact");
    prm.declare_entry("Tolerance", "1e-8", dealii::Patterns::Double(0), "Units: none.");
    prm.leave_subsection();
  }

  std::vector<std::string> changeable_on_restart() const override { return {"Stub/", "Contact/Tolerance"}; }

  LawCatalogue laws() const override
  {
    return {{"hard", "soft"},
            [](dealii::ParameterHandler &prm)
            {
              prm.enter_subsection("Soft law");
              prm.declare_entry("Young's modulus", "1e6", dealii::Patterns::Double(0), "Units: Pa.");
              prm.leave_subsection();
            },
            [](const std::string &law) { return law == "soft" ? "Soft law" : "Hard law"; }};
  }

  std::unique_ptr<Model<2>> create(const Scene<2> &scene, dealii::ParameterHandler &prm) const override
  {
    return std::make_unique<StubModel>(scene, prm.get_double({"Stub"}, "Time step"),
                                       prm.get_integer({"Stub"}, "Fails at step"),
                                       prm.get_integer({"Stub"}, "Stopped at step"));
  }
};

[[maybe_unused]] const bool stub_registered = Registry<ModelFactory>::instance().add(
    "stub", "a mass on a spring", [] { return std::make_unique<StubFactory>(); });

/// Two disks in a box whose top comes down.
const char *const stub_scene = R"(
set Model = stub
subsection Materials
  set Names = rubber
end
subsection Bodies
  set Names = a, b
  subsection a
    set Center = 0.5, 0.5
    set Radius = 0.5
  end
  subsection b
    set Center = 1.5, 0.5
    set Radius = 0.5
  end
end
subsection Walls
  set Names = bottom, top, left, right
  subsection top
    set Point    = 0, 1
    set Velocity = 0.1
  end
  subsection right
    set Point = 2, 0
  end
end
subsection Stop
  set End time = 1
end
)";

inline void write_text(const std::string &path, const std::string &text)
{
  std::ofstream(path) << text;
}

/// Runs the command line in this process. What it prints goes to @p printed, errors are shown.
inline int softgrain_command(const std::vector<std::string> &words, std::string *printed = nullptr)
{
  std::vector<const char *> argv = {"softgrain"};
  for (const std::string &word : words)
    argv.push_back(word.c_str());
  std::ostringstream out, err;
  std::streambuf *const old_out = std::cout.rdbuf(out.rdbuf()), *const old_err = std::cerr.rdbuf(err.rdbuf());
  CommandLine command_line;
  const std::optional<int> done = command_line.parse(argv.size(), argv.data());
  const int exit_code = done ? *done : command_line.execute();
  std::cout.rdbuf(old_out);
  std::cerr.rdbuf(old_err);
  if (printed != nullptr)
    *printed = out.str();
  std::cout << err.str();
  return exit_code;
}
} // namespace softgrain

#endif
