// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_contact_schemes_elastic_bar_h
#define softgrain_tests_mpm_contact_schemes_elastic_bar_h

#include <Eigen/Sparse>

#include <vector>

namespace softgrain::schemes
{
enum class Mass
{
  lumped,
  consistent,
  redistributed ///< lumped, and the node that meets the wall has none: its neighbour has both, @cite
                ///< khenous2008
};

/// Linear elastic bodies of finite elements with one place where they meet a wall or each other.
struct ElasticSystem
{
  Eigen::SparseMatrix<double> mass, stiffness;
  Eigen::VectorXd load, gap_of; ///< the gap is gap + gap_of · u
  double gap = 0.;

  double gap_at(const Eigen::VectorXd &u) const { return gap + gap_of.dot(u); }
  double energy(const Eigen::VectorXd &u, const Eigen::VectorXd &v) const
  {
    return 0.5 * v.dot(mass * v) + 0.5 * u.dot(stiffness * u) - load.dot(u);
  }
};

/// Adds a bar of linear elements to lists of matrix entries, its first node at index @p first.
class BarEntries
{
public:
  std::vector<Eigen::Triplet<double>> mass, stiffness;

  /// @param contact_node the one without mass with Mass::redistributed, 0 or the last
  void add(const int first,
           const int n_cells,
           const double cell,
           const double modulus,
           const double density,
           const Mass kind,
           const int contact_node)
  {
    const double m = density * cell, k = modulus / cell;
    for (int e = 0; e < n_cells; ++e)
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b)
        {
          const int row = first + e + a, column = first + e + b;
          stiffness.emplace_back(row, column, a == b ? k : -k);
          if (kind == Mass::consistent)
            mass.emplace_back(row, column, a == b ? m / 3. : m / 6.);
          else if (a == b)
          {
            const bool given_away = kind == Mass::redistributed && e + a == contact_node;
            const int to = !given_away ? row : contact_node == 0 ? row + 1 : row - 1;
            mass.emplace_back(to, to, 0.5 * m);
          }
        }
  }
};

inline void finish(ElasticSystem &system, const BarEntries &entries, const int n_nodes)
{
  system.mass.resize(n_nodes, n_nodes);
  system.stiffness.resize(n_nodes, n_nodes);
  system.mass.setFromTriplets(entries.mass.begin(), entries.mass.end());
  system.stiffness.setFromTriplets(entries.stiffness.begin(), entries.stiffness.end());
  system.load = Eigen::VectorXd::Zero(n_nodes);
  system.gap_of = Eigen::VectorXd::Zero(n_nodes);
}

/// A bar whose first node is above a wall.
inline ElasticSystem bar_and_wall(const int n_cells,
                                  const double length,
                                  const double modulus,
                                  const double density,
                                  const Mass kind,
                                  const double gap)
{
  ElasticSystem system;
  BarEntries entries;
  entries.add(0, n_cells, length / n_cells, modulus, density, kind, 0);
  finish(system, entries, n_cells + 1);
  system.gap_of[0] = 1.;
  system.gap = gap;
  return system;
}

/// A bar of n cells whose last node looks at the first one of another bar of twice its length.
inline ElasticSystem two_bars(const int n_cells, const double length, const Mass kind, const double gap)
{
  ElasticSystem system;
  BarEntries entries;
  entries.add(0, n_cells, length / n_cells, 1., 1., kind, n_cells);
  entries.add(n_cells + 1, 2 * n_cells, length / n_cells, 1., 1., kind, 0);
  finish(system, entries, 3 * n_cells + 2);
  system.gap_of[n_cells] = -1.;
  system.gap_of[n_cells + 1] = 1.;
  system.gap = gap;
  return system;
}
} // namespace softgrain::schemes

#endif
