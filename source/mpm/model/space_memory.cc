// SPDX-License-Identifier: LGPL-2.1-or-later
// What checkpoints keep of a computation in space.
#include <softgrain/driving/wall_freedom.h>
#include <softgrain/model/state_file.h>
#include <softgrain/mpm/body/body_builder.h>
#include <softgrain/mpm/body/remembered_points.h>
#include <softgrain/mpm/model/space_model.h>
#include <softgrain/mpm/stepping/keep_points.h>

#include <array>

namespace softgrain::mpm
{
namespace
{
using Frame = ContactFrame<3>;

constexpr unsigned int counts_of_frame = 5, numbers_of_frame = 15, numbers_of_place = 19,
                       numbers_of_ray = 5 + 2 * numbers_of_place, numbers_of_wall = n_wall_numbers<3>,
                       counts_of_contact = 3, numbers_of_contact = 10;

/// The file has the numbers of a wall in an order of its own.
using Places = std::array<unsigned int, numbers_of_wall>;
constexpr Places places_of_numbers = {{0, 1, 2, 5, 6, 7, 8, 3, 4}}, ///< of what the file has, in numbers_of()
    places_in_file = {{0, 1, 2, 7, 8, 3, 4, 5, 6}};                 ///< of what take_numbers() wants

std::vector<double> reordered(const std::vector<double> &numbers, const Places &from)
{
  std::vector<double> to(numbers.size());
  for (std::size_t n = 0; n < numbers.size(); ++n)
    to[n] = numbers[n - n % numbers_of_wall + from[n % numbers_of_wall]];
  return to;
}

template <class Tensor>
void add(const Tensor &tensor, std::vector<double> &list)
{
  for (unsigned int d = 0; d < 3; ++d)
    list.push_back(tensor[d]);
}

template <class Tensor>
void take(const double *&from, Tensor &tensor)
{
  for (unsigned int d = 0; d < 3; ++d)
    tensor[d] = *from++;
}

/// A place of a surface in all its digits: one that is sought again differs by rounding.
void add(const SurfacePlace<3> &place, std::vector<double> &list)
{
  add(place.position, list);
  for (const auto &tangent : place.tangent)
    add(tangent, list);
  add(place.normal, list);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      list.push_back(place.bend[i][j]);
  list.insert(list.end(), {static_cast<double>(place.piece), place.along, place.at_edge ? 1. : 0.});
}

void take(const double *&from, SurfacePlace<3> &place)
{
  take(from, place.position);
  for (auto &tangent : place.tangent)
    take(from, tangent);
  take(from, place.normal);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      place.bend[i][j] = *from++;
  place.piece = static_cast<unsigned int>(*from++);
  place.along = *from++;
  place.at_edge = *from++ != 0.;
}

void save_frames(const std::vector<Frame> &frames, StateWriter &out)
{
  std::vector<std::uint64_t> who;
  std::vector<double> where, rays;
  for (const Frame &frame : frames)
  {
    who.insert(who.end(), {frame.body, frame.partner, frame.wall, frame.rays.size(), frame.id});
    add(frame.origin, where);
    add(frame.direction, where);
    for (const auto &across : frame.across)
      add(across, where);
    where.insert(where.end(), {frame.spacing, frame.log_full_width[0], frame.log_full_width[1]});
    for (const Frame::RayPlace &ray : frame.rays)
    {
      rays.insert(rays.end(), {static_cast<double>(ray.index[0]), static_cast<double>(ray.index[1]),
                               ray.force, ray.friction[0], ray.friction[1]});
      for (const SurfacePlace<3> &place : ray.place)
        add(place, rays);
    }
  }
  out.write("space/frames/who", who);
  out.write("space/frames/where", where);
  out.write("space/frames/rays", rays);
}

void load_frames(const StateReader &in, SpaceState &state, const std::size_t n_walls)
{
  const std::size_t n_fixed = n_walls + state.obstacles.size();
  const std::vector<std::uint64_t> who =
      in.read_integers("space/frames/who", ListSize::rows_of(counts_of_frame));
  const std::size_t n = who.size() / counts_of_frame;
  std::size_t n_rays = 0;
  for (std::size_t f = 0; f < n; ++f)
    n_rays += who[counts_of_frame * f + 3];
  const std::vector<double> where = in.read_doubles("space/frames/where", n * numbers_of_frame),
                            rays = in.read_doubles("space/frames/rays", n_rays * numbers_of_ray);
  const double *at = where.data(), *of_ray = rays.data();
  state.frames.assign(n, Frame());
  for (std::size_t f = 0; f < n; ++f)
  {
    Frame &frame = state.frames[f];
    const std::uint64_t *names = &who[counts_of_frame * f];
    const bool at_wall = names[1] == Frame::none;
    if (names[0] >= state.bodies.size() || (at_wall ? names[2] >= n_fixed : names[1] >= state.bodies.size()))
      in.refuse("space/frames/who", "there is no such body or wall");
    frame.body = names[0];
    frame.partner = names[1];
    frame.wall = at_wall ? names[2] : Frame::none;
    frame.id = names[4];
    take(at, frame.origin);
    take(at, frame.direction);
    for (auto &across : frame.across)
      take(at, across);
    frame.spacing = *at++;
    frame.log_full_width = {{at[0], at[1]}};
    at += 2;
    frame.rays.resize(names[3]);
    for (Frame::RayPlace &ray : frame.rays)
    {
      ray.index = {{static_cast<int>(of_ray[0]), static_cast<int>(of_ray[1])}};
      ray.force = of_ray[2];
      ray.friction[0] = of_ray[3];
      ray.friction[1] = of_ray[4];
      of_ray += 5;
      for (SurfacePlace<3> &place : ray.place)
        take(of_ray, place);
    }
  }
}

/// Images of partners in a cell that repeats, of frames or contacts.
template <class List>
std::vector<double> images_of(const List &list)
{
  std::vector<double> images;
  for (const auto &one : list)
    images.insert(images.end(), one.image.begin(), one.image.end());
  return images;
}

template <class List>
void take_images(const std::vector<double> &images, List &list)
{
  const double *at = images.data();
  for (auto &one : list)
    for (int &n : one.image)
      n = static_cast<int>(*at++);
}

/// What is kept of a cell that repeats, and of no other scene.
void save_cell(const SpaceState &state, StateWriter &out)
{
  out.write("space/cell/sums", std::vector<double>{state.cell_offset, state.motion.cell_work});
  out.write("space/cell/images_of_frames", images_of(state.frames));
  out.write("space/cell/images_of_contacts", images_of(state.contacts));
}

void load_cell(const StateReader &in, SpaceState &state)
{
  const std::vector<double> sums = in.read_doubles("space/cell/sums", 2);
  state.cell_offset = sums[0];
  state.motion.cell_work = sums[1];
  take_images(in.read_doubles("space/cell/images_of_frames", 3 * state.frames.size()), state.frames);
  take_images(in.read_doubles("space/cell/images_of_contacts", 3 * state.contacts.size()), state.contacts);
}

void save_contacts(const std::vector<SpaceContact> &contacts, StateWriter &out)
{
  std::vector<std::uint64_t> who;
  std::vector<double> numbers;
  for (const SpaceContact &contact : contacts)
  {
    who.insert(who.end(), {contact.body, contact.partner, contact.wall});
    add(contact.place, numbers);
    add(contact.normal, numbers);
    add(contact.force, numbers);
    numbers.push_back(contact.gap);
  }
  out.write("space/contacts/who", who);
  out.write("space/contacts/numbers", numbers);
}

void load_contacts(const StateReader &in, SpaceState &state)
{
  const std::vector<std::uint64_t> who =
      in.read_integers("space/contacts/who", ListSize::rows_of(counts_of_contact));
  const std::size_t n = who.size() / counts_of_contact;
  const std::vector<double> numbers = in.read_doubles("space/contacts/numbers", n * numbers_of_contact);
  const double *at = numbers.data();
  state.contacts.clear();
  for (std::size_t c = 0; c < n; ++c)
  {
    SpaceContact contact{static_cast<unsigned int>(who[counts_of_contact * c]),
                         static_cast<unsigned int>(who[counts_of_contact * c + 1]),
                         static_cast<unsigned int>(who[counts_of_contact * c + 2]),
                         {},
                         {},
                         {},
                         0.};
    take(at, contact.place);
    take(at, contact.normal);
    take(at, contact.force);
    contact.gap = *at++;
    state.contacts.push_back(contact);
  }
}

/// Of all bodies, one after the other.
std::vector<double> nodal(const SpaceState &state, Eigen::VectorXd NodalState<3>::*vector)
{
  std::vector<double> all;
  for (const Body<3> &body : state.bodies)
    all.insert(all.end(), (body.nodes.*vector).data(),
               (body.nodes.*vector).data() + (body.nodes.*vector).size());
  return all;
}

void take_nodal(const std::vector<double> &all, Eigen::VectorXd NodalState<3>::*vector, SpaceState &state)
{
  const double *at = all.data();
  for (Body<3> &body : state.bodies)
  {
    body.nodes.*vector = Eigen::Map<const Eigen::VectorXd>(at, body.nodes.displacement.size());
    at += body.nodes.displacement.size();
  }
}

void save_motion(const SpaceState &state, StateWriter &out)
{
  out.write("space/velocity", nodal(state, &NodalState<3>::velocity));
  out.write("space/internal_force", nodal(state, &NodalState<3>::internal_force));
  const MotionBalance &balance = state.motion;
  std::vector<double> sums = {balance.scheme_damping, balance.contact_loss, balance.wall_damping,
                              balance.largest_momentum};
  add(balance.impulse, sums);
  out.write("space/motion", sums);
}

void load_motion(const StateReader &in, const std::size_t n_dofs, SpaceState &state)
{
  take_nodal(in.read_doubles("space/velocity", n_dofs), &NodalState<3>::velocity, state);
  take_nodal(in.read_doubles("space/internal_force", n_dofs), &NodalState<3>::internal_force, state);
  const std::vector<double> sums = in.read_doubles("space/motion", 7);
  MotionBalance &balance = state.motion;
  balance.scheme_damping = sums[0];
  balance.contact_loss = sums[1];
  balance.wall_damping = sums[2];
  balance.largest_momentum = sums[3];
  const double *at = &sums[4];
  take(at, balance.impulse);
}

void save_laws(const SpaceState &state, StateWriter &out)
{
  if (!any_history(state.bodies))
    return;
  out.write("space/points", remembered_by_points(state.bodies));
  out.write("space/laws", std::vector<double>{state.laws.loss, state.laws.supply});
  out.write("space/law_cuts", std::vector<std::uint64_t>{state.law_cuts});
}

void load_laws(const StateReader &in, SpaceState &state)
{
  if (!any_history(state.bodies))
    return;
  take_points(in.read_doubles("space/points", remembered_by_points(state.bodies).size()), state.bodies);
  const std::vector<double> sums = in.read_doubles("space/laws", 2);
  state.laws.loss = sums[0];
  state.laws.supply = sums[1];
  state.law_cuts = in.read_integers("space/law_cuts", 1)[0];
}
} // namespace

void SpaceModel::save(StateWriter &out) const
{
  out.write("space/time",
            std::vector<double>{state.time, step_control.scale, last_dt, state.losses.regularisation,
                                state.losses.released, state.dent_energy, state.losses.rubbed});
  out.write("space/steps", std::vector<std::uint64_t>{steps});
  out.write("space/displacement", nodal(state, &NodalState<3>::displacement));
  out.write("space/held_back", state.held_back);
  out.write("space/walls", reordered(numbers_of(driven), places_of_numbers));
  save_obstacles(out, "space/obstacles", state.obstacles);
  save_frames(state.frames, out);
  save_contacts(state.contacts, out);
  if (any_sides(driven))
    save_cell(state, out);
  save_laws(state, out);
  if (!loads.empty())
    state.load_work.save(out, "space/loads");
  if (!at_rest())
    save_motion(state, out);
}

void SpaceModel::load(StateReader &in)
{
  const std::vector<double> times = in.read_doubles("space/time", 7);
  std::size_t n_dofs = 0;
  for (const Body<3> &body : state.bodies)
    n_dofs += body.nodes.displacement.size();
  const std::vector<double> nodes = in.read_doubles("space/displacement", n_dofs);
  take_numbers(reordered(in.read_doubles("space/walls", numbers_of_wall * driven.size()), places_in_file),
               driven);
  state.held_back = in.read_doubles("space/held_back", ListSize::rows_of(1));
  if (!state.held_back.empty() && state.held_back.size() != state.bodies.size())
    in.refuse("space/held_back", "there is another number of bodies");
  take_nodal(nodes, &NodalState<3>::displacement, state);
  for (Body<3> &body : state.bodies)
    move_boundary(body);
  state.time = times[0];
  step_control.scale = times[1];
  last_dt = times[2];
  state.losses.regularisation = times[3];
  state.losses.released = times[4];
  state.dent_energy = times[5];
  state.losses.rubbed = times[6];
  steps = in.read_integers("space/steps", 1)[0];
  for (std::size_t w = 0; w < driven.size(); ++w)
  {
    state.wall_force[w] = dealii::Tensor<1, 3>() - driven[w].book.force;
    begin_under_load(w);
  }
  load_obstacles(in, "space/obstacles", state.time, state.obstacles);
  load_frames(in, state, driven.size());
  load_contacts(in, state);
  if (any_sides(driven))
    load_cell(in, state);
  follow_step();
  load_laws(in, state);
  if (!loads.empty())
    state.load_work.load(in, "space/loads");
  if (!at_rest())
    load_motion(in, n_dofs, state);
}
} // namespace softgrain::mpm
