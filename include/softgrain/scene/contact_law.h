// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_scene_contact_law_h
#define softgrain_scene_contact_law_h

#include <softgrain/base/registry.h>

#include <memory>
#include <string>

namespace dealii
{
class ParameterHandler;
}

namespace softgrain
{
/// A contact at the end of a step, for laws that remember what has happened to it.
struct ContactEvent
{
  double gap = 0;      ///< [m]; of surfaces that touch not above 0
  bool closed = false; ///< it stopped what came nearer
  bool slides = false; ///< it is at the limit of friction
  double dt = 0;       ///< of the step [s]
};

/**
 * @brief What a contact does beside Signorini's condition: `Contact/Law` names a member of this family.
 *
 * Every member has Coulomb's cone, which it may shift along the normal: with a force c that holds the
 * surfaces together, P + c dt takes the place of the impulse P in Signorini's and Coulomb's conditions. That
 * is, P + c dt >= 0, it is 0 where the gap opens, and |P_t| <= mu (P + c dt). How large c may be is the
 * strength of the pair of materials; a law says what share of it acts. The share is that of the start of a
 * step, so that contacts are solved as exactly as with Coulomb's law alone.
 */
class ContactLaw
{
public:
  virtual ~ContactLaw() = default;

  /// Declares its parameters where the handler stands, in section `Contact`; members may share some.
  virtual void declare_parameters(dealii::ParameterHandler &) const {}
  /// @throw InputError
  virtual void parse_parameters(const dealii::ParameterHandler &) {}

  /// Whether it holds surfaces together; if not, nothing below is asked.
  virtual bool adheres() const { return false; }

  /// Largest gap at which it acts [m].
  virtual double range() const { return 0.; }

  /// Share of the strength, 0 to 1.
  /// @param gap    at the start of the step [m]; of surfaces that touch not above 0
  /// @param memory of the contact
  virtual double share(const double gap, const double memory) const
  {
    (void) gap, (void) memory;
    return 0.;
  }

  /// Mean of share() where the gap goes linearly from @p start to @p end along a contact [m]; below 0
  /// surfaces touch. A law that jumps gives it exactly, so that its force changes smoothly as the edge of a
  /// contact moves; else it is the mean of 16 places.
  virtual double mean_share(double start, double end, double memory) const;

  /// Whether contacts have a memory: one number each, which is 0 where surfaces have not been in reach.
  virtual bool remembers() const { return false; }

  /// Memory of contacts that touch when a run starts.
  virtual double memory_at_start() const { return 0.; }

  /// Memory after a step.
  virtual double memory_after(const double memory, const ContactEvent &event) const
  {
    (void) event;
    return memory;
  }
};

/// Part of a contact that is within @p range where the gap goes linearly from @p start to @p end.
double part_within(double range, double start, double end);

template <>
Registry<ContactLaw> &Registry<ContactLaw>::instance();

/// Declares 'Law' and what belongs to every law, where the handler stands.
void declare_contact_laws(dealii::ParameterHandler &prm);

/// The law that is chosen there.
/// @throw InputError when something is set that belongs to another law
std::shared_ptr<const ContactLaw> parse_contact_law(const dealii::ParameterHandler &prm);
} // namespace softgrain

#endif
