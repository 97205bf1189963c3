// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/contact/gauss_seidel.h>
#include <softgrain/mpm/stepping/refused_step.h>
#include <softgrain/mpm/stepping/step.h>

#include <iomanip>
#include <sstream>

namespace softgrain::mpm
{
std::string short_number(const double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << value;
  return text.str();
}

std::string not_solved(const contact::SolverReport &report)
{
  return "the contact solver left a residual of " + short_number(report.residual) + " after " +
         std::to_string(report.sweeps) + " sweeps ('Contact/Maximum sweeps')";
}

template <int dim>
std::string why_not(const Body<dim> &body, const StressOutcome &outcome)
{
  std::ostringstream text;
  text << "a material point of body '" << body.name << "' "
       << (!outcome.refusal.empty() ? outcome.refusal
           : outcome.leaps          ? "deformed by more than 'Newton/Largest strain' allows in one step"
                                    : "turned inside out")
       << " near (" << outcome.place
       << ") m of its grid; a smaller 'Time/Time step', another 'Mesh/Cell size' or a larger 'Material "
          "points/Fill limit' may help";
  return text.str();
}

template std::string why_not(const Body<2> &, const StressOutcome &);
template std::string why_not(const Body<3> &, const StressOutcome &);

void SharedOutcomes::add_to(BodyShare::Message &message)
{
  for (const StressOutcome &outcome : stress)
  {
    points.push_back(outcome.good() ? -1. : outcome.bad_point);
    leaps.push_back(outcome.leaps);
    shares.push_back(outcome.share);
  }
  for (std::vector<double> *const numbers : {&points, &leaps, &shares})
    message.add(*numbers);
}

void SharedOutcomes::take()
{
  if (share.alone())
    return;
  bool told = false;
  for (unsigned int b = 0; b < stress.size(); ++b)
  {
    stress[b].bad_point = points[b] < 0. ? StressOutcome::none : static_cast<std::size_t>(points[b]);
    stress[b].leaps = leaps[b] != 0.;
    stress[b].share = shares[b];
    if (!stress[b].good() && !told)
      for (std::string *const text : {&stress[b].refusal, &stress[b].place})
        *text = share.exchange.share(*text, share.owner(b));
    told = told || !stress[b].good();
  }
}

template <int dim>
void heed_laws(const std::vector<Body<dim>> &bodies,
               const std::vector<StressOutcome> &stress,
               StepOutcome &outcome)
{
  unsigned int first = 0;
  for (unsigned int b = 0; b < stress.size(); ++b)
    if (stress[b].share < stress[first].share)
      first = b;
  if (stress.empty() || stress[first].share >= 1.)
    return;
  outcome.accepted = false;
  outcome.law_asks = true;
  // A little shorter than asked for, so that the next attempt is not refused by rounding.
  outcome.share = 0.95 * stress[first].share;
  std::ostringstream text;
  text << "the law of body '" << bodies[first].name << "', '" << bodies[first].material.law->title()
       << "', allows no more than " << stress[first].share << " of this step";
  outcome.reason = text.str();
}

template void heed_laws(const std::vector<Body<2>> &, const std::vector<StressOutcome> &, StepOutcome &);
template void heed_laws(const std::vector<Body<3>> &, const std::vector<StressOutcome> &, StepOutcome &);
} // namespace softgrain::mpm
