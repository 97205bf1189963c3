// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_body_point_store_h
#define softgrain_mpm_body_point_store_h

#include <softgrain/mpm/body/point_layout.h>
#include <softgrain/mpm/body/writable_point.h>
#include <softgrain/mpm/field/cell_levels.h>
#include <softgrain/mpm/field/lattice.h>

#include <deal.II/fe/mapping_cartesian.h>

#include <deal.II/grid/tria.h>

#include <deal.II/particles/particle_handler.h>

#include <memory>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The material points of bodies: particles of deal.II on the background mesh, with the state that
 * travels with a point as their properties.
 *
 * The location of a particle is where it was when the grid under its body was laid, and its cell is that of
 * this place; its id is its number in the order of generation. Handles name points until the next sort().
 */
template <int dim>
class PointStore
{
public:
  using Handle = typename PointView<dim>::Handle;
  using Index = typename Lattice<dim>::Index;
  using Cell = typename dealii::Triangulation<dim>::active_cell_iterator;

  /// A store without points; cover() is to be called before there are any.
  PointStore(const Lattice<dim> &lattice, const PointLayout<dim> &layout);
  PointStore(const PointStore &) = delete;
  PointStore &operator=(const PointStore &) = delete;

  const PointLayout<dim> &layout() const { return the_layout; }
  std::size_t size() const { return n_points; }

  /// Makes the mesh of the cells from @p first to @p last, in which all points have to stay; removes all
  /// points.
  void cover(const Index &first, const Index &last);
  void cover_all();
  bool covers(const Index &cell) const;
  /// Cell of the mesh at integer coordinates @p c; its index counts the first coordinate fastest.
  Cell cell(const Index &c) const;

  /// Makes room for @p n points in all.
  void reserve(std::size_t n);
  /// Removes all points.
  void clear();

  /**
   * @brief Adds a point of @p body with zeros in all other slots; its id is the number of points so far.
   * @pre @p place lies in what cover() has made
   */
  Handle add(const dealii::Point<dim> &place, unsigned int body);

  WritablePoint<dim> operator()(const Handle handle) const
  {
    return WritablePoint<dim>(particles->get_property_pool(), the_layout, handle);
  }
  unsigned int id(const Handle handle) const { return particles->get_property_pool().get_id(handle); }

  /**
   * @brief Finds the cells of all points after their places have changed. Those that were added are in theirs
   * already; sorting makes deal.II keep tables of the whole mesh.
   * @throw ComputationError when a point has left the mesh
   */
  void sort();

  /// Sizes of the cells of every body; null: as the lattice has them.
  using LevelsOfBodies = std::vector<const CellLevels<dim> *>;

  /// Handles of the points of every body, by cell in the order of the lattice, in a cell by id.
  std::vector<std::vector<Handle>> by_body(const LevelsOfBodies &levels) const;

  const dealii::Particles::ParticleHandler<dim> &handler() const { return *particles; }

private:
  /// Integer coordinates of the cell of the mesh with this index.
  Index index_of(int index) const;

  const Lattice<dim> &lattice;
  const PointLayout<dim> the_layout;
  dealii::MappingCartesian<dim> mapping;
  Index first_cell{}, n_cells{}; ///< of the mesh
  std::unique_ptr<dealii::Triangulation<dim>> mesh;
  std::unique_ptr<dealii::Particles::ParticleHandler<dim>> particles;
  unsigned int n_points = 0;
  std::vector<dealii::Point<dim>> lost; ///< places of points that the last sort() found outside of the mesh
};
} // namespace softgrain::mpm

#endif
