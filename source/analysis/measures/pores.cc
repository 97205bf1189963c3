// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>

#include <algorithm>
#include <cmath>

namespace softgrain
{
namespace
{
/**
 * @brief Pores by the number of bodies around them: the loops of contacts of @cite nguyen2016, fig. 4.6.
 *
 * Centres of bodies joined by their contacts make a plane graph. Its faces are the pores; bodies that hang on
 * one contact are left out, and so is the face outside. A gain of contacts cuts pores of four bodies and more
 * into pores of three.
 */
class Pores final : public Measure
{
public:
  std::vector<std::string> columns() const override
  {
    return {"pores_of_3_bodies", "pores_of_4_bodies", "pores_of_5_bodies_or_more",
            "fraction_of_pores_of_3_bodies"};
  }

  std::vector<MeasuredValue> evaluate(const Assembly &assembly) const override
  {
    if (std::any_of(assembly.snapshot.walls.begin(), assembly.snapshot.walls.end(),
                    [](const WallState<2> &wall) { return wall.repeats; }))
      return std::vector<MeasuredValue>(4); // graphs that close on themselves have no face outside
    const Graph graph = contact_graph(assembly);
    double count[3] = {0., 0., 0.};
    std::vector<std::vector<bool>> passed(graph.size());
    for (std::size_t b = 0; b < graph.size(); ++b)
      passed[b].resize(graph[b].size(), false);
    for (unsigned int b = 0; b < graph.size(); ++b)
      for (unsigned int e = 0; e < graph[b].size(); ++e)
        if (!passed[b][e])
        {
          const auto [sides, area] = walk_around_face(assembly, graph, b, e, passed);
          if (area > 0.)
            count[sides <= 4 ? sides - 3 : 2] += 1.;
        }
    const double n = count[0] + count[1] + count[2];
    return {count[0], count[1], count[2], n > 0. ? MeasuredValue(count[0] / n) : std::nullopt};
  }

private:
  /// Neighbours of every body, counter-clockwise.
  using Graph = std::vector<std::vector<unsigned int>>;

  static Graph contact_graph(const Assembly &assembly)
  {
    const auto &bodies = assembly.snapshot.bodies;
    Graph graph(bodies.size());
    for (const BodyContact &contact : assembly.contacts)
      if (!contact.with_wall())
      {
        graph[contact.body_a].push_back(contact.body_b);
        graph[contact.body_b].push_back(contact.body_a);
      }
    std::vector<unsigned int> hanging;
    for (unsigned int b = 0; b < graph.size(); ++b)
      if (graph[b].size() == 1)
        hanging.push_back(b);
    while (!hanging.empty())
    {
      const unsigned int b = hanging.back();
      hanging.pop_back();
      if (graph[b].empty())
        continue; // its only partner hung on it
      auto &others = graph[graph[b][0]];
      others.erase(std::find(others.begin(), others.end(), b));
      if (others.size() == 1)
        hanging.push_back(graph[b][0]);
      graph[b].clear();
    }
    for (unsigned int b = 0; b < graph.size(); ++b)
    {
      const auto angle = [&](const unsigned int other)
      {
        const dealii::Tensor<1, 2> d = bodies[other].center - bodies[b].center;
        return std::atan2(d[1], d[0]);
      };
      std::sort(graph[b].begin(), graph[b].end(),
                [&](const unsigned int c, const unsigned int d) { return angle(c) < angle(d); });
    }
    return graph;
  }

  /// Follows the face to the left of edge @p e of body @p b. @return its edges and its area, negative outside
  static std::pair<unsigned int, double> walk_around_face(const Assembly &assembly,
                                                          const Graph &graph,
                                                          unsigned int b,
                                                          unsigned int e,
                                                          std::vector<std::vector<bool>> &passed)
  {
    const dealii::Point<2> origin = assembly.snapshot.bodies[b].center;
    unsigned int sides = 0;
    double area = 0.;
    while (!passed[b][e])
    {
      passed[b][e] = true;
      const unsigned int next = graph[b][e];
      const dealii::Tensor<1, 2> from = assembly.snapshot.bodies[b].center - origin;
      const dealii::Tensor<1, 2> to = assembly.snapshot.bodies[next].center - origin;
      area += 0.5 * (from[0] * to[1] - from[1] * to[0]);
      ++sides;
      // The face lies to the left, so it goes on with the edge before the one it came by, counter-clockwise.
      const auto back = std::find(graph[next].begin(), graph[next].end(), b) - graph[next].begin();
      e = (back + graph[next].size() - 1) % graph[next].size();
      b = next;
    }
    return {sides, area};
  }
};

[[maybe_unused]] const bool registered =
    register_measure<Pores>("pores", "loops of contacts: pores between three, four and more bodies");
} // namespace
} // namespace softgrain
