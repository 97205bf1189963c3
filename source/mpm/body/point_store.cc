// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/body/point_store.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <tuple>

namespace softgrain::mpm
{
template <int dim>
PointStore<dim>::PointStore(const Lattice<dim> &lattice, const PointLayout<dim> &layout)
    : lattice(lattice), the_layout(layout)
{
}

template <int dim>
void PointStore<dim>::cover(const Index &first, const Index &last)
{
  particles.reset(); // it looks at its mesh to the end
  n_points = 0;
  first_cell = first;
  std::vector<unsigned int> repetitions(dim);
  dealii::Point<dim> lower = lattice.lower(), upper;
  for (unsigned int d = 0; d < dim; ++d)
  {
    n_cells[d] = last[d] - first[d] + 1;
    repetitions[d] = n_cells[d];
    lower[d] += first[d] * lattice.cell_size();
    upper[d] = lower[d] + n_cells[d] * lattice.cell_size();
  }
  mesh = std::make_unique<dealii::Triangulation<dim>>();
  dealii::GridGenerator::subdivided_hyper_rectangle(*mesh, repetitions, lower, upper);
  particles =
      std::make_unique<dealii::Particles::ParticleHandler<dim>>(*mesh, mapping, the_layout.n_components());
  particles->signals.particle_lost.connect([this](const auto &particle, const auto &)
                                           { lost.push_back(particle->get_location()); });
}

template <int dim>
void PointStore<dim>::cover_all()
{
  Index first{}, last = lattice.n_cells();
  for (int &c : last)
    --c;
  cover(first, last);
}

template <int dim>
bool PointStore<dim>::covers(const Index &cell) const
{
  for (unsigned int d = 0; d < dim; ++d)
    if (cell[d] < first_cell[d] || cell[d] >= first_cell[d] + n_cells[d])
      return false;
  return true;
}

template <int dim>
typename PointStore<dim>::Cell PointStore<dim>::cell(const Index &c) const
{
  int index = 0;
  for (int d = dim - 1; d >= 0; --d)
    index = index * n_cells[d] + c[d] - first_cell[d];
  return Cell(mesh.get(), 0, index);
}

template <int dim>
typename PointStore<dim>::Index PointStore<dim>::index_of(int index) const
{
  Index c;
  for (unsigned int d = 0; d < dim; ++d)
  {
    c[d] = first_cell[d] + index % n_cells[d];
    index /= n_cells[d];
  }
  return c;
}

template <int dim>
void PointStore<dim>::reserve(const std::size_t n)
{
  particles->get_property_pool().reserve(n);
}

template <int dim>
void PointStore<dim>::clear()
{
  particles->clear();
  n_points = 0;
}

template <int dim>
typename PointStore<dim>::Handle PointStore<dim>::add(const dealii::Point<dim> &place,
                                                      const unsigned int body)
{
  const dealii::Point<dim> x = lattice.off_faces(place);
  const typename Lattice<dim>::Index cell = lattice.cell_of(x);
  auto particle = particles->insert_particle(x, lattice.unit_position(x, cell), n_points++, this->cell(cell));
  const dealii::ArrayView<double> properties = particle->get_properties();
  std::fill(properties.begin(), properties.end(), 0.);
  properties[the_layout.offset(PointSlot::body)] = body;
  return particle->get_local_index();
}

template <int dim>
void PointStore<dim>::sort()
{
  lost.clear();
  particles->sort_particles_into_subdomains_and_cells();
  if (lost.empty())
    return;
  std::ostringstream message;
  message << lost.size() << " material point(s) left the background mesh, the first near (" << lost.front()
          << ") m: enlarge 'Mesh/Lower' and 'Mesh/Upper'";
  throw ComputationError(message.str());
}

template <int dim>
std::vector<std::vector<typename PointStore<dim>::Handle>>
PointStore<dim>::by_body(const LevelsOfBodies &levels) const
{
  // The particles of a cell stand in the order in which they came there: a restart would not know it, ids do.
  using Place = std::tuple<std::int64_t, unsigned int, Handle>;
  std::vector<std::vector<Place>> places(levels.size());
  for (const auto &particle : *particles)
  {
    const Handle handle = particle.get_local_index();
    const unsigned int body = (*this)(handle).body();
    Index c = index_of(particle.get_surrounding_cell()->index());
    if (levels[body] != nullptr)
      c = levels[body]->first(lattice.cell_of(particle.get_location()));
    // Counted in the whole lattice, so that it does not depend on what is covered here.
    std::int64_t number = 0;
    for (int d = dim - 1; d >= 0; --d)
      number = number * lattice.n_cells()[d] + c[d];
    places[body].emplace_back(number, particle.get_id(), handle);
  }
  std::vector<std::vector<Handle>> lists(levels.size());
  for (unsigned int b = 0; b < levels.size(); ++b)
  {
    std::sort(places[b].begin(), places[b].end());
    lists[b].reserve(places[b].size());
    for (const Place &place : places[b])
      lists[b].push_back(std::get<2>(place));
  }
  return lists;
}

template class PointStore<2>;
template class PointStore<3>;
} // namespace softgrain::mpm
