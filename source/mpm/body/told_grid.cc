// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/mpm/body/told_grid.h>

#include <utility>

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
  void add_weights(WeightsOfPlaces &places)
  {
    const std::size_t n = count();
    places.add(at, at + n, n);
    at += 2 * n;
  }

  const double *at;
};

void tell_nodes(const BodyField<2> &field, std::vector<double> &numbers)
{
  numbers.push_back(field.n_independent());
  for (unsigned int i = 0; i < field.n_independent(); ++i)
    for (unsigned int d = 0; d < 2; ++d)
      numbers.push_back(field.position(field.node_of_independent(i))[d]);
}

void tell_markers(const BodyField<2> &field, std::vector<double> &numbers)
{
  for (std::size_t m = 0; m < field.all_marker_weights().size(); ++m)
  {
    const NodeWeightsView weights = field.marker_weights(m);
    numbers.push_back(weights.size);
    numbers.insert(numbers.end(), weights.node, weights.node + weights.size);
    numbers.insert(numbers.end(), weights.weight, weights.weight + weights.size);
  }
}
} // namespace

std::vector<double> tell_grid(const Body<2> &body, const ToldField told)
{
  std::vector<double> numbers = {static_cast<double>(body.n_points), body.rest_area};
  if (told == ToldField::everywhere)
    body.field.tell(numbers);
  else
    tell_nodes(body.field, numbers);
  if (told == ToldField::at_outline)
    tell_markers(body.field, numbers);
  for (const Eigen::VectorXd *const vector : {&body.mass, &body.velocity})
  {
    numbers.push_back(vector->size());
    numbers.insert(numbers.end(), vector->data(), vector->data() + vector->size());
  }
  return numbers;
}

void take_grid(const std::vector<double> &numbers,
               const ToldField told,
               const Lattice<2> &lattice,
               const ShapeFunction &shape,
               Body<2> &body)
{
  Reader in(numbers);
  body.n_points = in.count();
  body.rest_area = in.number();
  if (told == ToldField::everywhere)
    in.at = body.field.take(lattice, shape, body.levels.get(), in.at);
  else
  {
    std::vector<dealii::Point<2>> nodes(in.count());
    for (dealii::Point<2> &x : nodes)
      for (unsigned int d = 0; d < 2; ++d)
        x[d] = in.number();
    WeightsOfPlaces markers;
    for (std::size_t m = 0; told == ToldField::at_outline && m < body.boundary.position.size(); ++m)
      in.add_weights(markers);
    markers.finish();
    body.field.take_outline(std::move(nodes), std::move(markers));
  }
  for (Eigen::VectorXd *const vector : {&body.mass, &body.velocity})
    in.take(*vector, in.count());
  body.displacement = Eigen::VectorXd::Zero(body.field.n_dofs());
  body.velocity_of_points = body.velocity;
  body.internal_force = body.displacement;
}
} // namespace softgrain::mpm
