// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/model/state_file.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/contact/frame_memory.h>
#include <softgrain/mpm/model/mpm_model.h>
#include <softgrain/mpm/stepping/stiffness.h>

#include <algorithm>
#include <cstring>

namespace softgrain::mpm
{
namespace
{
/// Vectors of tensors, points and symmetric tensors as plain numbers; they hold nothing else.
template <typename T>
std::vector<double> flat(const std::vector<T> &values)
{
  static_assert(sizeof(T) % sizeof(double) == 0 && std::is_trivially_destructible<T>::value,
                "not a pack of doubles");
  std::vector<double> numbers(values.size() * sizeof(T) / sizeof(double));
  if (!numbers.empty())
    std::memcpy(numbers.data(), values.data(), numbers.size() * sizeof(double));
  return numbers;
}

/// Into the place of as many as there are.
template <typename T>
void unflat(const StateReader &in, const std::string &name, std::vector<T> &values)
{
  const std::vector<double> numbers = in.read_doubles(name, values.size() * sizeof(T) / sizeof(double));
  if (!numbers.empty())
    std::memcpy(static_cast<void *>(values.data()), numbers.data(), numbers.size() * sizeof(double));
}

std::vector<double> flat(const Eigen::VectorXd &v)
{
  return {v.data(), v.data() + v.size()};
}

/// Where a checkpoint keeps a body.
std::string place_of(const Body<2> &body)
{
  return "mpm/bodies/" + body.name + "/";
}

/// Reads a list back into a vector.
void unflat(const StateReader &in, const std::string &name, Eigen::VectorXd &values)
{
  const std::vector<double> numbers = in.read_doubles(name, values.size());
  values = Eigen::Map<const Eigen::VectorXd>(numbers.data(), numbers.size());
}
} // namespace

void MpmModel::save(StateWriter &out) const
{
  write_state(out, true);
}

void MpmModel::load(StateReader &in)
{
  read_state(in, true);
}

void MpmModel::write_state(StateWriter &out, const bool of_all) const
{
  const Balance &b = state.balance;
  out.write("mpm/scalars",
            std::vector<double>{state.time, step_control.scale, last_dt, state.memory.step, last_unbalanced});
  std::vector<std::uint64_t> counts{steps, work.contact.plain_solves, held_steps};
  if (laws_limit_step())
    counts.push_back(law_cuts);
  out.write("mpm/step", counts);
  b.save(out, "mpm/balance/common");
  out.write("mpm/balance/own", std::vector<double>{b.subgrid_energy});
  save_walls(out, "mpm/walls", state.walls);
  save_obstacles(out, "mpm/obstacles", state.obstacles);

  // Sorted by key, so that equal states give equal files.
  std::vector<std::pair<std::uint64_t, std::array<double, 2>>> memory(state.memory.impulses.begin(),
                                                                      state.memory.impulses.end());
  std::sort(memory.begin(), memory.end());
  std::vector<std::uint64_t> keys;
  std::vector<double> impulses;
  const std::ptrdiff_t components = problem.slippery() ? 1 : 2;
  for (const auto &[key, impulse] : memory)
  {
    keys.push_back(key);
    impulses.insert(impulses.end(), impulse.begin(), impulse.begin() + components);
  }
  out.write("mpm/contact/keys", keys);
  out.write("mpm/contact/impulses", impulses);
  state.adhesion.save(out, "mpm/contact/adhesion");
  if (problem.settings.meets_by_rays())
    save_frames(out, "mpm/contact/frames", state.frames, state.adhesion.acts());
  std::vector<double> resistance;
  for (const dealii::Tensor<1, 2> &force : state.resistance)
    resistance.insert(resistance.end(), force.begin_raw(), force.end_raw());
  if (!resistance.empty())
    out.write("mpm/resistance", resistance);
  if (!state.held_back.empty())
    out.write("mpm/held_back", state.held_back);

  save_points(out, of_all);
  for (const Body<2> &body : state.bodies)
  {
    const std::string at = place_of(body);
    out.write(at + "boundary_grid_position", flat(body.boundary.grid_position));
    out.write(at + "boundary_position", flat(body.boundary.position));
    out.write(at + "nodes/displacement", flat(body.nodes.displacement));
    out.write(at + "nodes/velocity", flat(body.nodes.velocity));
    out.write(at + "nodes/velocity_of_points", flat(body.nodes.velocity_of_points));
    out.write(at + "nodes/internal_force", flat(body.nodes.internal_force));
    if (body.nodes.kept.size() > 0)
      out.write(at + "nodes/rate", flat(body.nodes.kept));
    if (state.repeats())
      out.write(at + "home", std::vector<double>(body.home.begin(), body.home.end()));
  }
}

void MpmModel::read_progress(const StateReader &in)
{
  const std::vector<double> scalars = in.read_doubles("mpm/scalars", 5);
  load_walls(in, "mpm/walls", state.walls);
  state.time = scalars[0];
  load_obstacles(in, "mpm/obstacles", state.time, state.obstacles);
  step_control.scale = scalars[1];
  last_dt = scalars[2];
  state.memory.step = scalars[3];
  last_unbalanced = scalars[4];
  const std::vector<std::uint64_t> counts = in.read_integers("mpm/step", laws_limit_step() ? 4 : 3);
  steps = counts[0];
  work.contact.plain_solves = counts[1];
  held_steps = counts[2];
  if (laws_limit_step())
    law_cuts = counts[3];
  settled_step = 0; // what comes is another step, of whatever number
  const std::vector<double> own = in.read_doubles("mpm/balance/own", 1);
  Balance &b = state.balance;
  b.load(in, "mpm/balance/common");
  b.subgrid_energy = own[0];
}

void MpmModel::read_contacts(const StateReader &in)
{
  const std::vector<std::uint64_t> keys = in.read_keys("mpm/contact/keys", ListSize::rows_of(1));
  const std::size_t components = problem.slippery() ? 1 : 2;
  const std::vector<double> impulses = in.read_doubles("mpm/contact/impulses", components * keys.size());
  state.memory.impulses.clear();
  for (std::size_t k = 0; k < keys.size(); ++k)
    state.memory.impulses[keys[k]] = {
        {impulses[components * k], components > 1 ? impulses[components * k + 1] : 0.}};

  state.adhesion.load(in, "mpm/contact/adhesion");
  state.held_back.clear();
  if (in.contains("mpm/held_back"))
    state.held_back = in.read_doubles("mpm/held_back", state.bodies.size());
  state.resistance.clear();
  if (in.contains("mpm/resistance"))
  {
    const std::vector<double> resistance = in.read_doubles("mpm/resistance", 2 * state.bodies.size());
    for (unsigned int b = 0; b < state.bodies.size(); ++b)
      state.resistance.push_back(dealii::Tensor<1, 2>({resistance[2 * b], resistance[2 * b + 1]}));
  }
}

void MpmModel::read_nodes(const StateReader &in, Body<2> &body)
{
  const std::string at = place_of(body);
  unflat(in, at + "boundary_position", body.boundary.position);
  // The grid that has been laid says how many nodes there are.
  unflat(in, at + "nodes/displacement", body.nodes.displacement);
  unflat(in, at + "nodes/velocity", body.nodes.velocity);
  unflat(in, at + "nodes/velocity_of_points", body.nodes.velocity_of_points);
  body.nodes.internal_force.resize(body.field.n_dofs());
  unflat(in, at + "nodes/internal_force", body.nodes.internal_force);
  body.nodes.kept.resize(in.contains(at + "nodes/rate") ? body.field.n_dofs() : 0);
  if (body.nodes.kept.size() > 0)
    unflat(in, at + "nodes/rate", body.nodes.kept);
  if (!state.repeats())
    return;
  const std::vector<double> home = in.read_doubles(at + "home", 2);
  for (const double number : home)
    if (number != static_cast<int>(number))
      in.refuse(at + "home", "copies of a cell have whole numbers");
  body.home = {{static_cast<int>(home[0]), static_cast<int>(home[1])}};
}

void MpmModel::read_state(StateReader &in, const bool of_all)
{
  read_progress(in);
  read_contacts(in);
  load_points(in, of_all);
  state.order_points();
  const BuildContext context{*problem.lattice, *problem.shape, problem.settings, *state.points};
  for (Body<2> &body : state.bodies)
  {
    unflat(in, place_of(body) + "boundary_grid_position", body.boundary.grid_position);
    if (work.share.holds(body.index))
      lay_grid(body, context);
  }
  // What other owners have told of grids stays true within a step where grids stay.
  if (of_all || problem.settings.grid_update != GridUpdate::never)
    share_grids(all_bodies());
  for (Body<2> &body : state.bodies)
  {
    read_nodes(in, body);
    lay_out_matrix(body);
  }
  work.outlines.clear();
  if (problem.settings.meets_by_rays())
    load_frames(in, "mpm/contact/frames", state.bodies, state.walls.size(), state.obstacles, state.frames);
}
} // namespace softgrain::mpm
