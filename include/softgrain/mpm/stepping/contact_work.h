// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_stepping_contact_work_h
#define softgrain_mpm_stepping_contact_work_h

#include <softgrain/mpm/stepping/step.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// What contact rows do in a step: which impulses act, and how fast the two sides of a row part meanwhile.
/// The balances of an accepted step are made of it, and so is the question whether a step may be accepted.
class ContactWork
{
public:
  /// All but @p rate are kept by reference. All owners make it together.
  /// @param dt     length of the step [s]
  /// @param rate   mean velocity of the nodes, with which impulses do their work [m/s]
  /// @param motion of the walls
  /// @param balanced see FoundStep
  ContactWork(const State &state,
              const Workspace &work,
              double dt,
              const std::vector<Eigen::VectorXd> &rate,
              const std::vector<WallMotion<2>> &motion,
              bool balanced);

  /// Whether a component of a row does anything.
  bool acts(unsigned int row, unsigned int component) const;
  /// Impulse that acts over the step [N s/m].
  double acting(unsigned int row, unsigned int component) const;
  /// How fast the body parts from what it meets, the motion of walls, obstacles and the cell counted [m/s].
  double parting(unsigned int row, unsigned int component) const;
  /// Work of adhesion, which pulls what comes nearer; part of what the row does [J/m].
  double adhesion_work(unsigned int row) const;

  /// Energy that contact gives the bodies, beyond what walls, obstacles and adhesion do on them.
  struct Gift
  {
    double energy = 0;    ///< of all rows; negative where contact takes energy [J/m]
    unsigned int row = 0; ///< the one that gives most
  };
  Gift gift() const;

private:
  const State &state;
  const Workspace &work;
  const double dt;
  const std::vector<WallMotion<2>> &motion;
  const std::optional<CellMotion<2>> cell;
  const bool balanced;
  const unsigned int components;
  std::vector<double> relative; ///< of bodies, and of what is driven [m/s]
};

/// Energy that bodies have, where contact would give them more than a thousandth of it; else nothing.
/// @param given by contact [J/m^(3-dim)]
/// @param stored tells the elastic energy: it takes a look at every point, and is seldom asked
template <int dim>
std::optional<double> energy_where_contact_gives(const std::vector<Body<dim>> &bodies,
                                                 double given,
                                                 const std::function<double()> &stored);

/**
 * @brief Why a step with inertia may not be accepted: contact gives the bodies more than a thousandth of the
 * energy that they have. Contact takes energy or keeps it. Where it gives some, what lies in each other has
 * been found too late, or rows are not those of the bodies. @return what to say of it; empty when contact
 * gives nothing
 *
 * @param increment displacements over the step, see StepEquations [m]
 */
std::string why_contact_gives(const Problem &problem,
                              const State &state,
                              const Workspace &work,
                              const ContactWork &contact,
                              const std::vector<Eigen::VectorXd> &increment);
/// Why the present rows give energy, whose bodies have moved by @p increment in @p dt [m], [s].
std::string why_contact_gives(const Problem &problem,
                              const State &state,
                              const Workspace &work,
                              double dt,
                              const std::vector<WallMotion<2>> &motion,
                              const std::vector<Eigen::VectorXd> &increment);
} // namespace softgrain::mpm

#endif
