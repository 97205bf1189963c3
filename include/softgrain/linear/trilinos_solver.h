// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_linear_trilinos_solver_h
#define softgrain_linear_trilinos_solver_h

#include <softgrain/linear/linear_solver.h>

#include <memory>
#include <string>

namespace softgrain
{
/**
 * @brief Trilinos behind deal.II's wrappers: `trilinos_direct` (Amesos), `cg_ilu`, `cg_amg` (ML).
 *
 * Meant for single large bodies; condensation to contact rows takes one solve per row.
 * @throw InputError for another type
 */
std::unique_ptr<LinearSolver>
create_trilinos_solver(const std::string &type, const LinearSolverSettings &settings, unsigned int dim);
} // namespace softgrain

#endif
