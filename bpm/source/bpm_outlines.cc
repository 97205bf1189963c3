// SPDX-License-Identifier: LGPL-2.1-or-later
// The part of BpmModel that draws the outlines of bodies, and tells others what bodies look like.
#include <softgrain/base/parallel.h>
#include <softgrain/bpm/bpm_model.h>
#include <softgrain/geometry/aggregate_outline.h>
#include <softgrain/geometry/polygon.h>

#include <deal.II/base/timer.h>

#include <map>

namespace softgrain::bpm
{
namespace
{
/// Primaries of one body by their order in it.
struct Cluster
{
  std::size_t body;
  std::vector<dealii::Point<2>> center; ///< [m]
  std::vector<double> radius;           ///< [m]
};

using Loops = std::vector<std::vector<dealii::Point<2>>>;

/// Draws the outlines of @p clusters into @p result.
void draw(const std::vector<Cluster> &clusters, const double opening, std::vector<Loops> &result)
{
  parallel_for(clusters.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t k = begin; k < end; ++k)
                   result[clusters[k].body] =
                       aggregate_outline(clusters[k].center, clusters[k].radius, opening);
               });
}

void encode(const std::size_t body, const Loops &loops, std::vector<double> &numbers)
{
  numbers.insert(numbers.end(), {static_cast<double>(body), static_cast<double>(loops.size())});
  for (const auto &loop : loops)
  {
    numbers.push_back(loop.size());
    for (const dealii::Point<2> &x : loop)
      numbers.insert(numbers.end(), {x[0], x[1]});
  }
}

void decode(const std::vector<double> &numbers, std::vector<Loops> &result)
{
  for (std::size_t k = 0; k < numbers.size();)
  {
    Loops &loops = result[static_cast<std::size_t>(numbers[k])];
    loops.assign(static_cast<std::size_t>(numbers[k + 1]), {});
    k += 2;
    for (auto &loop : loops)
      for (auto left = static_cast<std::size_t>(numbers[k++]); left > 0; --left, k += 2)
        loop.emplace_back(numbers[k], numbers[k + 1]);
  }
}
} // namespace

BpmModel::Outlines BpmModel::outlines() const
{
  const dealii::TimerOutput::Scope section(*timer, "outlines");
  Outlines result(scene.bodies.size());
  if (dynamics->strips() == nullptr)
  {
    draw_outlines(result);
    return result;
  }
  std::vector<double> numbers;
  for (const std::size_t body : draw_own_outlines(result))
    encode(body, result[body], numbers);
  for (const std::vector<double> &list : exchange.lists_of_all(numbers))
    decode(list, result);
  return result;
}

std::vector<double> BpmModel::outlined_areas() const
{
  const dealii::TimerOutput::Scope section(*timer, "outlines");
  Outlines result(scene.bodies.size());
  std::vector<double> areas(scene.bodies.size());
  const auto area_of = [&](const std::size_t body)
  {
    double sum = 0.;
    for (const auto &loop : result[body])
      sum += signed_area(loop);
    return sum;
  };
  if (dynamics->strips() == nullptr)
  {
    draw_outlines(result);
    for (std::size_t b = 0; b < areas.size(); ++b)
      areas[b] = area_of(b);
    return areas;
  }
  std::vector<double> numbers;
  for (const std::size_t body : draw_own_outlines(result))
    numbers.insert(numbers.end(), {static_cast<double>(body), area_of(body)});
  for (const std::vector<double> &list : exchange.lists_of_all(numbers))
    for (std::size_t k = 0; k < list.size(); k += 2)
      areas[static_cast<std::size_t>(list[k])] = list[k + 1];
  return areas;
}

void BpmModel::draw_outlines(Outlines &result) const
{
  const Primaries &disks = dynamics->disks();
  parallel_for(scene.bodies.size(), 1,
               [&](const std::size_t begin, const std::size_t end)
               {
                 for (std::size_t b = begin; b < end; ++b)
                 {
                   std::vector<dealii::Point<2>> centers;
                   for (std::size_t i = first_of_body[b]; i < first_of_body[b + 1]; ++i)
                     centers.emplace_back(disks.position[i][0], disks.position[i][1]);
                   const std::vector<double> radii(disks.radius.begin() + first_of_body[b],
                                                   disks.radius.begin() + first_of_body[b + 1]);
                   result[b] = aggregate_outline(centers, radii, 0.5 * diameter);
                 }
               });
}

std::vector<std::size_t> BpmModel::draw_own_outlines(Outlines &result) const
{
  const Primaries &disks = dynamics->disks();
  // Own primaries of a body follow each other. Of a body that several owners have some of, the lowest one
  // draws it.
  std::vector<std::pair<std::size_t, std::size_t>> own; // where those of a body begin and end
  for (std::size_t i = 0; i < n_own(*dynamics); ++i)
    if (i == 0 || disks.body[i] != disks.body[i - 1])
      own.emplace_back(i, i + 1);
    else
      ++own.back().second;
  const auto size = [this](const std::size_t body) { return first_of_body[body + 1] - first_of_body[body]; };
  std::vector<double> divided;
  for (const auto &[begin, end] : own)
    if (end - begin < size(disks.body[begin]))
      divided.push_back(disks.body[begin]);
  std::map<std::size_t, unsigned int> drawer;
  const std::vector<std::vector<double>> divided_of_all = exchange.lists_of_all(divided);
  for (unsigned int r = 0; r < exchange.number(); ++r)
    for (const double body : divided_of_all[r])
      drawer.emplace(static_cast<std::size_t>(body), r);

  std::vector<std::vector<double>> lists(exchange.number());
  for (const auto &[begin, end] : own)
  {
    const auto found = drawer.find(disks.body[begin]);
    std::vector<double> &to = lists[found == drawer.end() ? exchange.here() : found->second];
    for (std::size_t i = begin; i < end; ++i)
      to.insert(to.end(), {static_cast<double>(disks.number[i]), static_cast<double>(disks.body[i]),
                           disks.position[i][0], disks.position[i][1], disks.radius[i]});
  }
  std::map<std::size_t, Cluster> clusters;
  for (const std::vector<double> &list : exchange.to_each(std::move(lists)))
    for (std::size_t k = 0; k < list.size(); k += 5)
    {
      const auto number = static_cast<std::size_t>(list[k]), body = static_cast<std::size_t>(list[k + 1]);
      Cluster &cluster = clusters[body];
      cluster.body = body;
      cluster.center.resize(size(body));
      cluster.radius.resize(size(body));
      cluster.center[number - first_of_body[body]] = dealii::Point<2>(list[k + 2], list[k + 3]);
      cluster.radius[number - first_of_body[body]] = list[k + 4];
    }
  std::vector<Cluster> mine;
  for (auto &[body, cluster] : clusters)
    mine.push_back(std::move(cluster));
  exchange.together([&]() { draw(mine, 0.5 * diameter, result); });
  std::vector<std::size_t> drawn;
  for (const Cluster &cluster : mine)
    drawn.push_back(cluster.body);
  return drawn;
}

void BpmModel::tell_of_bodies(Snapshot<2> &snapshot, const Outlines &loops) const
{
  constexpr unsigned int of_body = 11, of_contact = 13;
  std::vector<double> bodies, contacts;
  for (const BodyState<2> &b : snapshot.bodies)
    bodies.insert(bodies.end(),
                  {b.area, b.reference_area, b.mass, b.center[0], b.center[1], b.velocity[0], b.velocity[1],
                   b.angular_momentum, b.mean_stress[0][0], b.mean_stress[1][1], b.mean_stress[0][1]});
  for (const ContactState<2> &c : snapshot.contacts)
    contacts.insert(contacts.end(),
                    {static_cast<double>(c.body_a), static_cast<double>(c.body_b),
                     static_cast<double>(c.wall), c.place[0], c.place[1], c.normal[0], c.normal[1],
                     c.force[0], c.force[1], c.length, c.gap, c.image[0], c.image[1]});
  const std::vector<double> all_bodies = exchange.lists_of_all(bodies)[0],
                            all_contacts = exchange.lists_of_all(contacts)[0];
  if (exchange.first())
    return;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
  {
    const double *const n = &all_bodies[of_body * b];
    BodyState<2> state;
    state.name = scene.bodies[b].name;
    state.outline = loops[b];
    state.area = n[0];
    state.reference_area = n[1];
    state.mass = n[2];
    state.center = dealii::Point<2>(n[3], n[4]);
    state.velocity = dealii::Tensor<1, 2>({n[5], n[6]});
    state.angular_momentum = n[7];
    state.mean_stress[0][0] = n[8];
    state.mean_stress[1][1] = n[9];
    state.mean_stress[0][1] = n[10];
    snapshot.bodies.push_back(state);
  }
  for (std::size_t k = 0; k < all_contacts.size(); k += of_contact)
  {
    const double *const n = &all_contacts[k];
    ContactState<2> state;
    state.body_a = static_cast<unsigned int>(n[0]);
    state.body_b = static_cast<unsigned int>(n[1]);
    state.wall = static_cast<unsigned int>(n[2]);
    state.place = dealii::Point<2>(n[3], n[4]);
    state.normal = dealii::Tensor<1, 2>({n[5], n[6]});
    state.force = dealii::Tensor<1, 2>({n[7], n[8]});
    state.length = n[9];
    state.gap = n[10];
    state.image = dealii::Tensor<1, 2>({n[11], n[12]});
    snapshot.contacts.push_back(state);
  }
}
} // namespace softgrain::bpm
