// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/mpm/settings.h>
#include <softgrain/scene/parameter_values.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

namespace softgrain::mpm
{
namespace
{
using dealii::Patterns::Bool;
using dealii::Patterns::Double;
using dealii::Patterns::Integer;
using dealii::Patterns::List;
using dealii::Patterns::Selection;

constexpr double tiny = 1e-300; // smallest positive number that a pattern of "greater than zero" needs

/// Runs @p work inside a subsection.
template <typename F>
void in_section(dealii::ParameterHandler &prm, const std::string &name, const F &work)
{
  prm.enter_subsection(name);
  work();
  prm.leave_subsection();
}

void declare_discretisation(dealii::ParameterHandler &prm)
{
  in_section(prm, "Mesh",
             [&]
             {
               prm.declare_entry("Lower", "0, 0", List(Double(), 2, 2),
                                 "Lower left corner of the background mesh. Units: m.");
               prm.declare_entry(
                   "Upper", "1, 1", List(Double(), 2, 2),
                   "Upper right corner; the mesh ends at the first cell face beyond it. Units: m.");
               prm.declare_entry("Cell size", "0.1", Double(tiny), "Edge of the square cells. Units: m.");
             });
  in_section(
      prm, "Material points",
      [&]
      {
        prm.declare_entry(
            "Shape function", "bspline", Selection("linear|gimp|bspline"),
            "linear: hats on the vertices (the thesis); gimp: hats averaged over the extent of the point; "
            "bspline: uniform quadratic B-splines.");
        prm.declare_entry("Points per direction", "2", Integer(1, 8),
                          "Points per cell and direction at the start.");
        prm.declare_entry("Fill limit", "0.6", Double(0.01, 1.),
                          "A cell counts as well filled above this share; nodes that no such cell reaches "
                          "are extrapolated.");
        prm.declare_entry(
            "Grid update", "never", Selection("never|every step|distortion"),
            "When the grid is laid anew under the points. never: total Lagrangian, right for elastic bodies; "
            "every step: the usual MPM and the thesis; distortion: when 'Distortion limit' is passed.");
        prm.declare_entry("Distortion limit", "3", Double(1.01, 100.),
                          "Largest over smallest stretch of the grid that 'distortion' allows.");
        prm.declare_entry(
            "Transfer", "flip", Selection("flip|apic"),
            "How velocities go from grid to points when the grid is laid anew: increments, or the affine "
            "particle-in-cell method.");
        prm.declare_entry(
            "PIC fraction", "0", Double(0., 1.),
            "Share of the interpolated velocity in what points take over (0: FLIP, 1: PIC); damps noise and "
            "energy.");
        prm.declare_entry("F-bar", "automatic", Selection("automatic|on|off"),
                          "Dilatation averaged over cells against volumetric locking; automatic: above a "
                          "Poisson's ratio of "
                          "0.47.");
      });
}

void declare_time(dealii::ParameterHandler &prm)
{
  in_section(
      prm, "Time",
      [&]
      {
        prm.declare_entry(
            "Scheme", "moreau_jean", Selection("moreau_jean|newmark|explicit|quasi_static"),
            "moreau_jean: theta scheme of contact dynamics; newmark: the thesis, (3.14)-(3.22); explicit: "
            "symplectic Euler; quasi_static: no inertia.");
        prm.declare_entry("Theta", "0.55", Double(0.5, 1.),
                          "Of moreau_jean: 0.5 conserves energy, 1 is backward Euler.");
        prm.declare_entry("Time step", "0", Double(0.), "0: 'CFL multiple' times the CFL step. Units: s.");
        prm.declare_entry("CFL multiple", "20", Double(1e-6),
                          "Step in units of cell size over pressure-wave speed, when 'Time step' is 0.");
        prm.declare_entry("Smallest step", "1e-4", Double(1e-12, 1.),
                          "Share of the wanted step below which the run gives up.");
      });
  in_section(prm, "Newton",
             [&]
             {
               prm.declare_entry("Displacement tolerance", "1e-5", Double(1e-14, 1.), "epsilon_1 of (3.22).");
               prm.declare_entry("Energy tolerance", "1e-8", Double(1e-20, 1.), "epsilon_2 of (3.22).");
               prm.declare_entry("Residual tolerance", "1e-5", Double(1e-14, 1.),
                                 "Unbalanced impulse over the largest impulse of the step.");
               prm.declare_entry("Maximum iterations", "25", Integer(1, 1000),
                                 "More than this and the step is cut in half.");
               prm.declare_entry(
                   "Largest strain", "0.3", Double(1e-6, 1e6),
                   "Of any material point in one implicit step (Green-Lagrange, norm); more and the "
                   "step is cut: Newton may then have found another, false balance.");
             });
  in_section(prm, "Linear solver",
             [&]
             {
               prm.declare_entry(
                   "Type", "automatic",
                   Selection("automatic|banded_cholesky|cholesky|trilinos_direct|cg_ilu|cg_amg"),
                   "banded_cholesky: dense kernels on the band of a compact body; cholesky: sparse (Eigen); "
                   "trilinos_direct, cg_ilu, cg_amg: Trilinos; automatic: one of the Cholesky solvers, but "
                   "cg_amg for a body of more than 'Automatic limit' unknowns without contact.");
               prm.declare_entry("Tolerance", "1e-10", Double(1e-15, 1e-1),
                                 "Relative residual of the iterative solvers.");
               prm.declare_entry("Maximum iterations", "2000", Integer(1), "Of the iterative solvers.");
               prm.declare_entry("Automatic limit", "40000", Integer(1),
                                 "Unknowns of a body above which automatic iterates, when the scene has no "
                                 "contact to condense.");
             });
}

void declare_contact(dealii::ParameterHandler &prm)
{
  in_section(
      prm, "Contact",
      [&]
      {
        prm.declare_entry("Geometry", "surface", Selection("surface|nodes"),
                          "surface: boundary markers against boundaries and walls; nodes: grid nodes that "
                          "bodies share (the "
                          "thesis; needs 'Grid update = every step').");
        prm.declare_entry("Nodal gap", "true", Bool(),
                          "Of geometry nodes: wait until the domains of the points meet; false: touch when a "
                          "node is shared.");
        prm.declare_entry(
            "Solver", "condensed", Selection("condensed|lumped"),
            "condensed: contact sees the bodies' true compliance, one solve per Newton iteration; lumped: it "
            "sees nodal masses and is iterated with Newton (the thesis).");
        prm.declare_entry("Marker spacing", "0.5", Double(0.05, 4.),
                          "Distance of the boundary markers that look for contact. Units: cells.");
        prm.declare_entry(
            "Position repair", "true", Bool(),
            "Take back by positions alone what penetration a step leaves; velocities are not touched.");
        prm.declare_entry("Tolerance", "1e-7", Double(1e-14, 1e-1),
                          "Residual of the contact solution (natural map), relative to the approach speed.");
        prm.declare_entry("Maximum sweeps", "20000", Integer(1), "Of nonlinear Gauss-Seidel per solve.");
        prm.declare_entry("Relaxation", "1", Double(0.05, 1.95),
                          "Factor on every change of an impulse, of 'Algorithm = gauss_seidel'.");
        prm.declare_entry("Algorithm", "automatic",
                          Selection("automatic|accelerated|gauss_seidel|active_set"),
                          "gauss_seidel: plain sweeps; accelerated: sweeps with momentum and restart; "
                          "active_set: Newton on "
                          "the active set; automatic: accelerated, and Newton when the sweeps get nowhere.");
        prm.declare_entry(
            "Keep failed problems in", "", dealii::Patterns::Anything(),
            "Folder for contact problems that do not converge, to be replayed; empty: none are kept.");
      });
}

contact::Algorithm algorithm_of(const std::string &name)
{
  if (name == "gauss_seidel")
    return contact::Algorithm::gauss_seidel;
  if (name == "accelerated")
    return contact::Algorithm::accelerated;
  return name == "active_set" ? contact::Algorithm::active_set : contact::Algorithm::automatic;
}
} // namespace

void Settings::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_discretisation(prm);
  declare_time(prm);
  declare_contact(prm);
}

void Settings::parse_parameters(dealii::ParameterHandler &prm)
{
  in_section(
      prm, "Mesh",
      [&]
      {
        mesh_lower = dealii::Point<2>(pair_of_numbers(prm.get("Lower")));
        mesh_upper = dealii::Point<2>(pair_of_numbers(prm.get("Upper")));
        cell_size = prm.get_double("Cell size");
        for (unsigned int d = 0; d < 2; ++d)
          if (!(mesh_upper[d] > mesh_lower[d]))
            throw InputError("'Mesh/Upper' = '" + prm.get("Upper") +
                             "' is not allowed: both numbers must be greater than those of 'Mesh/Lower' = '" +
                             prm.get("Lower") + "'");
        if ((mesh_upper[0] - mesh_lower[0]) / cell_size * ((mesh_upper[1] - mesh_lower[1]) / cell_size) > 1e8)
          throw InputError("'Mesh/Cell size' = '" + prm.get("Cell size") +
                           "' is not allowed: the mesh would have more than 1e8 cells");
      });
  in_section(
      prm, "Material points",
      [&]
      {
        shape = prm.get("Shape function");
        points_per_direction = prm.get_integer("Points per direction");
        fill_limit = prm.get_double("Fill limit");
        const std::string update = prm.get("Grid update");
        grid_update = update == "never"        ? GridUpdate::never
                      : update == "every step" ? GridUpdate::every_step
                                               : GridUpdate::distortion;
        distortion_limit = prm.get_double("Distortion limit");
        affine_transfer = prm.get("Transfer") == "apic";
        pic_fraction = prm.get_double("PIC fraction");
        f_bar = prm.get("F-bar");
        if (grid_update == GridUpdate::never && (affine_transfer || pic_fraction > 0.))
          throw InputError(
              "'Material points/Transfer' and 'PIC fraction' have no effect with 'Grid update' = 'never': "
              "leave them at flip and 0, or choose another 'Grid update'");
      });
  in_section(prm, "Time",
             [&]
             {
               scheme = TimeScheme::create(prm.get("Scheme"), prm.get_double("Theta"));
               time_step = prm.get_double("Time step");
               cfl_multiple = prm.get_double("CFL multiple");
               smallest_step = prm.get_double("Smallest step");
             });
  in_section(prm, "Newton",
             [&]
             {
               displacement_tolerance = prm.get_double("Displacement tolerance");
               energy_tolerance = prm.get_double("Energy tolerance");
               residual_tolerance = prm.get_double("Residual tolerance");
               max_newton = prm.get_integer("Maximum iterations");
               max_strain = prm.get_double("Largest strain");
             });
  in_section(prm, "Linear solver",
             [&]
             {
               linear_solver.type = prm.get("Type");
               linear_solver.tolerance = prm.get_double("Tolerance");
               linear_solver.max_iterations = prm.get_integer("Maximum iterations");
               linear_solver.automatic_dofs = prm.get_integer("Automatic limit");
             });
  in_section(
      prm, "Contact",
      [&]
      {
        contact_kind = prm.get("Geometry") == "surface" ? ContactKind::surface : ContactKind::nodes;
        nodal_gap = prm.get_bool("Nodal gap");
        coupling = prm.get("Solver") == "condensed" ? ContactCoupling::condensed : ContactCoupling::lumped;
        marker_spacing = prm.get_double("Marker spacing");
        repair_positions = prm.get_bool("Position repair");
        contact_solver.tolerance = prm.get_double("Tolerance");
        contact_solver.max_sweeps = prm.get_integer("Maximum sweeps");
        contact_solver.relaxation = prm.get_double("Relaxation");
        contact_solver.algorithm = algorithm_of(prm.get("Algorithm"));
        if (contact_solver.relaxation != 1. && contact_solver.algorithm != contact::Algorithm::gauss_seidel)
          throw InputError("'Contact/Relaxation' = '" + prm.get("Relaxation") +
                           "' is for plain sweeps only: leave it at 1, or set 'Contact/Algorithm' = "
                           "'gauss_seidel'");
        failed_problem_directory = prm.get("Keep failed problems in");
        if (contact_kind == ContactKind::nodes && grid_update != GridUpdate::every_step)
          throw InputError(
              "'Contact/Geometry' = 'nodes' needs 'Material points/Grid update' = 'every step': bodies share "
              "nodes only where the grid lies under all of them now");
        if (coupling == ContactCoupling::lumped && !scheme.inertia)
          throw InputError(
              "'Contact/Solver' = 'lumped' is not allowed with 'Time/Scheme' = 'quasi_static', which has no "
              "masses: choose 'condensed'");
      });
}
} // namespace softgrain::mpm
