// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_exchange_system_h
#define softgrain_contact_exchange_system_h

#include <softgrain/contact/active_system.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace softgrain::contact
{
/// State of a contact in the plane. It slides up: w_t >= 0, P_t = -mu P_n; or down: w_t <= 0, P_t = mu P_n.
enum class ContactState : char
{
  open,
  sticks,
  slides_up,
  slides_down
};

/**
 * @brief Impulses of contacts whose states are known, and how they change when one contact changes its state.
 *
 * With w = W P + q₀ + t Δq two rows per contact are linear in P: open P_n = P_t = 0; closed w_n = 0, and
 * w_t = 0 or P_t = ∓ mu P_n. So P and w are linear in t. A change of state replaces one row or two:
 * updates of the factors by outer products (Sherman and Morrison); factors are made anew after some dozens.
 */
class ExchangeSystem
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// @param W symmetric, two rows per contact
  explicit ExchangeSystem(Matrix W);

  Eigen::VectorXd times(const Eigen::VectorXd &P) const { return W * P; }

  /// States at the start, friction coefficients, q₀ and Δq.
  void start(std::vector<ContactState> states,
             const Eigen::VectorXd &friction,
             const Eigen::VectorXd &velocity,
             const Eigen::VectorXd &change);

  /// Factors for the states as they are. False when they do not determine the impulses.
  bool factorise();

  /// Gives @p contact another state. False when then the impulses are not determined.
  bool exchange(unsigned int contact, ContactState to);

  ContactState state(const unsigned int contact) const { return states[contact]; }
  const std::vector<ContactState> &all_states() const { return states; }
  /// P, w and their change with t, by component.
  double impulse(const unsigned int i, const double t) const { return P[0][i] + t * P[1][i]; }
  double impulse_slope(const unsigned int i) const { return P[1][i]; }
  double speed(const unsigned int i, const double t) const { return w[0][i] + t * w[1][i]; }
  double speed_slope(const unsigned int i) const { return w[1][i]; }

private:
  using Vector = Eigen::VectorXd;

  /// A row of the system: unit, w, or the edge of a cone.
  enum class Row : char
  {
    no_impulse,
    no_speed,
    edge
  };
  struct Update
  {
    unsigned int row;
    Row kind;
    double side;  ///< of an edge: P_t = side P_n
    double pivot; ///< new row times inverse column
  };

  Row kind_of(unsigned int row) const;
  double side_of(unsigned int contact) const;
  /// A row times a vector over components; @p at gives the places of these in the vector, null: as they are.
  double
  row_times(unsigned int row, Row kind, double side, const Vector &x, const std::vector<int> *at) const;
  double right_side(unsigned int row, unsigned int part) const;
  void keep_slots();
  const Vector &base_column(unsigned int row);
  Vector column_of_inverse(unsigned int row);
  void add_to_speeds(const Vector &column, const double (&factor)[2]);
  bool replace(unsigned int row);

  const Matrix W;
  std::vector<ContactState> states;
  Vector mu, q[2];        ///< q₀, Δq
  std::vector<int> place; ///< of a component among those closed when factors were made; -1: it was open
  int n_closed = 0;       ///< components of them
  std::vector<Row> base_kind;
  std::unique_ptr<ActiveSystem> base;
  /// Columns of the inverse hold what is closed, or was when factors were made: the slots of components in
  /// them; of all others the last, which holds 0.
  std::vector<int> slot;
  std::vector<unsigned int> component; ///< of a slot
  /// W of all rows on the slots of what was closed when factors were made, row by row.
  std::vector<int> part_start, part_slot;
  std::vector<double> part_value;
  std::vector<Update> updates;
  std::vector<int> base_number; ///< of a row among those below; -1: none
  std::vector<Vector> of_base;  ///< columns of the inverse as it was when factors were made: rows come again
  Eigen::MatrixXd columns;      ///< of the inverse, each before its update
  Vector P[2], w[2];            ///< at t = 0, and their slopes
};
} // namespace softgrain::contact

#endif
