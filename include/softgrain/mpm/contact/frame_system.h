// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_system_h
#define softgrain_mpm_contact_frame_system_h

#include <softgrain/linear/block_factor.h>
#include <softgrain/linear/low_rank_solver.h>
#include <softgrain/linear/rank_one_solver.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/free_way.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>
#include <vector>

namespace softgrain::mpm
{
/// A solver that holds what a body may do as a whole: its turn in the plane, its three rotations in space.
template <int dim>
using BodySolver = std::conditional_t<dim == 2, RankOneSolver, LowRankSolver>;

/// Forces of the rays of all frames [N/m].
using RayForces = std::vector<std::vector<double>>;
/// Friction of the rays of all frames, along RayRub::e [N/m^(3-dim)].
template <int dim>
using RayFriction = std::vector<std::vector<dealii::Tensor<1, dim - 1>>>;

/**
 * @brief Newton's equations of a step with frames, condensed to what frames do.
 *
 * With A the matrix of a body (its material, what resists it, and second derivatives of the gaps of its
 * rays), f what is missing for balance of a body without contact, G = dg/du, r = dc/du and
 * D = sum_k P_k d²g_k/du dc, forces P, motions δc and forces τ of frames obey
 *
 *     [ W  g_c  . ] [P ]        [ g + G y  ]
 *     [ .  q    1 ] [δc]  =  -  [ Dᵀ y     ]    + Vᵀ A⁻¹ V,    V = [Gᵀ, D, -r],    y = A⁻¹ f,
 *     [ .  1    0 ] [τ ]        [ -rᵀ y    ]
 *
 * with q = sum_k P_k d²g_k/dc²: symmetric, and sparse since frames meet only in bodies. Rays that pull are
 * taken out and rays that would overlap are taken in until none is left. Where adhesion holds surfaces
 * together with a force c, a ray may pull with c, and does so where it opens: P + c takes the place of P in
 * the conditions.
 *
 * With friction a ray that sticks has a row for its slide s, with H = ds/du among the columns of V. The
 * friction of a ray that slips is +-mu' P: its column is that of P plus +-mu' times that of its slide, and
 * the matrix is not symmetric any more. Then the factors of the symmetric part, of closed rays and of those
 * that stick, only tell the inertia.
 *
 * In space a slide has two components. Friction that slips is mu' P along a unit vector d, and both
 * components stand along d and across it. Friction T is opposite to the slide s, so across d
 * s_2 = (s_1 / T_1) T_2. With s_1 and T_1 of the last iterate that is the row of a ray that sticks and gives
 * way by -s_1 / T_1 > 0. The next d is the direction of T - k s, with the stiffness k of the bodies. A ray
 * that begins to slip does so along its T, and gives way across it by (|T| / (mu' P) - 1) / k. Sets
 * of rays follow one another as in Newton's method for what is off, whose steps may be shortened.
 *
 * The dent that the grid misses falls again under larger forces. Where too many rays are pressed a contact is
 * stiffer than it really is, and the slope of that dent then makes its whole compliance negative: the active
 * set does not settle. In such an iteration falling dents keep their depth.
 *
 * A wall under a load is one more unknown, its way a: with g_a, s_a and r_a what it does to gaps, slides and
 * mean motions, its row is sum_k P_k g_a + T_k s_a - tau r_a - stiffness a = -load.
 */
template <int dim>
class FrameSystem
{
public:
  /// @param scale of A: A = scale * (what solvers have factorised)^-1 as displacement per force
  FrameSystem(const BodyShare &share,
              const std::vector<Body<dim>> &bodies,
              std::vector<std::unique_ptr<BodySolver<dim>>> &solvers,
              double scale);

  /// Learns which bodies the frames of a step have to do with, once.
  void take(const std::vector<FrameState<dim>> &frames);

  /// V and W of the present state. Rays are candidates if they carry force or their gap is below @p within.
  /// @param force   of the rays [N/m]
  /// @param rubbing friction of the rays [N/m]
  /// @param way_without y above, of owned bodies [m]
  void condense(const FrameScene<dim> &scene,
                const std::vector<FrameState<dim>> &frames,
                const RayForces &force,
                const RayFriction<dim> &rubbing,
                double within,
                const std::vector<Eigen::VectorXd> &way_without);

  /// Solves for forces, alike for all owners. @return whether no ray pulls or overlaps, none that sticks
  /// exceeds its friction, and all that slip rub against their slide
  /// @param begins whether began_in_minimum is to be found
  bool solve(double cell_size, unsigned int negative_of_bodies, bool begins = false);

  /// Negative pivots of the last solve beyond those that constraints have, less those of bodies' factors: 0
  /// in a minimum.
  int wrong_inertia(unsigned int negative_of_bodies) const
  {
    return static_cast<int>(negative) - static_cast<int>(n_motions) - static_cast<int>(negative_of_bodies) -
           static_cast<int>(n_free);
  }

  /// V z of an owned body: force on its nodes [N/m].
  Eigen::VectorXd force_on(unsigned int b) const;

  /// The frames of every body, with the side of the frame that it is.
  std::vector<std::vector<std::pair<unsigned int, unsigned int>>> frames_of;

  std::vector<FreeWay<dim>> ways; ///< of walls under loads; RayStep sets FreeWay::at
  std::vector<double> found_ways; ///< of the last solve [m]

  RayForces found;                ///< P of the last solve [N/m]
  RayFriction<dim> found_rubbing; ///< friction of the last solve [N/m]
  /// Frames and rays that the last solve found right neither open nor closed, or neither sticking nor
  /// slipping. Their friction is that of an earlier pass.
  std::vector<std::pair<unsigned int, unsigned int>> kept;
  double kept_off = 0.;    ///< by what share of all forces they were off in that pass
  unsigned int passes = 0; ///< of the active set, so far
  /// Whether forces at hand hold the bodies in a minimum; found in space with friction only.
  bool began_in_minimum = false;

private:
  static constexpr unsigned int gmres_restart = 60, gmres_iterations = 200;
  static constexpr double gmres_tolerance = 1e-12;
  static constexpr unsigned int most_passes = 40;
  static constexpr double farthest = 5.; ///< gap or slide of a step that may be [cells]
  /// Passes after which the inertia is found, where a solve does not tell it anyway.
  static constexpr unsigned int passes_to_inertia = 4;
  static_assert(most_passes % passes_to_inertia == 0, "the last pass tells the inertia of its set");

  using Across = dealii::Tensor<1, dim - 1>;
  struct Column
  {
    enum Kind
    {
      ray,
      slide,
      wall,
      motion,
      tangential
    };
    static constexpr unsigned int none = static_cast<unsigned int>(-1);
    Kind kind;
    unsigned int frame, ray_number; ///< the latter of a ray; of a wall its own; of a motion its component
    unsigned int mate = none;       ///< column of the first slide of a ray, of the ray of a slide
    double stiffness = 0;           ///< of a ray or a slide: what makes a gap a force [N/m^2]
    double bound = 0;               ///< of a slide: largest friction over force
    double threshold = 0;           ///< largest friction for the force of the last iterate [N/m]
    double pull = 0;                ///< of a ray, RayHold::pull: what is left where it opens [N/m]
    unsigned int component = 0;     ///< of a slide
    Across axis{};                  ///< direction of a slide, along RayRub::e
    Across axis_of_v{};             ///< likewise, when the column of V was made
    double give = 0;                ///< of a slide across friction that slips: slide for a unit force [m^2/N]
    bool keeps = false;             ///< of a slide: its friction is known in this solve
    double kept = 0;                ///< of such a slide: that friction [N/m]
  };
  void add_slides(const FrameState<dim> &frame, const Across &rubbing, double force, unsigned int ray_column);
  /// Turns both slides of a ray, so that the first goes along (@p c, @p s) in their present directions.
  void turn_slides(unsigned int first, double c, double s);
  /// Puts friction into found_rubbing, at its bound where it slips.
  void note_friction(unsigned int first);
  /// Friction in z, along RayRub::e.
  Across found_friction(unsigned int first) const;
  double give_of(const unsigned int i) const
  {
    return columns[i].component == 1 && slips(i - 1) != 0 ? columns[i].give : 0.;
  }
  void add_dent(const FrameState<dim> &frame, unsigned int first, unsigned int end);
  void add_columns(const FrameScene<dim> &scene,
                   const std::vector<FrameState<dim>> &frames,
                   const RayForces &force,
                   const RayFriction<dim> &rubbing,
                   unsigned int f,
                   double within);
  void add_motion(const FrameState<dim> &frame,
                  const std::vector<double> &force,
                  unsigned int first,
                  unsigned int f);
  void begin_columns(const RayForces &force, const RayFriction<dim> &rubbing);
  void add_ways(const FrameScene<dim> &scene,
                const FrameState<dim> &frame,
                const std::vector<double> &force,
                unsigned int first,
                unsigned int motion);
  template <class Add>
  void for_nodes(const FrameScene<dim> &scene,
                 const std::vector<FrameState<dim>> &frames,
                 const Column &column,
                 unsigned int b,
                 const RayForces &force,
                 const Add &add) const;
  /// Fills column @p i of those of a body.
  void gather(const FrameScene<dim> &scene,
              const std::vector<FrameState<dim>> &frames,
              const Column &column,
              unsigned int b,
              const RayForces &force,
              unsigned int i,
              LinearSolver::Rows &rows) const;
  /// Puts what @p all holds for the columns of a body into @p part.
  void pick(unsigned int b, const Eigen::VectorXd &all, Eigen::VectorXd &part) const;
  void find_order();
  /// Solves for the present sides of all conditions. @return whether there is a solution
  bool solve_active();
  /// Solves with the factors at hand. @param exactly to rounding, not only as well as the factors do
  bool solve_with_factors(bool exactly);
  /// Numbers the unknowns in the order of the factors.
  void number_unknowns();
  /// Puts into z what is known, and gives what it leaves for the unknowns.
  Eigen::VectorXd right_of_unknowns();
  /// Factors that make all equations those of ways, and all unknowns too, for GMRES: of rows, of columns.
  std::array<Eigen::VectorXd, 2> units_of_unknowns() const;
  /// Puts unknowns into z, and friction that goes with them. @return whether all are numbers
  bool take_unknowns(const Eigen::VectorXd &x);
  bool factorize_active();
  /// Finds the inertia of the last solve where that has not done so. @return whether there are factors
  bool find_inertia();
  /// Fills and factorises the matrix without friction that slips, that with it, or both.
  bool factorize_blocks(bool plain, bool with_slip);
  const std::vector<int> &first_of_blocks() const
  {
    return fills_slip ? slip_factor.first() : factor.first();
  }
  void add_entry(unsigned int i, unsigned int j, double value);
  void add_slip(unsigned int i, unsigned int j, double value);
  void add_body(unsigned int b);
  /// Where a column that is no wall stands in a list of them, at whose end walls are.
  int place_in(const std::vector<unsigned int> &list, const unsigned int column) const
  {
    auto end = list.end();
    while (columns[*(end - 1)].kind == Column::wall)
      --end;
    return std::lower_bound(list.begin(), end, column) - list.begin();
  }
  /// Whether a column is a slide whose friction goes with the force of its ray.
  bool slips_with_force(const unsigned int i) const { return active[i] && slips(i) != 0 && !by_threshold; }
  /// A power of two near the force that counts as much as a way of 1 m.
  double unit_of_forces() const;
  /// The largest gap or slide of @p here.
  double farthest_way(const Eigen::VectorXd &here) const;
  /// N z - right, for all columns.
  Eigen::VectorXd beyond() const;
  /// Adds N times given forces and motions of all columns.
  void add_effect(const Eigen::VectorXd &all, Eigen::VectorXd &here) const;
  /// Stops and frees walls under loads, once the rays are where they must be. @return whether none has
  /// changed
  bool walls_stay(const Eigen::VectorXd &here);
  /// Solves and changes sides until none is wrong. @return whether that came to an end
  bool settle(double cell_size, unsigned int negative_of_bodies);

  // In space with friction, see frame_damped.cc:
  /// Forces of all columns, and what is left of their gaps and slides without what friction that slips gives
  /// way by.
  struct Iterate
  {
    Eigen::VectorXd z, here;
  };
  /// What a ray would bear if its gap and its slide were taken back by its stiffness.
  struct Trial
  {
    double force, most;   ///< the latter is the largest friction for the former
    double along, across; ///< of its friction
    double length;        ///< of its friction
  };
  Trial trial_of(unsigned int ray, const Iterate &at) const;
  /// The square of what forces are off those that gaps and slides allow.
  double square_off(const Iterate &at) const;
  /// The forces at hand when the system was condensed, along present axes.
  Iterate iterate_at_hand();
  /// The iterate of z and of beyond().
  Iterate iterate_of(Eigen::VectorXd here) const;
  /// Puts all rays on the sides that belong to @p from.
  void take_sides();
  /// Goes from @p from towards @p to. @return the square that is off there
  double go_damped(const Iterate &to, double before, bool all_the_way);
  bool settle_damped(double cell_size, unsigned int negative_of_bodies);
  /// Takes the forces at hand as those that are least off.
  void begin_damped();
  /// Lets all rays that are wrong keep the friction of @p nearest, where all are @p off by that share.
  void keep_friction(double off);
  /// Solves for the present sides, exactly only where no ray is wrong. @return whether there is a solution
  bool solve_pass(double cell_size, Eigen::VectorXd &here, bool &any_wrong);
  /// How far the equations of rays are off for the present sides, as a force.
  double unsolved(const Eigen::VectorXd &here) const;
  double forces_squared(const Eigen::VectorXd &of_columns) const;
  /// Settles with the exact law of dents, and where that does not end without the dents that soften.
  bool settle_with_dents(double cell_size, unsigned int negative_of_bodies);
  /// That a ray bears which sticks.
  double most_friction(const unsigned int i) const
  {
    return by_threshold ? columns[i].threshold
                        : columns[i].bound * std::max(0., z[columns[i].mate] + columns[columns[i].mate].pull);
  }
  /// Finds by how much rays are where they must not be. @return whether any is
  bool find_wrong(const Eigen::VectorXd &here, double cell_size);
  double off_direction(unsigned int i) const;
  /// Moves rays that are where they must not be to the other side, those that are wrong by at least @p share
  /// of the worst.
  void change_sides(double share);
  /// The side of their conditions on which all columns are.
  std::vector<signed char> sides() const;
  /// 0 where the ray of a column that is a slide sticks, otherwise the sign of its friction. In space
  /// friction that slips goes along the first slide.
  int slips(const unsigned int i) const
  {
    return columns[i].kind == Column::slide && columns[i].component == 0
               ? slipping[columns[i].frame][columns[i].ray_number]
               : 0;
  }
  /// Whether a column is an unknown of its own.
  bool counts(const unsigned int i) const
  {
    return active[i] && slips(i) == 0 && !columns[i].keeps &&
           (columns[i].kind != Column::wall || ways[i].stopped == 0);
  }
  /// Puts into z what is known before the solve. @return whether anything is
  bool set_known();

  const BodyShare &share;
  const std::vector<Body<dim>> &bodies;
  std::vector<std::unique_ptr<BodySolver<dim>>> &solvers;
  const double scale;

  /// Order of the columns in the factors: frame by frame, rays and slides first, then the force and last the
  /// motion of the frame, whose own entry may be 0; walls at the end.
  std::vector<unsigned int> order;
  std::vector<int> number; ///< of a column among the unknowns, -1 where it is none
  int n_unknowns = 0;

  // Factors have a block for every frame.
  std::vector<int> block_of; ///< of every column
  int n_blocks = 0;
  std::vector<std::pair<int, int>> neighbours; ///< blocks that meet in a body
  BlockFactor factor, slip_factor;             ///< without friction that slips, and with it if there is any
  bool any_slips = false;
  /// The factors that tell the inertia also solve where no friction slips. Elsewhere they serve nothing else
  /// and are made where the inertia is asked for.
  bool wants_inertia = true, knows_inertia = false;
  bool fills_plain = true, fills_slip = false; ///< which of the two matrices are being filled

  std::vector<Column> columns; ///< walls, then for every frame its rays, slides, motion and force
  std::vector<std::vector<unsigned int>> of_body; ///< columns that a body has to do with
  std::vector<LinearSolver::Rows> V;              ///< of owned bodies
  std::vector<Eigen::MatrixXd> W;
  std::vector<Eigen::VectorXd> moved;      ///< V^T y
  std::vector<Eigen::Triplet<double>> own; ///< Q
  /// Some dents become smaller under a larger force. This is what they take from Q, and from the gaps of
  /// rays.
  std::vector<Eigen::Triplet<double>> softening;
  std::vector<std::pair<unsigned int, double>> softening_gap; ///< column, way [m]
  std::vector<double> gap;
  std::vector<char> active;                       ///< a slide where its ray is
  std::vector<std::vector<signed char>> slipping; ///< of all rays: sign of the friction, or 0
  Eigen::VectorXd z, wrong, right;
  Eigen::VectorXd at_hand;                            ///< forces when the system was condensed
  Iterate from;                                       ///< where a damped solve is
  Eigen::VectorXd nearest;                            ///< and the forces of it that were least off so far
  std::vector<std::array<unsigned int, 2>> bodies_of; ///< of every frame, none where it is driven or a wall
  double worst = 0., largest = 0.;                    ///< of wrong, and of the forces of rays [N/m^(3-dim)]
  bool any_slides = false;
  bool by_threshold = false;   ///< friction is bounded by what forces were, not by what they are found to be
  bool looks_at_start = false; ///< whether the first pass finds began_in_minimum
  unsigned int n_motions = 0, n_free = 0, negative = 0;
};

} // namespace softgrain::mpm

#endif
