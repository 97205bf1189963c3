// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_contact_schemes_tables_h
#define softgrain_tests_mpm_contact_schemes_tables_h

// The tables of doc/results/contact-schemes.md, as Markdown.
#include "friction.h"
#include "impacts.h"
#include "program_bar.h"

#include <iomanip>
#include <iostream>
#include <sstream>

namespace softgrain::schemes
{
template <typename F>
Summary over_phases(const F &impact, const unsigned int n)
{
  Summary summary;
  for (unsigned int i = 0; i < n; ++i)
    summary.add(impact((i + 0.5) / n));
  return summary;
}

/// In per cent; what is rounding is 0.
inline std::string percent(const double value)
{
  std::ostringstream text;
  text << std::setprecision(std::abs(value) >= 1. ? 3 : 2) << (std::abs(value) < 1e-6 ? 0. : 100. * value);
  return text.str();
}

inline std::string number(const double value)
{
  std::ostringstream text;
  text << std::setprecision(3) << (std::abs(value) < 1e-9 ? 0. : value);
  return text.str();
}

inline void row(const std::vector<std::string> &cells)
{
  std::cout << '|';
  for (const std::string &cell : cells)
    std::cout << ' ' << cell << " |";
  std::cout << '\n';
}

inline void head(const std::vector<std::string> &cells)
{
  row(cells);
  std::cout << '|';
  for (std::size_t i = 0; i < cells.size(); ++i)
    std::cout << "---|";
  std::cout << '\n';
}

inline const std::vector<std::string> figures = {"energy gained, at most [%]", "at the end, mean (worst) [%]",
                                                 "restitution, mean (least)",  "noise of the pressure [%]",
                                                 "contact ends late by [%]",   "penetration [%]"};

inline std::vector<std::string> cells_of(const Summary &s)
{
  return {percent(s.gained),
          percent(s.kept) + " (" + percent(s.least) + ")",
          number(s.restitution) + " (" + number(s.least_restitution) + ")",
          percent(s.noise),
          percent(s.contact_end),
          percent(s.penetration)};
}

inline std::vector<std::string> joined(std::vector<std::string> a, const std::vector<std::string> &b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

struct Variant
{
  std::string scheme;
  Mass mass;
  std::string words() const
  {
    return scheme + (mass == Mass::lumped       ? ""
                     : mass == Mass::consistent ? ", consistent"
                                                : ", no mass at contact");
  }
};

inline std::vector<Variant> variants()
{
  std::vector<Variant> all;
  for (const std::string &name : scheme_names())
    all.push_back({name, Mass::lumped});
  all.push_back({"newmark", Mass::redistributed});
  return all;
}

template <typename F>
Summary impact_of(const F &impact, const Variant &variant, const double cfl)
{
  return over_phases([&](const double phase) { return impact(variant.scheme, variant.mass, cfl, phase); },
                     n_phases);
}

inline void wall_table()
{
  head(joined(joined({"scheme", "CFL"}, figures), {"error of u [%]"}));
  std::vector<Variant> all = variants();
  for (const std::string &name : scheme_names())
    all.push_back({name, Mass::consistent});
  for (const Variant &variant : all)
    for (const double cfl : {0.5, 2., 10., 50.})
      if (variant.mass != Mass::consistent || cfl < 10.)
      {
        const Summary s = impact_of(bar_meets_wall, variant, cfl);
        row(joined(joined({variant.words(), number(cfl)}, cells_of(s)), {percent(s.displacement)}));
      }
}

inline void theta_table()
{
  head({"scheme", "CFL", "energy gained, at most [%]", "at the end [%]", "of it contact took [%]",
        "restitution", "noise of the pressure [%]"});
  for (const std::string scheme :
       {"softgrain 0.5", "softgrain 0.51", "softgrain 0.52", "softgrain 0.55", "softgrain 0.6",
        "softgrain 0.8", "softgrain 1", "whole_step 0.8", "whole_step 0.5", "whole_step 0"})
    for (const double cfl : {0.5, 2., 10., 50.})
    {
      const Summary s = impact_of(bar_meets_wall, {scheme, Mass::lumped}, cfl);
      row({scheme, number(cfl), percent(s.gained), percent(s.kept), percent(s.contact_took),
           number(s.restitution), percent(s.noise)});
    }
}

inline void bars_table()
{
  head(joined({"scheme", "CFL"}, figures));
  for (const Variant &variant : variants())
    for (const double cfl : {0.5, 2., 10., 50.})
      row(joined({variant.words(), number(cfl)}, cells_of(impact_of(bar_meets_bar, variant, cfl))));
}

inline void bounce_table()
{
  head({"scheme", "CFL", "energy gained, at most [%]", "energy at 12 s [%]", "penetration [%]",
        "error of u to 3 s [%]"});
  for (const Variant &variant : variants())
    for (const double cfl : {0.5, 2., 10., 50.})
    {
      const Bounces one = bouncing_bar(variant.scheme, variant.mass, cfl, 3.),
                    four = bouncing_bar(variant.scheme, variant.mass, cfl, 12.);
      row({variant.words(), number(cfl), percent(four.gained), percent(four.kept), percent(four.penetration),
           percent(one.displacement)});
    }
}

inline void program_table()
{
  head(joined(joined({"program", "CFL", "Newton iterations a step"}, figures), {"error of u [%]"}));
  const std::vector<std::vector<std::string>> ways = {
      {"moreau_jean, hats", "linear", "moreau_jean", "0"},
      {"moreau_jean, θ = 0.5, hats", "linear", "moreau_jean", "0.5"},
      {"newmark, hats", "linear", "newmark", "0"},
      {"moreau_jean, B-splines", "bspline", "moreau_jean", "0"},
      {"moreau_jean, θ = 0.5, B-splines", "bspline", "moreau_jean", "0.5"}};
  for (const auto &way : ways)
    for (const double cfl : {0.5, 2., 10., 50.})
    {
      double attempts = 0., iterations = 0.;
      const Summary s = over_phases(
          [&](const double phase)
          {
            const ProgramImpact impact =
                program_bar_meets_wall(cfl, phase,
                                       {"Material points/Shape function=" + way[1], "Time/Scheme=" + way[2],
                                        "Time/Theta=" + way[3]});
            attempts += impact.attempts;
            iterations += impact.newton_iterations;
            return impact.measures;
          },
          3);
      row(joined(joined({way[0], number(cfl), number(iterations / attempts)}, cells_of(s)),
                 {percent(s.displacement)}));
    }
}

inline void disks_table()
{
  head({"program", "CFL", "Newton iterations a step", "energy gained, at most [%]", "at the end, mean [%]",
        "restitution, mean (least)", "penetration [cells]"});
  for (const std::string way : {"moreau_jean", "moreau_jean, θ = 0.5", "moreau_jean, θ = 0.51",
                                "moreau_jean, θ = 0.8", "newmark", "explicit"})
    for (const double cfl : {0.3, 1., 5., 20.})
      if (way != "explicit" || cfl < 1.)
      {
        const std::string theta = way.find("0.") == std::string::npos ? "0" : way.substr(way.find("0."));
        DiskImpact worst;
        double kept = 0., restitution = 0., least = 1e300;
        const std::vector<double> phases = {0.1, 0.3, 0.5, 0.7, 0.9};
        for (const double phase : phases)
        {
          const DiskImpact one = program_disks(
              cfl, phase, {"Time/Scheme=" + way.substr(0, way.find(',')), "Time/Theta=" + theta});
          worst.gained = std::max(worst.gained, one.gained);
          worst.penetration = std::max(worst.penetration, one.penetration);
          worst.steps += one.steps;
          worst.newton_iterations += one.newton_iterations;
          kept += one.kept / phases.size();
          restitution += one.restitution / phases.size();
          least = std::min(least, one.restitution);
        }
        row({way, number(cfl), number(worst.newton_iterations / double(worst.steps)), percent(worst.gained),
             percent(kept), number(restitution) + " (" + number(least) + ")", number(worst.penetration)});
      }
}

inline void friction_table()
{
  head({"scheme", "steps until it stands, a period", "way [%]", "velocity that stays [%]",
        "oscillator, place [%]", "velocity that stays [%]", "creep in 100 steps [%]"});
  for (const std::string name : {"newmark", "kane", "alpha", "moreau_jean", "softgrain", "softgrain 0.8"})
    for (const double steps : {100., 30., 10.})
    {
      const Slide block = worst_decelerating_block(name, steps), oscillator = oscillating_block(name, steps);
      row({name, number(steps), percent(block.place), percent(block.chatter), percent(oscillator.place),
           percent(oscillator.chatter), percent(oscillator.creep)});
    }
}

inline void block_table()
{
  head({"program", "steps until it stands", "way [%]", "velocity that stays [%]"});
  for (const std::string theta : {"0.5", "0.55", "0.8"})
    for (const double steps : {100., 30., 10.})
    {
      const auto block = program_block(0.2 / 3. / steps, theta);
      row({"moreau_jean, θ = " + theta, number(steps), percent(block.first), percent(block.second)});
    }
}

inline void print_tables()
{
  for (const auto table : {wall_table, theta_table, bars_table, bounce_table, friction_table, program_table,
                           disks_table, block_table})
  {
    table();
    std::cout << '\n';
  }
}
} // namespace softgrain::schemes

#endif
