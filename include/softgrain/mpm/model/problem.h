// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_problem_h
#define softgrain_mpm_model_problem_h

#include <softgrain/mpm/contact/contact_geometry.h>
#include <softgrain/mpm/contact/subgrid_compliance.h>
#include <softgrain/mpm/field/lattice.h>
#include <softgrain/mpm/field/shape_function.h>
#include <softgrain/mpm/model/settings.h>
#include <softgrain/scene/contact_pairs.h>
#include <softgrain/scene/scene.h>

#include <memory>

namespace softgrain::mpm
{
/// What is solved and how: all that a step reads and no step changes.
struct Problem
{
  Scene<2> scene;
  Settings settings;
  std::unique_ptr<Lattice<2>> lattice;
  std::unique_ptr<ShapeFunction> shape;
  std::unique_ptr<ContactGeometry<2>> geometry; ///< null with rays
  ContactPairs pairs;                           ///< what bodies and walls do to each other

  /// What the grid misses of light contacts.
  SubgridCompliance subgrid() const;

  /// Whether nothing holds material to material where bodies meet: no friction, no contact with a memory.
  bool slippery() const;

  /// Whether contacts remember what has become of them.
  bool contacts_remember() const;
};
} // namespace softgrain::mpm

#endif
