// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_contact_path_h
#define softgrain_contact_contact_path_h

#include <softgrain/contact/exchange_system.h>
#include <softgrain/contact/problem.h>

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace softgrain::contact
{
/**
 * @brief The path from impulses that solve another problem to those that solve this one, of contacts with
 * friction in the plane; see follow_path().
 */
class ContactPath
{
public:
  /// @param W_all the Delassus matrix of all contacts
  /// @param selected the contacts that take part
  /// @param impulses to start from
  /// @param margin in the problem that they solve: speed over that of approach at which open contacts part
  /// and sliding ones slide, at least; its logarithm spread evenly over @p decades
  ContactPath(const ExchangeSystem::Matrix &W_all,
              const Problem &problem,
              const std::vector<double> &compliance,
              const std::vector<unsigned int> &selected,
              const std::vector<double> &impulses,
              double margin,
              double decades,
              unsigned int seed);

  /// Follows it to its end. False when that is not reached within @p most exchanges.
  bool follow(unsigned int most);

  /// Where follow() has come to, for @p n_contacts contacts [N s/m].
  std::vector<double> impulses(unsigned int n_contacts) const;

  /// Contacts that have changed their state so far.
  unsigned int n_exchanges() const { return exchanges; }

private:
  using State = ContactState;

  /// What has to stay positive: of an open contact w_n; of one that sticks the distance from both edges of
  /// the cone; of one that slides P_n and the speed of sliding.
  enum class Condition
  {
    parts,
    upper_edge,
    lower_edge,
    pressed,
    slides
  };
  struct Line
  {
    double value, slope;
  };
  struct Event
  {
    unsigned int contact = 0;
    Condition what = Condition::parts;
    double way = std::numeric_limits<double>::infinity();
  };

  Line line(unsigned int contact, Condition what) const;
  void look_at(unsigned int contact, Condition what, Event &nearest) const;
  Event next_event() const;
  bool exchange(const Event &event);

  const std::vector<unsigned int> selected;
  Eigen::VectorXd mu;
  const double speed, softness; ///< units: speed of approach [m/s], compliance of a contact [m/kg]
  const double unit;            ///< of impulses: one over the other [N s/m]
  ExchangeSystem system;
  unsigned int exchanges = 0;
  double t = 0., direction = 1.;
  /// What grows from 0 since the last exchange.
  bool has_grown = false;
  unsigned int grown_contact = 0;
  Condition grown = Condition::parts;
};
} // namespace softgrain::contact

#endif
