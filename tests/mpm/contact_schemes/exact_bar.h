// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_contact_schemes_exact_bar_h
#define softgrain_tests_mpm_contact_schemes_exact_bar_h

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace softgrain::schemes
{
/// Elastic bar above a rigid wall, as it is at the start.
struct Fall
{
  double length, modulus, density;
  double gap;     ///< between its lower end and the wall
  double speed;   ///< towards the wall
  double gravity; ///< towards the wall

  double wave_speed() const { return std::sqrt(modulus / density); }
  /// A wave goes up and comes back.
  double round_trip() const { return 2. * length / wave_speed(); }
};

/**
 * Exact motion of the bar, by characteristics. The displacement is
 *
 *     u(x, t) = F(t - x/c) + F(t + x/c - 2L/c) - g t²/2 + a constant of x,
 *
 * which leaves the upper end free. At the lower end F'(t) = F'(t - 2L/c) while it is free and
 * F'(t) = g t - F'(t - 2L/c) while it stands on the wall; the pressure is then (E/c) (g t - 2 F'(t - 2L/c)).
 * F' is linear in pieces, so that all events are roots of polynomials.
 */
class ExactBar
{
public:
  ExactBar(const Fall &fall, const double end) : fall(fall), delay(fall.round_trip())
  {
    pieces.push_back({-delay, 0., -0.5 * fall.speed, 0., 0.5 * fall.speed * delay});
    double t = 0., gap = fall.gap;
    bool contact = gap <= 0.;
    while (t < end)
      advance(t, gap, contact);
  }

  double displacement(const double x, const double t) const
  {
    const double way = x / fall.wave_speed();
    return F(t - way) + F(t + way - delay) - F(-way) - F(way - delay) - 0.5 * fall.gravity * t * t;
  }

  struct Contact
  {
    double start, end;
  };
  /// Times at which the bar stands on the wall; the last may go on.
  std::vector<Contact> contacts;

private:
  struct Piece
  {
    double start, end, value, slope; ///< of F'
    double integral;                 ///< F at the start
  };

  const Piece &piece_at(const double t) const
  {
    const auto next =
        std::upper_bound(pieces.begin(), pieces.end(), t,
                         [](const double time, const Piece &piece) { return time < piece.start; });
    return next == pieces.begin() ? pieces.front() : *(next - 1);
  }

  double F(const double t) const
  {
    const Piece &p = piece_at(t);
    const double s = t - p.start;
    return p.integral + p.value * s + 0.5 * p.slope * s * s;
  }

  /// Goes on to the next event or to where the old F' has a new piece.
  void advance(double &t, double &gap, bool &contact)
  {
    const double rounding = 1e-12 * delay;
    const Piece old = piece_at(t - delay + rounding);
    const double value = old.value + old.slope * (t - delay - old.start), g = fall.gravity;
    double way = old.end - (t - delay);
    // The free end would go so fast, and the pressure is this with the other sign.
    const double speed = 2. * value - g * t, change = 2. * old.slope - g;
    const double parting = 1e-12 * fall.wave_speed();
    if (contact && (speed > parting || (speed > -parting && change > 0.)))
      contact = end_contact(t);
    else if (!contact && first_root(gap, speed, change) <= rounding)
      contact = begin_contact(t);
    if (contact && change > 0.)
      way = std::min(way, std::max(rounding, -speed / change));
    else if (!contact)
      way = std::min(way, first_root(gap, speed, change));
    const Piece &last = pieces.back();
    const double length = last.end - last.start,
                 F_now = last.integral + last.value * length + 0.5 * last.slope * length * length;
    pieces.push_back(
        {t, t + way, contact ? g * t - value : value, contact ? g - old.slope : old.slope, F_now});
    if (!contact)
      gap = std::max(0., gap + speed * way + 0.5 * change * way * way);
    t += way;
    if (pieces.size() > 100000)
      throw std::runtime_error("the exact solution has too many pieces");
  }

  bool begin_contact(const double t)
  {
    contacts.push_back({t, INFINITY});
    return true;
  }
  bool end_contact(const double t)
  {
    contacts.back().end = t;
    return false;
  }

  /// Smallest time at which gap + speed t + change t²/2 falls to 0.
  static double first_root(const double gap, const double speed, const double change)
  {
    if (gap <= 0.)
      return speed < 0. || (speed == 0. && change < 0.) ? 0. : change < 0. ? -2. * speed / change : INFINITY;
    if (change == 0.)
      return speed < 0. ? -gap / speed : INFINITY;
    const double square = speed * speed - 2. * change * gap;
    if (square < 0. || (change > 0. && speed >= 0.))
      return INFINITY;
    return 2. * gap / (-speed + std::sqrt(square));
  }

  Fall fall;
  double delay;
  std::vector<Piece> pieces;
};
} // namespace softgrain::schemes

#endif
