// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_point_history_h
#define softgrain_mpm_model_point_history_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/mpm/body/body.h>

#include <algorithm>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/// What the history of a law is called, as far as it has names.
template <int dim>
std::vector<std::string> named_history(const constitutive::Law<dim> &law)
{
  std::vector<std::string> names = law.history_names();
  names.resize(std::min<std::size_t>(names.size(), law.n_history()));
  return names;
}

/// Adds fields for the history of a law under the names that it gives, with zeros: that is what they are
/// where the law of a point has no such name. All points have their places.
template <int dim>
void add_history_fields(const constitutive::Law<dim> &law, PointStates<dim> &points)
{
  for (const std::string &name : named_history(law))
    if (std::none_of(points.extra.begin(), points.extra.end(),
                     [&](const NamedField &other) { return other.name == name; }))
      points.extra.push_back(NamedField{name, std::vector<double>(points.position.size())});
}

/// Fills these fields for the points of a body. @param place of a point of the body in the lists
template <int dim, class Place>
void put_history(const Body<dim> &body, const Place &place, PointStates<dim> &points)
{
  const std::vector<std::string> names = named_history(*body.material.law);
  for (unsigned int i = 0; i < names.size(); ++i)
  {
    const auto field = std::find_if(points.extra.begin(), points.extra.end(),
                                    [&](const NamedField &other) { return other.name == names[i]; });
    for (unsigned int p = 0; p < body.points.size(); ++p)
      field->values[place(p)] = body.points[p].history()[i];
  }
}
} // namespace softgrain::mpm

#endif
