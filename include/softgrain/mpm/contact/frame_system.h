// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_contact_frame_system_h
#define softgrain_mpm_contact_frame_system_h

#include <softgrain/linear/low_rank_solver.h>
#include <softgrain/linear/rank_one_solver.h>
#include <softgrain/mpm/body/body_share.h>
#include <softgrain/mpm/contact/frame_state.h>
#include <softgrain/mpm/contact/free_way.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>

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
 * the matrix is not symmetric any more. It is solved by GMRES, with the symmetric part of closed rays and of
 * those that stick as preconditioner: it differs from that by the rank of what slips.
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
  /// @param way_without y above, of this rank's bodies [m]
  void condense(const FrameScene<dim> &scene,
                const std::vector<FrameState<dim>> &frames,
                const RayForces &force,
                const RayForces &rubbing,
                double within,
                const std::vector<Eigen::VectorXd> &way_without);

  /// Solves for forces, alike on all ranks. @return whether no ray pulls or overlaps, none that sticks
  /// exceeds its friction, and all that slip rub against their slide
  bool solve(double cell_size, unsigned int negative_of_bodies);

  /// Negative pivots of the last solve beyond those that constraints have, less those of bodies' factors: 0
  /// in a minimum.
  int wrong_inertia(unsigned int negative_of_bodies) const
  {
    return static_cast<int>(negative) - static_cast<int>(n_motions) - static_cast<int>(negative_of_bodies) -
           static_cast<int>(n_free);
  }

  /// V z of a body of this rank: force on its nodes [N/m].
  Eigen::VectorXd force_on(unsigned int b) const;

  /// The frames of every body, with the side of the frame that it is.
  std::vector<std::vector<std::pair<unsigned int, unsigned int>>> frames_of;

  std::vector<FreeWay<dim>> ways; ///< of walls under loads; RayStep sets FreeWay::at
  std::vector<double> found_ways; ///< of the last solve [m]

  RayForces found;         ///< P of the last solve [N/m]
  RayForces found_rubbing; ///< friction of the last solve [N/m]
  unsigned int passes = 0; ///< of the active set, so far

private:
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
    unsigned int mate = none;       ///< column of the slide of a ray, of the ray of a slide
    double stiffness = 0;           ///< of a ray or a slide: what makes a gap a force [N/m^2]
    double bound = 0;               ///< of a slide: largest friction over force
    double threshold = 0;           ///< largest friction for the force of the last iterate [N/m]
    double pull = 0; ///< of a ray, FrameState::RayHere::pull: what is left where it opens [N/m]
  };
  void add_columns(const FrameScene<dim> &scene,
                   const std::vector<FrameState<dim>> &frames,
                   const RayForces &force,
                   const RayForces &rubbing,
                   unsigned int f,
                   double within);
  void add_motion(const FrameState<dim> &frame,
                  const std::vector<double> &force,
                  unsigned int first,
                  unsigned int f);
  /// Fills column @p i of those of a body.
  void gather(const FrameScene<dim> &scene,
              const std::vector<FrameState<dim>> &frames,
              const Column &column,
              unsigned int b,
              const RayForces &force,
              unsigned int i,
              LinearSolver::Rows &rows) const;
  /// What z holds for the columns of a body.
  Eigen::VectorXd z_of(unsigned int b) const;
  void find_order();
  bool solve_active(const Eigen::VectorXd &right);
  /// A power of two near the force that counts as much as a way of 1 m.
  double unit_of_forces() const;
  /// The largest gap or slide of @p here.
  double farthest_way(const Eigen::VectorXd &here) const;
  /// N z - right, for all columns.
  Eigen::VectorXd beyond(const Eigen::VectorXd &right) const;
  /// Stops and frees walls under loads, once the rays are where they must be. @return whether none has
  /// changed
  bool walls_stay(const Eigen::VectorXd &here);
  /// Solves and changes sides until none is wrong. @return whether that came to an end
  bool settle(const Eigen::VectorXd &right, double cell_size, unsigned int negative_of_bodies);
  /// That a ray bears which sticks.
  double most_friction(const unsigned int i) const
  {
    return by_threshold ? columns[i].threshold
                        : columns[i].bound * std::max(0., z[columns[i].mate] + columns[columns[i].mate].pull);
  }
  /// Moves rays that are where they must not be to the other side, those that are wrong by at least @p share
  /// of the worst.
  /// @return whether there were none
  bool change_sides(const Eigen::VectorXd &here, double cell_size, double share);
  /// The side of their conditions on which all columns are.
  std::vector<signed char> sides() const;
  /// 0 where the ray of a column that is a slide sticks, otherwise the sign of its friction.
  int slips(const unsigned int i) const
  {
    return columns[i].kind == Column::slide ? slipping[columns[i].frame][columns[i].ray_number] : 0;
  }
  /// Whether a column is an unknown of its own.
  bool counts(const unsigned int i) const
  {
    return active[i] && slips(i) == 0 && (columns[i].kind != Column::wall || ways[i].stopped == 0);
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
  std::vector<Column> columns; ///< walls, then for every frame its rays, slides, motion and force
  std::vector<std::vector<unsigned int>> of_body; ///< columns that a body has to do with
  std::vector<LinearSolver::Rows> V;              ///< of this rank's bodies
  std::vector<Eigen::MatrixXd> W;
  std::vector<Eigen::VectorXd> moved;      ///< V^T y
  std::vector<Eigen::Triplet<double>> own; ///< Q
  std::vector<double> gap;
  std::vector<char> active;                       ///< a slide where its ray is
  std::vector<std::vector<signed char>> slipping; ///< of all rays: sign of the friction, or 0
  Eigen::VectorXd z, wrong;
  bool any_slides = false;
  bool by_threshold = false; ///< friction is bounded by what forces were, not by what they are found to be
  unsigned int n_motions = 0, n_free = 0, negative = 0;
};
} // namespace softgrain::mpm

#endif
