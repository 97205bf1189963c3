// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/contact/frame_system.h>

#include <algorithm>
#include <cmath>

namespace softgrain::mpm
{
namespace
{
constexpr unsigned int most_passes = 40;
constexpr unsigned int most_in_saddle = 5; ///< passes in which a set may belong to no minimum
constexpr unsigned int one_by_one = 15;    ///< passes after which only the worst ray changes sides
} // namespace

FrameSystem::FrameSystem(const BodyShare &share,
                         const std::vector<Body<2>> &bodies,
                         std::vector<std::unique_ptr<RankOneSolver>> &solvers,
                         const double scale)
    : share(share)
    , bodies(bodies)
    , solvers(solvers)
    , scale(scale)
    , of_body(bodies.size())
    , V(bodies.size())
    , W(bodies.size())
{
}

void FrameSystem::find_order()
{
  std::vector<int> frame_of; // numbers of frames with columns, by column
  std::vector<unsigned int> first;
  for (unsigned int i = 0; i < columns.size(); ++i)
  {
    if (i == 0 || columns[i].frame != columns[i - 1].frame)
      first.push_back(i);
    frame_of.push_back(first.size() - 1);
  }
  first.push_back(columns.size());
  const int n = first.size() - 1;
  std::vector<Eigen::Triplet<double>> neighbours;
  for (const auto &list : of_body)
    for (unsigned int i = 0; i < list.size(); ++i)
      if (i == 0 || frame_of[list[i]] != frame_of[list[i - 1]])
        for (unsigned int j = 0; j < list.size(); ++j)
          if (j == 0 || frame_of[list[j]] != frame_of[list[j - 1]])
            neighbours.emplace_back(frame_of[list[i]], frame_of[list[j]], 1.);
  Eigen::SparseMatrix<double> graph(n, n);
  graph.setFromTriplets(neighbours.begin(), neighbours.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(graph, permutation);
  order.clear();
  for (int f = 0; f < n; ++f)
  {
    const unsigned int begin = first[permutation.indices()[f]], end = first[permutation.indices()[f] + 1];
    for (unsigned int i = begin; i < end - 2; ++i)
      order.push_back(i);
    order.push_back(end - 1);
    order.push_back(end - 2);
  }
}

void FrameSystem::condense(const std::vector<FrameState> &frames, const RayForces &force, const double within)
{
  columns.clear();
  own.clear();
  for (auto &list : of_body)
    list.clear();
  active.clear();
  std::vector<double> gaps;
  found = force;
  n_frames = 0;
  for (unsigned int f = 0; f < frames.size(); ++f)
  {
    const unsigned int first = columns.size();
    for (unsigned int k = 0; k < frames[f].n_rays(); ++k)
    {
      const FrameState::RayHere &ray = frames[f].ray(k);
      found[f][k] = 0.;
      if (!ray.met || !ray.near || (force[f][k] == 0. && frames[f].free_gap(k) > within))
        continue;
      columns.push_back({Column::ray, f, k});
      active.push_back(force[f][k] > 0. || frames[f].free_gap(k) < 0.);
      gaps.push_back(frames[f].free_gap(k) - frames[f].dent_slope() * frames[f].total_force());
    }
    if (columns.size() == first)
      continue;
    ++n_frames;
    const unsigned int motion = columns.size(), tangential = motion + 1;
    columns.push_back({Column::motion, f, 0});
    columns.push_back({Column::tangential, f, 0});
    active.insert(active.end(), 2, 1);
    gaps.insert(gaps.end(), 2, 0.);
    for (unsigned int i = first; i < motion; ++i)
      own.emplace_back(motion, i, frames[f].ray(columns[i].ray_number).by_motion);
    for (unsigned int i = first; i < motion; ++i)
      own.emplace_back(i, i, frames[f].ray_softness());
    if (frames[f].dent_slope() != 0.)
      for (unsigned int i = first; i < motion; ++i)
        for (unsigned int j = first; j <= i; ++j)
          own.emplace_back(i, j, frames[f].dent_slope());
    own.emplace_back(motion, motion, frames[f].twice_by_motion(force[f]));
    own.emplace_back(tangential, motion, 1.);
    for (unsigned int side = 0; side < 2; ++side)
      if (frames[f].body(side) != FrameState::none)
        for (unsigned int i = first; i <= tangential; ++i)
          of_body[frames[f].body(side)].push_back(i);
  }
  gap = Eigen::Map<const Eigen::VectorXd>(gaps.data(), gaps.size());
  z.setZero(gap.size());
  find_order();
  share.for_mine(bodies,
                 [&](const Body<2> &body)
                 {
                   const unsigned int b = body.index, n = body.field.n_dofs();
                   const std::vector<unsigned int> &list = of_body[b];
                   V[b].resize(n, list.size());
                   V[b].setZero();
                   Eigen::VectorXd nodal(n);
                   V[b].reserve(Eigen::VectorXi::Constant(list.size(), 40));
                   for (unsigned int i = 0; i < list.size(); ++i)
                   {
                     const Column &column = columns[list[i]];
                     const FrameState &frame = frames[column.frame];
                     const unsigned int side = frame.body(1) == b ? 1 : 0;
                     nodal.setZero();
                     if (column.kind == Column::ray)
                       frame.add_gradient(column.ray_number, side, 1., nodal);
                     else if (column.kind == Column::motion)
                       frame.add_mixed(side, force[column.frame], nodal);
                     else
                       frame.add_mean(side, -1., nodal);
                     for (unsigned int j = 0; j < n; ++j)
                       if (nodal[j] != 0.)
                         V[b].insert(j, i) = nodal[j];
                   }
                   V[b].makeCompressed();
                   if (!list.empty())
                   {
                     solvers[b]->condense(V[b], W[b]);
                     W[b] *= scale;
                   }
                 });
}

Eigen::VectorXd FrameSystem::z_of(const unsigned int b) const
{
  Eigen::VectorXd of_columns(of_body[b].size());
  for (unsigned int i = 0; i < of_body[b].size(); ++i)
    of_columns[i] = z[of_body[b][i]];
  return of_columns;
}

Eigen::VectorXd FrameSystem::force_on(const unsigned int b) const
{
  return V[b] * z_of(b);
}

bool FrameSystem::solve_active(const Eigen::VectorXd &right)
{
  std::vector<int> number(columns.size(), -1);
  int n = 0;
  for (const unsigned int i : order)
    if (active[i])
      number[i] = n++;
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto &entry : own)
    if (active[entry.row()] && active[entry.col()])
    {
      const int row = number[entry.row()], column = number[entry.col()];
      entries.emplace_back(std::max(row, column), std::min(row, column), entry.value());
    }
  for (unsigned int b = 0; b < of_body.size(); ++b)
    for (unsigned int j = 0; j < of_body[b].size(); ++j)
      if (active[of_body[b][j]])
        for (unsigned int i = j; i < of_body[b].size(); ++i)
          if (active[of_body[b][i]])
          {
            const int row = number[of_body[b][i]], column = number[of_body[b][j]];
            entries.emplace_back(std::max(row, column), std::min(row, column), W[b](i, j));
          }
  Eigen::SparseMatrix<double> N(n, n);
  N.setFromTriplets(entries.begin(), entries.end());
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(N);
  if (factor.info() != Eigen::Success)
    return false;
  const auto &D = factor.vectorD();
  negative = (D.array() < 0.).count();
  Eigen::VectorXd b(n);
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (active[i])
      b[number[i]] = right[i];
  Eigen::VectorXd x = factor.solve(b);
  x += factor.solve(Eigen::VectorXd(b - N.selfadjointView<Eigen::Lower>() * x));
  if (!x.allFinite())
    return false;
  z.setZero();
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (active[i])
      z[i] = x[number[i]];
  return true;
}

bool FrameSystem::solve(const std::vector<Eigen::VectorXd> &way_without,
                        const double cell_size,
                        const unsigned int negative_of_bodies)
{
  Eigen::VectorXd right = -gap;
  for (unsigned int b = 0; b < of_body.size(); ++b)
    if (!of_body[b].empty())
    {
      const Eigen::VectorXd moved = V[b].transpose() * way_without[b];
      for (unsigned int i = 0; i < of_body[b].size(); ++i)
        right[of_body[b][i]] -= moved[i];
    }
  bool settled = false;
  for (unsigned int pass = 0; pass < most_passes && !settled; ++pass)
  {
    ++passes;
    if (!solve_active(right) || (pass >= most_in_saddle && wrong_inertia(negative_of_bodies) != 0))
      return false;
    // Gaps with these forces: N z - right.
    Eigen::VectorXd here = -right;
    for (unsigned int b = 0; b < of_body.size(); ++b)
      if (!of_body[b].empty())
      {
        const Eigen::VectorXd effect = W[b] * z_of(b);
        for (unsigned int i = 0; i < of_body[b].size(); ++i)
          here[of_body[b][i]] += effect[i];
      }
    for (const auto &entry : own)
    {
      here[entry.col()] += entry.value() * z[entry.row()];
      if (entry.row() != entry.col())
        here[entry.row()] += entry.value() * z[entry.col()];
    }
    const double largest = z.size() > 0 ? z.cwiseAbs().maxCoeff() : 0.;
    settled = true;
    int worst = -1;
    double most = 0.;
    for (unsigned int i = 0; i < columns.size(); ++i)
    {
      if (columns[i].kind != Column::ray)
        continue;
      const bool pulls = active[i] && z[i] < -1e-12 * largest,
                 overlaps = !active[i] && here[i] < -1e-10 * cell_size;
      if (!pulls && !overlaps)
        continue;
      settled = false;
      if (pass < one_by_one)
        active[i] = overlaps;
      else
      {
        const double amount = pulls ? -z[i] / largest : -here[i] / cell_size;
        if (amount > most)
        {
          most = amount;
          worst = i;
        }
      }
    }
    if (worst >= 0)
      active[worst] = !active[worst];
  }
  for (unsigned int i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::ray)
      found[columns[i].frame][columns[i].ray_number] = std::max(0., z[i]);
  return settled;
}
} // namespace softgrain::mpm
