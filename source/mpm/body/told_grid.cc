// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/told_grid.h>

namespace softgrain::mpm
{
namespace
{
/// Reads numbers one after the other.
class Reader
{
public:
  explicit Reader(const std::vector<double> &numbers) : at(numbers.data()) {}

  double number() { return *at++; }
  std::size_t count() { return static_cast<std::size_t>(*at++); }
  void take(Eigen::VectorXd &vector, const std::size_t size)
  {
    vector = Eigen::Map<const Eigen::VectorXd>(at, size);
    at += size;
  }
  const double *at;
};
} // namespace

std::vector<double> tell_grid(const Body<2> &body)
{
  std::vector<double> numbers = {static_cast<double>(body.n_points), body.rest.area};
  body.field.tell(numbers);
  for (const Eigen::VectorXd *const vector : {&body.nodes.mass, &body.nodes.velocity})
  {
    numbers.push_back(vector->size());
    numbers.insert(numbers.end(), vector->data(), vector->data() + vector->size());
  }
  return numbers;
}

void take_grid(const std::vector<double> &numbers,
               const Lattice<2> &lattice,
               const ShapeFunction &shape,
               Body<2> &body)
{
  Reader in(numbers);
  body.n_points = in.count();
  body.rest.area = in.number();
  in.at = body.field.take(lattice, shape, body.levels.get(), in.at);
  for (Eigen::VectorXd *const vector : {&body.nodes.mass, &body.nodes.velocity})
    in.take(*vector, in.count());
  body.nodes.displacement = Eigen::VectorXd::Zero(body.field.n_dofs());
  body.nodes.velocity_of_points = body.nodes.velocity;
  body.nodes.kept.resize(0);
  body.nodes.internal_force = body.nodes.displacement;
}
} // namespace softgrain::mpm
