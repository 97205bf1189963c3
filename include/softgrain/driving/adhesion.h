// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_adhesion_h
#define softgrain_driving_adhesion_h

#include <softgrain/scene/contact_law.h>
#include <softgrain/scene/scene.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace softgrain
{
class StateReader;
class StateWriter;

/**
 * @brief The contact law of a scene with the memories of its contacts; the same in every model.
 *
 * Contacts are known by keys that stay from step to step. Only those that have been noted in a step are
 * remembered: the others are out of reach.
 */
class Adhesion
{
public:
  /// No adhesion.
  Adhesion() = default;

  /**
   * @param law      of the scene; null: Coulomb's
   * @param touching gap up to which surfaces touch: what the model can tell from none [m]
   */
  Adhesion(std::shared_ptr<const ContactLaw> law, double touching);

  bool acts() const { return law != nullptr; }
  bool remembers() const { return acts() && law->remembers(); }

  /// Gap beyond which nothing holds [m].
  double reach() const;

  /// Share of the strength that acts over a step.
  /// @param gap at its start [m]
  double share(std::uint64_t key, double gap) const;

  /// The gap of a contact along a line that counts for its memory: the smallest of its length [m].
  double nearest(double gap, const std::array<double, 2> &lift) const;

  /// What has become in a step of a contact that began it with @p gap [m]; for laws that remember.
  void note(std::uint64_t key, double gap, const ContactEvent &event);

  // The same for contacts whose memory the caller keeps.

  /// Memory of a contact that has none yet. @param gap at the start of the step [m]
  double first_memory(double gap) const;

  /// Mean share where the gap goes linearly from @p gap to @p end along a contact [m].
  double mean_share(double memory, double gap, double end) const;

  double memory_after(double memory, ContactEvent event) const;

  /// Ends the step for which contacts have been noted.
  void finish_step();

  void save(StateWriter &out, const std::string &name) const;
  void load(const StateReader &in, const std::string &name);

private:
  bool resolves_range() const { return law->range() > touching; }
  double gap_between_surfaces(const double gap) const { return gap <= touching ? 0. : gap; }
  double memory_of(std::uint64_t key, double gap) const;

  std::shared_ptr<const ContactLaw> law; ///< null where none adheres
  double touching = 0;                   ///< [m]
  bool started = false;                  ///< a step has been made
  std::unordered_map<std::uint64_t, double> memory, next;
};
} // namespace softgrain

#endif
