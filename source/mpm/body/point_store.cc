// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/body/point_store.h>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace softgrain::mpm
{
template <int dim>
PointStore<dim>::PointStore(const Lattice<dim> &lattice, const PointLayout<dim> &layout)
    : lattice(lattice), the_layout(layout), particles(lattice.triangulation(), mapping, layout.n_components())
{
  particles.signals.particle_lost.connect([this](const auto &particle, const auto &)
                                          { lost.push_back(particle->get_location()); });
}

template <int dim>
void PointStore<dim>::reserve(const std::size_t n)
{
  particles.get_property_pool().reserve(n);
}

template <int dim>
void PointStore<dim>::clear()
{
  particles.clear();
  n_points = 0;
}

template <int dim>
typename PointStore<dim>::Handle PointStore<dim>::add(const dealii::Point<dim> &place,
                                                      const unsigned int body)
{
  const dealii::Point<dim> x = lattice.off_faces(place);
  const typename Lattice<dim>::Index cell = lattice.cell_of(x);
  auto particle =
      particles.insert_particle(x, lattice.unit_position(x, cell), n_points++, lattice.cell(cell));
  const dealii::ArrayView<double> properties = particle->get_properties();
  std::fill(properties.begin(), properties.end(), 0.);
  properties[the_layout.offset(PointSlot::body)] = body;
  return particle->get_local_index();
}

template <int dim>
void PointStore<dim>::sort()
{
  lost.clear();
  particles.sort_particles_into_subdomains_and_cells();
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
  using Place = std::tuple<int, unsigned int, Handle>;
  std::vector<std::vector<Place>> places(levels.size());
  for (const auto &particle : particles)
  {
    const Handle handle = particle.get_local_index();
    const unsigned int body = (*this)(handle).body();
    int cell = particle.get_surrounding_cell()->index();
    if (levels[body] != nullptr)
      cell = lattice.cell(levels[body]->first(lattice.cell_of(particle.get_location())))->index();
    places[body].emplace_back(cell, particle.get_id(), handle);
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
