// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_system.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr double slips_from = 1. - 1e-9; ///< share of its bound from which friction slips when a step begins

/// In space friction that slips has its own direction, along which it is positive.
signed char sign_of(const dealii::Tensor<1, 1> &friction)
{
  return (friction[0] > 0.) - (friction[0] < 0.);
}
signed char sign_of(const dealii::Tensor<1, 2> &friction)
{
  return friction.norm() > 0.;
}
} // namespace

template <int dim>
FrameSystem<dim>::FrameSystem(const BodyShare &share,
                              const std::vector<Body<dim>> &bodies,
                              std::vector<std::unique_ptr<BodySolver<dim>>> &solvers,
                              const double scale)
    : share(share)
    , bodies(bodies)
    , solvers(solvers)
    , scale(scale)
    , of_body(bodies.size())
    , V(bodies.size())
    , W(bodies.size())
    , moved(bodies.size())
{
}

template <int dim>
void FrameSystem<dim>::take(const std::vector<FrameState<dim>> &frames)
{
  frames_of.assign(bodies.size(), {});
  bodies_of.clear();
  for (const FrameState<dim> &frame : frames)
    bodies_of.push_back({{frame.unknown(0), frame.unknown(1)}});
  for (unsigned int f = 0; f < frames.size(); ++f)
    for (unsigned int side = 0; side < 2; ++side)
      if (const unsigned int b = frames[f].unknown(side); b != FrameState<dim>::none)
        frames_of[b].emplace_back(f, side);
}

/// Columns of the motion of a frame and of the force that it takes, after those of its rays.
template <int dim>
void FrameSystem<dim>::add_motion(const FrameState<dim> &frame,
                                  const std::vector<double> &force,
                                  const unsigned int first,
                                  const unsigned int f)
{
  const unsigned int motion = columns.size(), tangential = motion + dim - 1;
  n_motions += dim - 1;
  for (unsigned int m = 0; m < dim - 1; ++m)
    columns.push_back({Column::motion, f, m});
  for (unsigned int m = 0; m < dim - 1; ++m)
    columns.push_back({Column::tangential, f, m});
  active.insert(active.end(), 2 * (dim - 1), 1);
  gap.insert(gap.end(), 2 * (dim - 1), 0.);
  for (unsigned int m = 0; m < dim - 1; ++m)
  {
    for (unsigned int i = first; i < motion; ++i)
      if (columns[i].kind == Column::ray)
        own.emplace_back(motion + m, i, frame.ray(columns[i].ray_number).by_motion[m]);
    for (unsigned int n = 0; n <= m; ++n)
      own.emplace_back(motion + m, motion + n, frame.derivatives().twice_by_motion(force, m, n));
    own.emplace_back(tangential + m, motion + m, 1.);
  }
}

template <int dim>
void FrameSystem<dim>::add_slides(const FrameState<dim> &frame,
                                  const Across &rubbing,
                                  const double force,
                                  const unsigned int ray_column)
{
  const FrameConditions<dim> conditions = frame.conditions();
  const unsigned int f = columns[ray_column].frame, k = columns[ray_column].ray_number;
  columns[ray_column].mate = columns.size();
  std::array<Across, dim - 1> axes;
  axes[0][0] = 1.;
  double give = 0.;
  if constexpr (dim == 3)
  {
    if (slipping[f][k] != 0 && rubbing.norm() > 0.)
    {
      axes[0] = rubbing / rubbing.norm();
      const double way = axes[0] * (conditions.free_slide(k) + conditions.ray_softness() * rubbing);
      if (const double most = conditions.most_friction(k, force); way < 0. && most > 0.)
        give = -way / most;
    }
    axes[1][0] = -axes[0][1];
    axes[1][1] = axes[0][0];
  }
  for (unsigned int m = 0; m < dim - 1; ++m)
  {
    columns.push_back({Column::slide, f, k, ray_column, conditions.stiffness(), frame.ray(k).rub.bound,
                       conditions.most_friction(k, force), 0., m, axes[m], axes[m], m == 1 ? give : 0.});
    active.push_back(active[ray_column]);
    gap.push_back(axes[m] * conditions.free_slide(k));
  }
  any_slides = true;
}

/// What the dents of a frame make of its rays, columns from @p first to @p end.
template <int dim>
void FrameSystem<dim>::add_dent(const FrameState<dim> &frame,
                                const unsigned int first,
                                const unsigned int end)
{
  const double slope = frame.conditions().dent_slope();
  for (unsigned int i = first; i < end; ++i)
  {
    if (slope < 0.)
      softening_gap.emplace_back(i, slope * frame.conditions().total_force());
    else
      gap[i] -= slope * frame.conditions().total_force();
    for (unsigned int j = first; j <= i; ++j)
      (slope < 0. ? softening : own).emplace_back(i, j, slope);
  }
}

/// What walls under loads do to columns of a frame from @p first on; those of its motion begin at @p motion.
template <int dim>
void FrameSystem<dim>::add_ways(const FrameScene<dim> &scene,
                                const FrameState<dim> &frame,
                                const std::vector<double> &force,
                                const unsigned int first,
                                const unsigned int motion)
{
  const FrameDerivatives<dim> derivatives = frame.derivatives();
  for (unsigned int w = 0; w < ways.size(); ++w)
  {
    const std::array<typename FrameState<dim>::Vector, 2> moves = ways[w].moves(scene, frame);
    if (moves[0].norm_square() + moves[1].norm_square() == 0.)
      continue;
    for (unsigned int i = first; i < columns.size(); ++i)
      if (columns[i].kind != Column::motion)
        own.emplace_back(i, w,
                         columns[i].kind == Column::ray ? derivatives.gap_by(columns[i].ray_number, moves)
                         : columns[i].kind == Column::slide
                             ? columns[i].axis * derivatives.slide_by(columns[i].ray_number, moves)
                             : -derivatives.motion_by(moves)[columns[i].ray_number]);
    for (unsigned int m = 0; m < dim - 1 && derivatives.rides(); ++m)
      own.emplace_back(
          motion + m, w,
          derivatives.twice_by(force, {{derivatives.as_motion(m), derivatives.as_motion(m)}}, moves));
    for (unsigned int v = 0; v <= w; ++v)
      own.emplace_back(w, v, derivatives.twice_by(force, ways[v].moves(scene, frame), moves));
  }
}

template <int dim>
void FrameSystem<dim>::add_columns(const FrameScene<dim> &scene,
                                   const std::vector<FrameState<dim>> &frames,
                                   const RayForces &force,
                                   const RayFriction<dim> &rubbing,
                                   const unsigned int f,
                                   const double within)
{
  const FrameState<dim> &frame = frames[f];
  const FrameConditions<dim> conditions = frame.conditions();
  if (slipping[f].empty())
    for (unsigned int k = 0; k < frame.n_rays(); ++k)
      slipping[f].push_back(conditions.rubs(k) && rubbing[f][k].norm() >=
                                                      slips_from * conditions.most_friction(k, force[f][k])
                                ? sign_of(rubbing[f][k])
                                : 0);
  const unsigned int first = columns.size();
  // Sets with friction are sought from what presses: walls that have moved overlap more than will be pressed.
  const bool from_pressed =
      dim == 3 && conditions.friction_coefficient() > 0. &&
      std::any_of(force[f].begin(), force[f].end(), [](const double of_ray) { return of_ray > 0.; });
  for (unsigned int k = 0; k < frame.n_rays(); ++k)
  {
    const typename FrameState<dim>::RayHere &ray = frame.ray(k);
    found[f][k] = 0.;
    found_rubbing[f][k] = Across();
    if (!ray.met || !ray.near || (force[f][k] == 0. && conditions.free_gap(k) > within))
      continue;
    columns.push_back({Column::ray, f, k, Column::none, conditions.stiffness()});
    columns.back().pull = ray.held.pull;
    active.push_back(conditions.closed(k, force[f][k]) || (!from_pressed && conditions.free_gap(k) < 0.));
    gap.push_back(conditions.free_gap(k));
  }
  const unsigned int motion_of_rays = columns.size();
  if (motion_of_rays == first)
    return;
  for (unsigned int i = first; i < motion_of_rays; ++i)
    if (const unsigned int k = columns[i].ray_number; conditions.rubs(k))
      add_slides(frame, rubbing[f][k], force[f][k], i);
  const unsigned int motion = columns.size();
  for (unsigned int i = first; i < motion; ++i)
    own.emplace_back(i, i, conditions.ray_softness());
  if (frame.derivatives().rides())
    add_motion(frame, force[f], first, f);
  if (conditions.dent_slope() != 0.)
    add_dent(frame, first, motion_of_rays);
  add_ways(scene, frame, force[f], first, motion);
  for (unsigned int side = 0; side < 2; ++side)
    if (frame.unknown(side) != FrameState<dim>::none && !(side == 1 && frame.unknown(0) == frame.unknown(1)))
    {
      const unsigned int b = frame.unknown(side);
      for (unsigned int i = first; i < columns.size(); ++i)
        of_body[b].push_back(i);
    }
}

/// Calls add(node, vector) for all that a column does to the nodes of body @p b.
template <int dim>
template <class Add>
void FrameSystem<dim>::for_nodes(const FrameScene<dim> &scene,
                                 const std::vector<FrameState<dim>> &frames,
                                 const Column &column,
                                 const unsigned int b,
                                 const RayForces &force,
                                 const Add &add) const
{
  if (column.kind == Column::wall)
  {
    for (const auto &[f, side] : frames_of[b])
      frames[f].derivatives().for_mixed(side, force[f], ways[column.ray_number].moves(scene, frames[f])[side],
                                        add);
    return;
  }
  const FrameState<dim> &frame = frames[column.frame];
  const FrameDerivatives<dim> derivatives = frame.derivatives();
  for (unsigned int side = 0; side < 2; ++side)
  {
    if (frame.body(side) != b)
      continue;
    switch (column.kind)
    {
    case Column::ray:
      derivatives.for_gradient(column.ray_number, side, 1., add);
      break;
    case Column::slide:
      derivatives.for_slide(column.ray_number, side, column.axis, add);
      break;
    case Column::motion:
      derivatives.for_mixed(side, force[column.frame], derivatives.as_motion(column.ray_number), add);
      break;
    default:
      derivatives.for_mean(side, column.ray_number, -1., add);
    }
  }
}

template <int dim>
void FrameSystem<dim>::gather(const FrameScene<dim> &scene,
                              const std::vector<FrameState<dim>> &frames,
                              const Column &column,
                              const unsigned int b,
                              const RayForces &force,
                              const unsigned int i,
                              LinearSolver::Rows &rows) const
{
  using Vector = typename FrameState<dim>::Vector;
  struct Entry
  {
    unsigned int node, number;
    Vector value;
  };
  // One buffer for all columns of a thread, and no stable sort: both would ask for memory for every column.
  static thread_local std::vector<Entry> entries;
  entries.clear();
  for_nodes(scene, frames, column, b, force,
            [&](const unsigned int node, const Vector &value) {
              entries.push_back({node, static_cast<unsigned int>(entries.size()), value});
            });
  std::sort(entries.begin(), entries.end(),
            [](const Entry &x, const Entry &y)
            { return x.node < y.node || (x.node == y.node && x.number < y.number); });
  for (unsigned int e = 0; e < entries.size();)
  {
    const unsigned int node = entries[e].node;
    Vector sum;
    for (; e < entries.size() && entries[e].node == node; ++e)
      sum += entries[e].value;
    for (unsigned int d = 0; d < dim; ++d)
      rows.insertBack(dim * node + d, i) = sum[d];
  }
}

/// Forgets the columns of the last state, and begins with those of walls under loads.
template <int dim>
void FrameSystem<dim>::begin_columns(const RayForces &force, const RayFriction<dim> &rubbing)
{
  columns.clear();
  own.clear();
  softening.clear();
  softening_gap.clear();
  for (auto &list : of_body)
    list.clear();
  active.clear();
  gap.clear();
  found = force;
  found_rubbing = rubbing;
  slipping.resize(force.size());
  n_motions = 0;
  any_slides = false;
  for (unsigned int w = 0; w < ways.size(); ++w)
  {
    columns.push_back({Column::wall, FrameState<dim>::none, w});
    active.push_back(1);
    gap.push_back(ways[w].load - ways[w].stiffness * ways[w].at);
    own.emplace_back(w, w, -ways[w].stiffness);
  }
}

template <int dim>
void FrameSystem<dim>::condense(const FrameScene<dim> &scene,
                                const std::vector<FrameState<dim>> &frames,
                                const RayForces &force,
                                const RayFriction<dim> &rubbing,
                                const double within,
                                const std::vector<Eigen::VectorXd> &way_without)
{
  begin_columns(force, rubbing);
  for (unsigned int f = 0; f < frames.size(); ++f)
    add_columns(scene, frames, force, rubbing, f, within);
  for (unsigned int w = 0; w < ways.size(); ++w)
    if (ways[w].carries())
      for (auto &list : of_body)
        if (!list.empty())
          list.push_back(w);
  z.setZero(gap.size());
  at_hand.setZero(gap.size());
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray)
      at_hand[i] = force[columns[i].frame][columns[i].ray_number];
    else if (columns[i].kind == Column::slide)
      at_hand[i] = columns[i].axis * rubbing[columns[i].frame][columns[i].ray_number];
  find_order();
  share.for_mine(
      bodies,
      [&](const Body<dim> &body)
      {
        const unsigned int b = body.index;
        const std::vector<unsigned int> &list = of_body[b];
        V[b].resize(body.field.n_dofs(), list.size());
        V[b].reserve(list.size() * 40);
        for (unsigned int i = 0; i < list.size(); ++i)
        {
          V[b].startVec(i);
          gather(scene, frames, columns[list[i]], b, force, i, V[b]);
        }
        V[b].finalize();
        if (!list.empty())
        {
          solvers[b]->condense(V[b], W[b]);
          W[b] *= scale;
          moved[b] = V[b].transpose() * way_without[b];
        }
      },
      [&](BodyShare::Message &message)
      {
        for (unsigned int b = 0; b < of_body.size(); ++b)
        {
          W[b].resize(of_body[b].size(), of_body[b].size());
          moved[b].resize(of_body[b].size());
          message.add(b, W[b].data(), W[b].size());
          message.add(b, moved[b].data(), moved[b].size());
        }
      });
}

template <int dim>
void FrameSystem<dim>::pick(const unsigned int b, const Eigen::VectorXd &all, Eigen::VectorXd &part) const
{
  part.resize(of_body[b].size());
  for (unsigned int i = 0; i < of_body[b].size(); ++i)
    part[i] = all[of_body[b][i]];
}

template <int dim>
Eigen::VectorXd FrameSystem<dim>::force_on(const unsigned int b) const
{
  Eigen::VectorXd of_columns;
  pick(b, z, of_columns);
  return V[b] * of_columns;
}

template class FrameSystem<2>;
template class FrameSystem<3>;
} // namespace softgrain::mpm
