// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/app/outlook.h>
#include <softgrain/app/stage_path.h>
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/geometry/box.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace softgrain
{
namespace
{
/// The scene without its bodies but for the area that they fill.
class WallsAlone final : public Model<2>
{
public:
  WallsAlone(const Scene<2> &scene, const double area) : area(area)
  {
    // What make_walls() asks of bodies is a mass, and no wall here has any.
    Scene<2> empty;
    empty.walls = scene.walls;
    moving = make_walls(empty);
  }

  struct State
  {
    double time = 0.; ///< [s]
    std::vector<Wall<2>> walls;
  };
  State state() const { return {now, moving}; }
  void restore(const State &state)
  {
    now = state.time;
    moving = state.walls;
  }

  StepReport advance(const double dt) override
  {
    const std::optional<Box<2>> before = box_of(walls());
    for (Wall<2> &wall : moving)
    {
      wall.speed = told_rates(wall, now, dt).speed;
      wall.travel += dt * wall.speed;
      fastest = std::max(fastest, std::abs(wall.speed));
      pressed = pressed || is_free(wall, Freedom::across);
    }
    if (before)
      give_way(before->volume());
    now += dt;
    return {};
  }

  void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives) override
  {
    softgrain::take_drives(moving, drives, now);
  }

  std::string name() const override { return "walls"; }
  double time() const override { return now; }
  std::size_t step() const override { return 0; }
  Snapshot<2> snapshot() const override { return {}; }
  std::vector<WallState<2>> walls() const override { return states_of(moving); }
  Energies energies() const override { return {}; }
  double solid_area() const override { return area; }
  double coordination() const override { return 0.; }
  double momentum_error() const override { return 0.; }
  std::size_t n_points() const override { return 0; }
  std::size_t n_bodies() const override { return 0; }
  SizeReport size_report() const override { return {}; }
  std::map<std::string, double> phases() const override { return {}; }
  void save(StateWriter &) const override {}
  void load(StateReader &) override {}

  double fastest = 0.; ///< [m/s]
  bool pressed = false;

private:
  /// What the walls that are driven take from the box, those under pressure leave it: soft bodies are hardly
  /// compressible.
  void give_way(const double area_before)
  {
    const std::optional<Box<2>> box = box_of(walls());
    const auto yields = [](const Wall<2> &wall) { return is_free(wall, Freedom::across) && is_met(wall); };
    const unsigned int n = std::count_if(moving.begin(), moving.end(), yields);
    const double lost = box ? area_before - box->volume() : 0.;
    for (std::size_t w = 0; w < moving.size() && lost != 0.; ++w)
      if (const double length = yields(moving[w]) ? pressed_length(moving, w) : 0.; length > 0.)
        moving[w].travel -= lost / (n * length);
  }

  double area;
  double now = 0.;
  std::vector<Wall<2>> moving;
};

/// Whether walls that face each other came nearer or went apart by more than part of their distance.
bool went_far(const std::vector<WallState<2>> &before, const std::vector<WallState<2>> &now)
{
  constexpr double part = 0.02;
  for (const auto &[from, to] : {std::make_pair("left", "right"), std::make_pair("bottom", "top")})
    if (const auto distance = wall_distance(before, from, to); distance && *distance > 0.)
      if (std::abs(*wall_distance(now, from, to) - *distance) > part * *distance)
        return true;
  return false;
}

/// Goes the way of the walls in steps that follow what happens, until @p part says that all of it is done.
/// @return whether it was
template <typename Part>
bool go(WallsAlone &model, const double longest, const Part &part)
{
  constexpr unsigned int most = 20000;
  const double begin = model.time();
  double dt = longest > 0. ? 1e-3 * longest : 1e-9;
  for (unsigned int step = 0; step < most; ++step)
  {
    const double done = part();
    if (done >= 1.)
      return true;
    const double limit = longest > 0. ? begin + longest - model.time() : dt;
    const WallsAlone::State before = model.state();
    const std::vector<WallState<2>> walls_before = model.walls();
    model.advance(std::min(dt, limit));
    const double now = part();
    // Walls that go through each other in one step fill no box that a stop condition knows.
    if ((now > done + 1e-2 || went_far(walls_before, model.walls())) && dt > 1e-12 * model.time())
    {
      model.restore(before);
      dt *= 0.5;
    }
    else if (now < done + 2e-3)
      dt = longest > 0. ? std::min(1.5 * dt, 1e-3 * longest) : 1.5 * dt;
    if (!std::isfinite(model.time()) || model.time() > 1e12)
      return false;
  }
  return false;
}

/// How often the run writes.
void note_output(const RunParameters &run, RunOutline &outline)
{
  for (const double every : {run.fields_every, run.snapshots_every})
    if (every > 0.)
    {
      outline.n_pictures += 1. + std::floor(outline.duration / every);
      outline.output_every = outline.output_every > 0. ? std::min(outline.output_every, every) : every;
    }
  outline.history_every = run.history_every;
}
} // namespace

std::optional<RunOutline> outline_of(Input &input)
{
  if (input.dimension() == 3)
    return std::nullopt; // costs are known of the plane alone
  std::optional<Crowd> crowd = input.crowd();
  if (!crowd)
    return std::nullopt;
  RunOutline outline;
  outline.crowd = *crowd;
  outline.to_pack = input.scene().packing.method != nullptr;
  WallsAlone model(input.scene(), input.estimates().solid_area(outline.crowd));
  const std::vector<WallState<2>> start = model.walls();
  StagePath<2> path(input.stages(), model, input.scene().loads);
  path.begin();
  bool known = true;
  const StopConditions &stop = input.stop();
  // Conditions that look back have seen nothing: when they end a run is not known beforehand.
  const StopMemory nothing;
  const auto of_run = [&] {
    return stop.empty() ? 0. : stop.fraction_done({model, start, input.scene().loads}, nothing);
  };
  for (unsigned int n = 0; known && n < std::max<std::size_t>(1, input.stages().size()); ++n)
  {
    if (n > 0)
      path.next();
    const bool staged = !path.empty();
    const double begin = staged ? model.time() : 0.;
    const double end = staged ? path.end_time() : stop.end_time();
    double longest = !staged || end > begin ? end - begin : 0.;
    // What the bodies decide comes somewhere within the time that it is given.
    const bool half = longest > 0. && (staged ? input.stages()[n].stop : stop).depend_on_bodies();
    if (half)
      longest *= 0.5;
    known = go(model, longest,
               [&]
               {
                 const bool over = half && model.time() >= begin + (1. - 1e-9) * longest;
                 return std::max({of_run(), staged ? path.fraction_of_stage(0.) : 0., over ? 1. : 0.});
               });
    if (staged)
      outline.stages.push_back(model.time() - begin);
    if (of_run() >= 1.)
      break;
  }
  if (known)
    outline.stages.resize(input.stages().size(), 0.); // those after the end of the run
  else
    outline.stages.clear();
  outline.duration = known ? model.time() : 0.;
  outline.fastest_wall = model.fastest;
  outline.pressed = model.pressed;
  note_output(input.run(), outline);
  return outline;
}
} // namespace softgrain
