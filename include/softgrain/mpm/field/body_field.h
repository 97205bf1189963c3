// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_field_body_field_h
#define softgrain_mpm_field_body_field_h

#include <softgrain/mpm/field/cell_functions.h>
#include <softgrain/mpm/field/cell_levels.h>
#include <softgrain/mpm/field/lattice.h>
#include <softgrain/mpm/field/node_weights.h>
#include <softgrain/mpm/field/place_functions.h>
#include <softgrain/mpm/field/shape_function.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <deal.II/lac/affine_constraints.h>

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace softgrain::mpm
{
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
  unsigned int n_nodes() const { return node_position.size(); }
  unsigned int n_independent() const { return independent_node.size(); }
  unsigned int n_dofs() const { return dim * n_independent(); }
  unsigned int n_cells() const { return cell_point_start.size() - 1; }
  unsigned int nodes_per_cell() const { return n_cell_nodes; }

  /// Place of local node @p i [m]; for B-splines the place of its control point.
  const dealii::Point<dim> &position(const unsigned int i) const { return node_position[i]; }
  /// Lattice number of local node @p i, the same for all bodies.
  std::int64_t lattice_node(const unsigned int i) const { return lattice_number[i]; }
  /// Local node of independent node @p j.
  unsigned int node_of_independent(const unsigned int j) const { return independent_node[j]; }

  /// Nodes of the cell of point @p p; values and slopes run in the same order.
  const unsigned int *point_nodes(const unsigned int p) const
  {
    return &cell_nodes[point_cell[p] * n_cell_nodes];
  }
  const double *values(const unsigned int p) const { return &point_values[p * n_cell_nodes]; }
  /// Slopes in the configuration in which the field was built [1/m].
  const dealii::Tensor<1, dim> *slopes(const unsigned int p) const { return &point_slopes[p * n_cell_nodes]; }

  /// Points are sorted by cell: those of cell @p c are first_point(c) ... first_point(c + 1) - 1.
  unsigned int first_point(const unsigned int c) const { return cell_point_start[c]; }
  const unsigned int *nodes_of_cell(const unsigned int c) const { return &cell_nodes[c * n_cell_nodes]; }

  /**
   * @brief Sums what cells give to their nodes, in an order that does not depend on the number of threads.
   * @param[in]  of_cells dim values per node of every cell
   * @param[out] all      dim values per node
   */
  void gather(const std::vector<double> &of_cells, Eigen::VectorXd &all) const;

  /// T q: values at all nodes from those at the independent nodes. Vectors hold dim components per node.
  void prolongate(const Eigen::VectorXd &independent, Eigen::VectorXd &all) const;
  /// T^T f: forces at all nodes moved to the independent ones.
  void restrict(const Eigen::VectorXd &all, Eigen::VectorXd &independent) const;
  /// T^T m for one scalar per node.
  Eigen::VectorXd restrict_scalar(const std::vector<double> &all) const;

  /// T: a constraint for every node that is not independent, on nodes that are.
  const dealii::AffineConstraints<double> &constraints() const { return dependent; }
  /// Row i of T, in terms of independent nodes.
  NodeWeights extension(unsigned int node) const;
  /// The field at marker @p m in terms of independent nodes.
  NodeWeightsView marker_weights(const unsigned int m) const { return marker_rows[m]; }
  bool knows_markers() const { return marker_rows.size() > 0; }
  /// The field at any place within the cells that the body reaches; empty when no node of the body reaches
  /// it.
  NodeWeights weights_at(const dealii::Point<dim> &x) const;
  /// Functions at a place with their slopes.
  PlaceFunctions<dim> functions_at(const dealii::Point<dim> &x) const;

  /// Independent nodes that the nodes of cell @p c depend on, and the matrix (nodes_per_cell x that many)
  /// between them; the matrix is empty when the nodes themselves are independent.
  const std::vector<unsigned int> &cell_independent(const unsigned int c) const { return cell_dependence[c]; }
  const Eigen::MatrixXd &cell_extension(const unsigned int c) const { return cell_matrix[c]; }

  /// The transpose of that matrix, filled up for DenseKernels with rows of zeros.
  const Eigen::MatrixXd &cell_spread(const unsigned int c) const { return cell_transpose[c]; }

  /// Groups of cells of which no two touch the same independent node (for assembly) or the same node (for
  /// scattering): cells of a group can be worked on at once, and the order of additions never depends on the
  /// number of threads.
  const std::vector<std::vector<unsigned int>> &colors() const { return cell_colors; }

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
  void transpose_cells();
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
  /// Calls f(independent node, weight) for the entries of row @p node of T.
  template <class F>
  void for_entries(const unsigned int node, const F &f) const
  {
    const auto *entries = dependent.get_constraint_entries(node);
    if (entries == nullptr)
      f(independent_number[node], 1.);
    else
      for (const auto &[other, weight] : *entries)
        f(independent_number[other], weight);
  }
  NodeWeights combine(const unsigned int *nodes, const double *weights, unsigned int n) const;

  const Lattice<dim> *lattice = nullptr;
  const ShapeFunction *shape = nullptr;
  const CellLevels<dim> *levels = nullptr;
  /// What a node hangs on, for every node that lies on a face of a larger cell and is none of its nodes.
  std::vector<Entries> hanging;
  std::shared_ptr<const CellFunctions<dim>> functions;
  unsigned int n_cell_nodes = 0;

  Box cell_box, node_box;
  std::vector<Index> cell_index, node_lattice_index;
  std::vector<dealii::Point<dim>> node_position;
  std::vector<std::int64_t> lattice_number;
  std::vector<unsigned int> point_cell, cell_nodes, cell_point_start, node_cell_start, node_cell;
  std::vector<double> point_values;
  std::vector<dealii::Tensor<1, dim>> point_slopes;

  std::vector<unsigned int> independent_node;
  std::vector<unsigned int> independent_number; ///< of every node; of those that depend on others: none
  dealii::AffineConstraints<double> dependent;  ///< T without the rows of independent nodes
  WeightsOfPlaces marker_rows;

  std::vector<std::vector<unsigned int>> cell_dependence;
  std::vector<Eigen::MatrixXd> cell_matrix, cell_transpose;
  std::vector<std::vector<unsigned int>> cell_colors;
};
} // namespace softgrain::mpm

#endif
