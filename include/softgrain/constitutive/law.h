// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_constitutive_law_h
#define softgrain_constitutive_law_h

#include <softgrain/constitutive/point_data.h>

#include <cstddef>
#include <string>
#include <vector>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain::constitutive
{
/// Which measure of deformation a law reads and which stress it returns.
enum class Kinematics
{
  /// Reads the deformation gradient, returns the Kirchhoff stress tau. The caller keeps V = det(F) V0.
  finite_strain,
  /// Reads the increment of displacement gradient, returns the Cauchy stress sigma. The caller keeps the
  /// volume.
  small_strain
};

/**
 * @brief What a material answers to a deformation: stress, tangent, energy and its own history.
 *
 * A law knows a deformation, its history and the step in time, and nothing else: no mesh, no particle. It is
 * asked for a whole batch of points at once, so that the virtual call costs nothing beside the work. In 2D
 * the state is plane strain. All units are SI, tension is positive.
 */
template <int dim>
class Law
{
public:
  virtual ~Law() = default;

  /// Name of the subsection that holds the parameters of this law, for example "Neo-Hookean".
  virtual std::string title() const = 0;

  /// Declares the parameters, inside the subsection that the caller has entered. Default: none.
  virtual void declare_parameters(dealii::ParameterHandler &prm) const;

  /**
   * @brief Reads the parameters, inside the subsection that the caller has entered. Default: none.
   *
   * @throw InputError with the value found and the values allowed.
   */
  virtual void parse_parameters(dealii::ParameterHandler &prm);

  /// Default: finite_strain.
  virtual Kinematics kinematics() const;

  /// Doubles of history per point. Default: 0.
  virtual unsigned int n_history() const;

  /// Writes the n_history() values of a point in the stress-free state. Default: zeros.
  virtual void initial_history(double *history) const;

  /// One name per history value, under which pictures and snapshots show it ("strain_xx"). Default: none.
  virtual std::vector<std::string> history_names() const;

  /**
   * @brief Evaluates all points of a batch, writing only the outputs whose pointer is not null.
   *
   * Safe to call from several threads on different batches. Throws nothing and writes no NaN: a point whose
   * deformation is inside out or not finite (det F > 0 does not hold; for small-strain laws det(I +
   * increment) > 0 does not hold) ends the call, and outputs from that point on are left as they were.
   *
   * @return inputs.n_points when all points are good, otherwise the index of the first bad one.
   */
  virtual std::size_t update(const Inputs<dim> &inputs, const Outputs<dim> &outputs) const = 0;

  /// Whether the tangent has the symmetry c_ijkl = c_klij, which the solvers of implicit schemes need; a law
  /// without is refused there. Default: true.
  virtual bool symmetric_tangent() const;

  /// Whether update() may ask for a shorter step by Outputs::step_share. Default: false.
  virtual bool limits_step() const;

  /// Whether the law brings in energy of its own, as growth does, and tells it by Outputs::supply. Default:
  /// false.
  virtual bool is_active() const;

  /// Modulus of pressure waves at rest, lambda + 2 mu [Pa]: their speed is sqrt(wave_modulus / density).
  virtual double wave_modulus() const = 0;

  /// Poisson's ratio at rest [-]. Default: 0.
  virtual double poisson_ratio() const;

  /// Young's modulus at rest [Pa]. Default: what wave_modulus() and poisson_ratio() imply.
  virtual double young_modulus() const;
};
} // namespace softgrain::constitutive

#endif
