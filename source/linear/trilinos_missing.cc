// SPDX-License-Identifier: LGPL-2.1-or-later
// Compiled in place of trilinos_solver.cc where deal.II has no Trilinos.
#include <softgrain/linear/missing_solver_kind.h>

namespace softgrain
{
namespace
{
[[maybe_unused]] const bool registered = MissingSolverKind::add("cg_amg", "Trilinos");
} // namespace
} // namespace softgrain
