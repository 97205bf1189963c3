// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_body_field_h
#define softgrain_mpm_field_body_field_h

#include <softgrain/linear/dense_kernels.h>
#include <softgrain/mpm/field/cell_functions.h>
#include <softgrain/mpm/field/cell_levels.h>
#include <softgrain/mpm/field/field_cells.h>
#include <softgrain/mpm/field/field_extension.h>
#include <softgrain/mpm/field/field_nodes.h>
#include <softgrain/mpm/field/lattice.h>
#include <softgrain/mpm/field/node_weights.h>
#include <softgrain/mpm/field/place_functions.h>
#include <softgrain/mpm/field/shape_function.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace softgrain::mpm
{
/// The functions of a field that are not zero at one of its points, in the order of the nodes of its cell.
template <int dim>
struct PointFunctions
{
  const unsigned int *nodes;
  const double *values;
  /// Derivatives in the configuration in which the field was built [1/m].
  const dealii::Tensor<1, dim> *slopes;
};

/**
 * @brief The nodal field of one body on the lattice: which nodes it has, which of them are independent, and
 * the shape values at its points.
 *
 * Nodes that no well-filled cell reaches would have almost no mass and no stiffness. They are not free: they
 * take the value that the polynomial of the nearest well-filled cells extrapolates to them, u = T q (extended
 * B-splines, Höllig, Reif and Wipper 2001; aggregated elements, Badia, Verdugo and Martín 2018). Where
 * several well-filled cells are equally near their mean is taken, so that symmetric bodies keep symmetric
 * fields. T reproduces polynomials up to the degree of the shape functions, hence every rigid and affine
 * motion. It is an AffineConstraints of deal.II over the nodes, the same for every component. Where the cells
 * of a body have different sizes, it holds the hanging nodes as well: a node on a face of a larger cell that
 * is none of its nodes takes the value that this cell has there.
 *
 * A *node* below is a local node of this body; a *dof* is (independent node, direction), numbered node * dim
 * + direction.
 */
template <int dim>
class BodyField
{
public:
  using Index = typename Lattice<dim>::Index;

  /// Inputs of build(): where the body is on the lattice.
  struct Places
  {
    const std::vector<dealii::Point<dim>> &points;  ///< material points, in the order of their cells [m]
    const std::vector<double> &volumes;             ///< their volumes, to tell how full a cell is [m^dim]
    const std::vector<double> &half_extent;         ///< half edge of their domains [m], GIMP only
    const std::vector<dealii::Point<dim>> &markers; ///< boundary markers, where the field must exist too [m]
    const CellLevels<dim> *levels = nullptr;        ///< which lattice cells are one cell; none: each is
  };

  /**
   * @brief Numbers the nodes and evaluates the shape functions.
   * @param fill_limit share of a cell that must be filled for it to count as well filled, in (0, 1]
   * @throw ComputationError when a point or marker lies outside of the mesh
   */
  void
  build(const Lattice<dim> &lattice, const ShapeFunction &shape, const Places &places, double fill_limit);

  /// Adds to @p numbers all that is needed to know the field at any place without the points.
  void tell(std::vector<double> &numbers) const;
  /**
   * @brief Makes it the field that tell() has told: the same at any place, but without points, markers and
   * what assembly needs.
   * @param levels as in Places
   * @return the place behind what it has read of @p numbers
   */
  const double *take(const Lattice<dim> &lattice,
                     const ShapeFunction &shape,
                     const CellLevels<dim> *levels,
                     const double *numbers);

  /// Whether the field has slopes that do not jump.
  bool smooth() const { return shape->smooth(); }
  double cell_size() const { return lattice->cell_size(); }
  unsigned int n_independent() const { return spreading.n_independent(); }
  unsigned int n_dofs() const { return dim * n_independent(); }

  const FieldNodes<dim> &nodes() const { return own_nodes; }
  const FieldCells<dim> &cells() const { return own_cells; }
  /// T, from independent nodes to all.
  const FieldExtension<dim> &extension() const { return spreading; }
  /// Place of independent node @p j [m]; for B-splines the place of its control point.
  const dealii::Point<dim> &place(const unsigned int j) const
  {
    return own_nodes.position(spreading.node(j));
  }

  /// What the field has at point @p p.
  PointFunctions<dim> at_point(const unsigned int p) const
  {
    const unsigned int n = own_cells.nodes_per_cell();
    return {own_cells.nodes(point_cell[p]), &point_values[p * n], &point_slopes[p * n]};
  }
  /**
   * @brief The matrix (independent nodes x nodes) of an extended cell: values at its nodes are its transpose
   * times those of its independent nodes. It is filled up for DenseKernels with rows of zeros.
   * @param room where it is made in space: kept, it would be a tenth of all memory there
   */
  DenseKernels::In spread(unsigned int cell, std::vector<double> &room) const;
  /// The field at the markers, in terms of independent nodes; none where it knows no markers.
  const WeightsOfPlaces &markers() const { return marker_rows; }
  /// The field at any place within the cells that the body reaches; empty when no node of the body reaches
  /// it.
  NodeWeights weights_at(const dealii::Point<dim> &x) const;
  /// Functions at a place with their slopes.
  PlaceFunctions<dim> functions_at(const dealii::Point<dim> &x) const;

private:
  template <int>
  friend class FieldNear;
  struct Box
  {
    Index lower{}, size{};
    std::vector<unsigned int> id;
    void resize(const Index &lower, const Index &upper, unsigned int fill);
    bool contains(const Index &i) const;
    unsigned int &operator()(const Index &i);
    unsigned int operator()(const Index &i) const;
  };

  void stand_on(const Lattice<dim> &lattice, const ShapeFunction &shape, const CellLevels<dim> *levels);
  void collect_cells(const Places &places);
  void number_nodes();
  void evaluate_points(const Places &places);
  void build_extension(const std::vector<double> &volumes, double fill_limit);
  std::vector<Index> nearest_cells(unsigned int node, const Box &of_cells) const;
  using Entries = std::vector<std::pair<dealii::types::global_dof_index, double>>;
  Entries extend_node(unsigned int node, const Box &strong_cells) const;
  void build_cell_dependence();
  /// Where independent nodes of a cell stand in its list, by node; until the next call of this thread.
  const std::vector<unsigned int> &places_in_cell(unsigned int cell) const;
  /// Fills a matrix of zeros, see spread().
  void fill_spread(unsigned int cell, const DenseKernels::Out &matrix) const;
  void color_cells();
  Index first_node(const Index &cell) const;
  Index node_index(const Index &cell, unsigned int k) const;
  /// First lattice cell of the cell of this body that holds lattice cell @p c, and cells along its edge.
  Index home(const Index &c) const { return levels ? levels->first(c) : c; }
  int edge(const Index &c) const { return levels ? levels->edge(c) : 1; }
  /// The cell of this body whose polynomial is the field at @p x: the one that holds it, or one that is
  /// within a hundredth of a cell: an outline may run along the side of a cell, and bulge beyond what its
  /// markers reach.
  std::optional<Index> cell_near(const dealii::Point<dim> &x) const;
  dealii::Point<dim> unit_position(const dealii::Point<dim> &x, const Index &c) const
  {
    return dealii::Point<dim>(lattice->unit_position(x, c) / edge(c));
  }
  void hang_nodes();
  std::vector<Index> nearest_cells_of_levels(unsigned int node, const Box &of_cells) const;
  const Lattice<dim> *lattice = nullptr;
  const ShapeFunction *shape = nullptr;
  const CellLevels<dim> *levels = nullptr;
  /// What a node hangs on, for every node that lies on a face of a larger cell and is none of its nodes.
  std::vector<Entries> hanging;
  std::shared_ptr<const CellFunctions<dim>> functions;

  Box cell_box, node_box;
  std::vector<Index> cell_index, node_lattice_index;
  std::vector<unsigned int> point_cell;
  std::vector<double> point_values;
  std::vector<dealii::Tensor<1, dim>> point_slopes;

  FieldNodes<dim> own_nodes;
  FieldCells<dim> own_cells;
  FieldExtension<dim> spreading;
  WeightsOfPlaces marker_rows;
};
} // namespace softgrain::mpm

#endif
