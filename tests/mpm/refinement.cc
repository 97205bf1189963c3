// SPDX-License-Identifier: LGPL-2.1-or-later
// Cells of three sizes, in two and three dimensions: nodes that hang take polynomials of the degree of the
// shape functions from what they hang on, and no other field tears where cells of different sizes meet. A
// disk of eight cells between two plates, three levels of smaller cells at the contacts: Johnson's force
// (Contact Mechanics, section 5.6) within 1 % where the contact is a sixteenth of a cell wide. Cells on both
// sides of an outline that ends on a line of the grid are small.
#include "scene_of.h"

#include <softgrain/mpm/field/lattice_box.h>

#include <iostream>
#include <random>

using namespace softgrain;

namespace
{
/// A full block of cells of three sizes, the smallest at a corner.
template <int dim>
class Block
{
public:
  explicit Block(const std::string &name)
      : shape(mpm::create_shape_function(name))
      , lattice(dealii::Point<dim>(), corner(1.), 1. / n)
      , levels(lattice,
               dealii::Point<dim>(),
               corner(1. - 0.5 / n),
               2,
               [](const auto &lower, const auto &, const unsigned int level)
               { return lower.norm() < 0.25 * level; })
  {
    std::array<int, dim> first, last;
    first.fill(0);
    last.fill(3 * n - 1);
    std::vector<dealii::Point<dim>> points;
    mpm::for_box<dim>(first, last,
                      [&](const auto &i)
                      {
                        dealii::Point<dim> x;
                        for (unsigned int d = 0; d < dim; ++d)
                          x[d] = (i[d] + 0.5) / (3. * n);
                        points.push_back(x);
                      });
    field.build(lattice, *shape,
                {points, std::vector<double>(points.size(), 1. / points.size()), {}, {}, &levels}, 0.6);
  }

  static dealii::Point<dim> corner(const double x)
  {
    dealii::Point<dim> p;
    for (unsigned int d = 0; d < dim; ++d)
      p[d] = x;
    return p;
  }

  /// The field @p f of independent nodes at a place.
  template <typename F>
  double value(const dealii::Point<dim> &x, const F &f) const
  {
    const mpm::NodeWeights weights = field.weights_at(x);
    double sum = 0.;
    for (unsigned int k = 0; k < weights.node.size(); ++k)
      sum += weights.weight[k] * f(field.place(weights.node[k]));
    return sum;
  }

  static constexpr int n = 8;
  const std::unique_ptr<mpm::ShapeFunction> shape;
  const mpm::Lattice<dim> lattice;
  const mpm::CellLevels<dim> levels;
  mpm::BodyField<dim> field;
};

template <int dim>
void check_field(const std::string &name)
{
  const Block<dim> block(name);
  const unsigned int degree = block.shape->degree();
  const auto polynomial = [&](const dealii::Point<dim> &x)
  { return 1. + x[0] - 2. * x[1] + (degree > 1 ? x[0] * x[0] - 3. * x[0] * x[1] : 0.); };
  const auto wave = [](const dealii::Point<dim> &x) { return std::sin(7. * x[0]) * std::cos(9. * x[1]); };
  std::mt19937 generator(1);
  std::uniform_real_distribution<> uniform(0., 1.);
  double wrong = 0., torn = 0.;
  for (unsigned int trial = 0; trial < 2000; ++trial)
  {
    dealii::Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = uniform(generator);
    wrong = std::max(wrong, std::abs(block.value(x, polynomial) - polynomial(x)));
    // Both sides of a face of the smallest cells, of which some are faces of larger ones.
    const unsigned int d = trial % dim;
    x[d] = static_cast<double>(1 + trial % (block.n - 1)) / block.n;
    dealii::Point<dim> before = x, after = x;
    before[d] -= 1e-9;
    after[d] += 1e-9;
    torn = std::max(torn, std::abs(block.value(after, wave) - block.value(before, wave)));
  }
  const unsigned int hanging = block.field.nodes().n() - block.field.n_independent();
  std::cout << name << ' ' << dim << "d: hanging nodes " << hanging << " of " << block.field.nodes().n()
            << ", polynomials " << below(1e-12, wrong) << ", jumps " << below(1e-6, torn) << '\n';
}

void press(const unsigned int n_levels)
{
  constexpr double R = 5e-3, E = 10e6, nu = 0.45, approach = 0.002 * R, c = (1. - nu * nu) / (M_PI * E);
  double low = 1e-3, high = 1e5;
  for (unsigned int i = 0; i < 200; ++i)
  {
    const double F = 0.5 * (low + high), a = std::sqrt(4. * F * R * c);
    (F * c * (2. * std::log(4. * R / a) - 1.) < approach ? low : high) = F;
  }
  const auto model =
      shipped_scene("verification/line_contact.prm",
                    {"Mesh/Cell size=1.2e-3", "Mesh/Lower=-9.6e-3, -7.2e-3", "Mesh/Upper=9.6e-3, 7.2e-3",
                     "Mesh/Refine near contact=" + std::to_string(n_levels), "Time/Time step=1e-3",
                     "Material points/Shape function=quadratic", "Material points/Points per direction=3"});
  run_until(*model, 0.002);
  const double error = model->walls()[1].normal_force / low - 1.;
  std::cout << "line contact, " << n_levels << " levels: force over Johnson's less 1 "
            << (n_levels == 0 ? std::to_string(error) : below(0.01, error)) << '\n';
}
/// Forces along one of the two contacts of a disk, from left to right [N/m].
std::vector<double> forces_at(const Snapshot<2> &state, const bool top)
{
  std::vector<std::pair<double, double>> found;
  for (const ContactState<2> &contact : state.contacts)
    if ((contact.place[1] > 0.) == top)
      found.emplace_back(contact.place[0], std::abs(contact.force[1]));
  std::sort(found.begin(), found.end());
  std::vector<double> forces;
  for (const auto &[x, force] : found)
    forces.push_back(force);
  return forces;
}

/// A disk that ends on lines of the grid: rounding must not tell its bottom from its top.
void end_on_a_line()
{
  const auto model = shipped_scene("verification/line_contact.prm",
                                   {"Mesh/Cell size=5e-4", "Mesh/Lower=-6e-3, -6e-3", "Mesh/Upper=6e-3, 6e-3",
                                    "Mesh/Refine near contact=3", "Time/Time step=2e-3",
                                    "Material points/Shape function=linear"});
  run_until(*model, 0.006);
  const Snapshot<2> state = model->snapshot();
  const std::vector<double> bottom = forces_at(state, false), top = forces_at(state, true);
  double differs = 0., sum = 0.;
  for (unsigned int k = 0; k < std::min(bottom.size(), top.size()); ++k)
  {
    differs += std::abs(bottom[k] - top[k]);
    sum += top[k];
  }
  std::cout << "outline that ends on a line of the grid: rows " << bottom.size() << " and " << top.size()
            << ", forces of bottom and top differ by " << below(1e-3, differs / sum) << '\n';
}
} // namespace

int main()
{
  for (const char *name : {"linear", "quadratic"})
  {
    check_field<2>(name);
    check_field<3>(name);
  }
  press(0);
  press(3);
  end_on_a_line();
}
