// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/contact/active_set.h>
#include <softgrain/driving/contact_settings.h>
#include <softgrain/linear/linear_solver_kind.h>
#include <softgrain/mpm/contact/contact_geometry_kind.h>
#include <softgrain/mpm/field/shape_function.h>
#include <softgrain/mpm/model/settings.h>
#include <softgrain/mpm/model/step_choice.h>
#include <softgrain/mpm/stepping/time_integrator.h>
#include <softgrain/parameters/parameter_values.h>

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
               prm.declare_entry("Lower", "0, 0", List(Double(), 2, 3),
                                 "Corner of the background mesh with the smallest coordinates, as many as "
                                 "'Dimension' says. Units: m.");
               prm.declare_entry("Upper", "1, 1", List(Double(), 2, 3),
                                 "Corner with the greatest coordinates; the mesh ends at the first cell face "
                                 "beyond it. Units: m.");
               prm.declare_entry("Cell size", "0", Double(0.),
                                 "Edge of the square cells. 0: a share of the width of the smallest body, as "
                                 "'Fidelity' says. Units: m.");
               prm.declare_entry(
                   "Refine near contact", "0", Integer(0, 6),
                   "Levels of smaller cells in each body near places where it may touch others, walls or "
                   "obstacles: a level halves the cells that are at most two of its cells away. What starts "
                   "farther than 'Cell size' away does not count. Other lengths in cells are then in the "
                   "smallest. With 'Shape function' = 'linear' or 'quadratic', an implicit scheme and 'Grid "
                   "update' = 'never'. Units: none.");
             });
  in_section(
      prm, "Material points",
      [&]
      {
        prm.declare_entry("Shape function", "bspline",
                          Selection(Registry<ShapeFunction>::instance().choice()),
                          "Functions that interpolate between points and grid; " +
                              Registry<ShapeFunction>::instance().choice_in_words());
        prm.declare_entry("Points per direction", "2", Integer(1, 8),
                          "Material points per cell and direction at the start. Units: none.");
        prm.declare_entry(
            "Fill limit", "0", Double(0., 1.),
            "A cell is well filled when the body covers more than this share of it. A node that no "
            "well-filled cell reaches gets an extrapolated value instead of one of its own. 0: .95 for "
            "balls in space without inertia, .6 otherwise. Units: none.");
        prm.declare_entry("Grid update", "never", Selection("never|every step|distortion"),
                          "When a new grid is laid under the points. never: total Lagrangian, right for "
                          "elastic bodies; every step: the usual material point method, and the thesis's; "
                          "distortion: when 'Distortion limit' is exceeded.");
        prm.declare_entry("Distortion limit", "3", Double(1.01, 100.),
                          "With 'Grid update = distortion': ratio of the largest to the smallest stretch of "
                          "the grid above which a new one is laid. Units: none.");
        prm.declare_entry("Transfer", "flip", Selection("flip|apic"),
                          "How points take over velocities from the grid before a new one is laid. flip: "
                          "increments are added; apic: affine particle-in-cell method.");
        prm.declare_entry("PIC fraction", "0", Double(0., 1.),
                          "Share of the velocity interpolated from the grid in the velocity that points take "
                          "over. 0: increments only (FLIP), 1: interpolation only (PIC). It damps noise, and "
                          "energy too. Units: none.");
        prm.declare_entry("F-bar", "automatic", Selection("automatic|on|off"),
                          "Whether the volume change is averaged over each cell, against locking of nearly "
                          "incompressible materials: most of it, see theory; automatic: on above a Poisson's "
                          "ratio of 0.47.");
      });
}

void declare_solution(dealii::ParameterHandler &prm)
{
  in_section(prm, "Newton",
             [&]
             {
               prm.declare_entry("Displacement tolerance", "1e-5", Double(1e-14, 1.),
                                 "epsilon_1 of (3.22): length of the last displacement of Newton's method "
                                 "over that of the first. Units: none.");
               prm.declare_entry("Energy tolerance", "1e-8", Double(1e-20, 1.),
                                 "epsilon_2 of (3.22): work of the last displacement of Newton's method over "
                                 "that of the first. Units: none.");
               prm.declare_entry("Residual tolerance", "1e-5", Double(1e-14, 1.),
                                 "Largest unbalanced impulse that is accepted, over the largest impulse of "
                                 "the step. Units: none.");
               prm.declare_entry("Maximum iterations", "25", Integer(1, 1000),
                                 "A step that needs more iterations of Newton's method is repeated with half "
                                 "its length. Units: none.");
               prm.declare_entry("Largest strain", "0.3", Double(1e-6, 1e6),
                                 "Largest strain of any material point in one implicit step (Green-Lagrange, "
                                 "norm). A step that exceeds it is repeated with half its length, because "
                                 "Newton's method may have found a false balance. Units: none.");
             });
  in_section(
      prm, "Linear solver",
      [&]
      {
        prm.declare_entry(
            "Type", "automatic", Selection("automatic|" + Registry<LinearSolverKind>::instance().choice()),
            "automatic: one of the Cholesky solvers, but cg_amg, where it is there, for a body of more than "
            "'Automatic limit' unknowns without contact; " +
                Registry<LinearSolverKind>::instance().choice_in_words());
        prm.declare_entry("Tolerance", "1e-10", Double(1e-15, 1e-1),
                          "Relative residual at which an iterative solver stops. Units: none.");
        prm.declare_entry("Maximum iterations", "2000", Integer(1),
                          "Largest number of iterations of an iterative solver. Units: none.");
        prm.declare_entry("Automatic limit", "40000", Integer(1),
                          "Number of unknowns of a body above which automatic takes an iterative "
                          "solver, when the scene has no contact. Units: none.");
      });
}

void declare_quasi_static(dealii::ParameterHandler &prm)
{
  in_section(
      prm, "Quasi-static",
      [&]
      {
        prm.declare_entry(
            "Regularisation", "0", Double(0., 1.),
            "Stiffness against the motion in a step, over Young's modulus. It takes the place of "
            "inertia and holds grains that touch nothing. Its forces vanish in held steps. 0: 1e-4.");
        prm.declare_entry("Unbalanced force", "1e-4", Double(1e-12, 1.),
                          "Bodies are in balance when the net force on each is at most this share of "
                          "the mean contact force.");
        prm.declare_entry(
            "Held steps", "1000", Integer(0, 100000),
            "Largest number of steps with walls at rest before a state is written; without balance after "
            "so many the run ends with a message. 0: none, and what is written is not in balance.");
        prm.declare_entry(
            "Wall motion", "0.3", Double(1e-6, 10.),
            "Way of a wall under pressure in a step and in each held step, at most. Held steps "
            "on the way to the grains do not count as 'Held steps'. With an implicit scheme that has "
            "inertia a step in which a wall that nothing bears would go farther, and at least twice as "
            "fast as before, is cut. Units: cells.");
      });
}

void declare_contact(dealii::ParameterHandler &prm)
{
  in_section(
      prm, "Contact",
      [&]
      {
        prm.declare_entry("Geometry", "automatic",
                          Selection("automatic|" + Registry<ContactGeometryKind>::instance().choice()),
                          "Where contact is looked for; automatic: rays; " +
                              Registry<ContactGeometryKind>::instance().choice_in_words());
        prm.declare_entry("Nodal gap", "true", Bool(),
                          "With 'Geometry = nodes'. true: bodies touch when the domains of their points "
                          "meet; false: as soon as they share a node.");
        prm.declare_entry(
            "Solver", "condensed", Selection("condensed|lumped"),
            "With 'Geometry = nodes'. condensed: contact is solved with the true compliance of the bodies, "
            "once "
            "per Newton iteration; lumped: with nodal masses, iterated together with Newton's method (the "
            "thesis).");
        prm.declare_entry("Marker spacing", "0.5", Double(0.05, 4.),
                          "Distance of the markers on which outlines are built: an outline has four vertices "
                          "to each. Units: cells.");
        prm.declare_entry(
            "Largest penetration", "0.1", Double(1e-6, 1e6),
            "How deep bodies may lie in each other, in walls and in obstacles at the end of a step, told by "
            "their outlines. A step that ends deeper, and deeper than it began, is repeated with half its "
            "length; below the smallest step the run ends. With 'Geometry = nodes' no less than 2 is "
            "allowed. "
            "Units: cells.");
        prm.declare_entry(
            "Sub-grid compliance", "true", Bool(),
            "Whether light contacts of round bodies get the dent that is narrower "
            "than a cell, by a "
            "law measured against finite elements. With B-splines and scheme quasi_static only.");
        ContactSettings::declare_parameters(
            prm, "1e-7",
            {{"automatic", "accelerated, and Newton when the sweeps do not converge"},
             {"accelerated", "sweeps with momentum and restart"},
             {"gauss_seidel", "plain sweeps"},
             {"active_set", "Newton on the active set"}});
        prm.declare_entry("Keep failed problems in", "", dealii::Patterns::Anything(),
                          "Folder in which contact problems that do not converge are kept, to be solved "
                          "again for study; empty: none are kept.");
      });
}

/// What cells of different sizes ask of the rest. @throw InputError
void check_refinement(const Settings &settings)
{
  if (settings.refine_near_contact == 0)
    return;
  const std::string name =
      "'Mesh/Refine near contact' = '" + std::to_string(settings.refine_near_contact) + "'";
  if (!create_shape_function(settings.shape)->may_hang())
    throw InputError(name + " is not allowed with 'Material points/Shape function' = '" + settings.shape +
                     "', which needs cells of one size: choose 'linear' or 'quadratic'");
  if (!settings.scheme.solves_equations())
    throw InputError(name + " is not allowed with 'Time/Scheme' = '" + settings.scheme.name +
                     "', whose steps the smallest cells would limit: leave it at 0");
  if (settings.grid_update != GridUpdate::never)
    throw InputError(name + " is not allowed with 'Material points/Grid update' other than 'never': points "
                            "would come into cells of another size; leave it at 0");
}

/// What a shape function asks of the rest. @throw InputError
void check_shape_function(const Settings &settings)
{
  const std::unique_ptr<ShapeFunction> function = create_shape_function(settings.shape);
  const std::string name = "'Material points/Shape function' = '" + settings.shape + "'";
  const std::string negative = ": it is negative in places, and so may be the mass of a node; choose ";
  if (!function->nowhere_negative() && !settings.scheme.ends_in_balance())
    throw InputError(name + " is not allowed with 'Time/Scheme' = '" + settings.scheme.name + "'" + negative +
                     "'quasi_static', or another shape function");
  if (settings.affine_transfer && function->degree() < 2)
    throw InputError(
        "'Material points/Transfer' = 'apic' is not allowed with 'Shape function' = '" + settings.shape +
        "': velocities at the rim of a body would grow with every transfer; choose 'bspline', or "
        "'flip'");
  if (settings.points_per_direction < function->least_points())
    throw InputError("'Material points/Points per direction' = '" +
                     std::to_string(settings.points_per_direction) +
                     "' is not allowed with 'Shape function' = '" + settings.shape +
                     "': a cell has deformations that strain none of so few points; choose " +
                     std::to_string(function->least_points()) + " or more");
}

void parse_points(const dealii::ParameterHandler &prm, const unsigned int dimension, Settings &settings)
{
  settings.shape = prm.get("Shape function");
  settings.points_per_direction = prm.get_integer("Points per direction");
  settings.fill_limit = prm.get_double("Fill limit");
  if (settings.fill_limit == 0. && dimension == 2)
    settings.fill_limit = 0.6;
  const std::string update = prm.get("Grid update");
  settings.grid_update = update == "never"        ? GridUpdate::never
                         : update == "every step" ? GridUpdate::every_step
                                                  : GridUpdate::distortion;
  settings.distortion_limit = prm.get_double("Distortion limit");
  settings.affine_transfer = prm.get("Transfer") == "apic";
  settings.pic_fraction = prm.get_double("PIC fraction");
  settings.f_bar = prm.get("F-bar");
  if (settings.grid_update == GridUpdate::never && (settings.affine_transfer || settings.pic_fraction > 0.))
    throw InputError(
        "'Material points/Transfer' and 'PIC fraction' have no effect with 'Grid update' = 'never': "
        "leave them at flip and 0, or choose another 'Grid update'");
}

void parse_contact(dealii::ParameterHandler &prm, Settings &settings)
{
  settings.contact_geometry = prm.get("Geometry");
  settings.coupling = prm.get("Solver") == "condensed" ? ContactCoupling::condensed : ContactCoupling::lumped;
  if (settings.contact_geometry == "automatic")
    settings.contact_geometry = "rays";
  if (settings.regularisation == 0.)
    settings.regularisation = 1e-4;
  settings.by_rays = Registry<ContactGeometryKind>::instance().create(settings.contact_geometry)->by_rays();
  settings.nodal_gap = prm.get_bool("Nodal gap");
  settings.marker_spacing = prm.get_double("Marker spacing");
  settings.largest_penetration = prm.get_double("Largest penetration");
  settings.subgrid = prm.get_bool("Sub-grid compliance");
  ContactSettings common;
  common.parse_parameters(prm);
  settings.contact_solver.tolerance = common.tolerance;
  settings.contact_solver.max_sweeps = common.max_sweeps;
  settings.contact_solver.relaxation = common.relaxation;
  settings.contact_solver.algorithm = contact::algorithms().at(common.algorithm);
  settings.failed_problem_directory = prm.get("Keep failed problems in");
}

/// What contact asks of grids and schemes. @throw InputError
void check_contact(const Settings &settings)
{
  if (Registry<ContactGeometryKind>::instance().create(settings.contact_geometry)->at_nodes() &&
      settings.grid_update != GridUpdate::every_step)
    throw InputError("'Contact/Geometry' = '" + settings.contact_geometry +
                     "' needs 'Material points/Grid update' = 'every step': bodies share "
                     "nodes only where the grid lies under all of them now");
  if (!settings.by_rays && settings.scheme.ends_in_balance())
    throw InputError("'Contact/Geometry' = '" + settings.contact_geometry +
                     "' is not allowed with 'Time/Scheme' = '" + settings.scheme.name +
                     "', which has no masses: it must be 'rays'");
  if (settings.by_rays && settings.coupling == ContactCoupling::lumped && settings.scheme.solves_equations())
    throw InputError("'Contact/Solver' = 'lumped' needs 'Contact/Geometry' = 'nodes': rays are solved "
                     "with the matrices of the bodies");
}
} // namespace

void Settings::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_discretisation(prm);
  declare_time_parameters(prm);
  declare_solution(prm);
  declare_quasi_static(prm);
  declare_contact(prm);
}

void Settings::parse_mesh(const dealii::ParameterHandler &prm, const unsigned int dimension)
{
  for (const std::string key : {"Lower", "Upper"})
    if (const std::string text = prm.get(key);
        std::count(text.begin(), text.end(), ',') != static_cast<int>(dimension) - 1)
      throw InputError("'Mesh/" + key + "' = '" + text + "' is not allowed: with 'Dimension' = '" +
                       std::to_string(dimension) + "' it must be " +
                       (dimension == 2 ? "two numbers \"x, y\"" : "three numbers \"x, y, z\""));
  if (dimension == 2)
  {
    mesh_lower = dealii::Point<2>(pair_of_numbers(prm.get("Lower")));
    mesh_upper = dealii::Point<2>(pair_of_numbers(prm.get("Upper")));
  }
  else
  {
    space_lower = dealii::Point<3>(vector_of_numbers<3>(prm.get("Lower")));
    space_upper = dealii::Point<3>(vector_of_numbers<3>(prm.get("Upper")));
  }
  cell_size = prm.get_double("Cell size");
  refine_near_contact = prm.get_integer("Refine near contact");
  if (cell_size < tiny)
    throw InputError("'Mesh/Cell size' = '" + prm.get("Cell size") +
                     "' is not allowed here: there is no body whose width is known beforehand, so it must "
                     "be greater than 0");
  double cells = 1.;
  for (unsigned int d = 0; d < dimension; ++d)
  {
    const double width = dimension == 2 ? mesh_upper[d] - mesh_lower[d] : space_upper[d] - space_lower[d];
    if (!(width > 0.))
      throw InputError("'Mesh/Upper' = '" + prm.get("Upper") +
                       "' is not allowed: " + (dimension == 2 ? "both" : "all") +
                       " numbers must be greater than those of 'Mesh/Lower' = '" + prm.get("Lower") + "'");
    cells *= width / finest_cell();
  }
  if (cells > 1e8)
    throw InputError("'Mesh/Cell size' = '" + prm.get("Cell size") + "' is not allowed" +
                     (refine_near_contact > 0
                          ? " with 'Refine near contact' = '" + prm.get("Refine near contact") + "'"
                          : "") +
                     ": the mesh would have more than 1e8 cells");
}

void Settings::parse_parameters(dealii::ParameterHandler &prm, const unsigned int dimension)
{
  in_section(prm, "Mesh", [&] { parse_mesh(prm, dimension); });
  in_section(prm, "Material points", [&] { parse_points(prm, dimension, *this); });
  parse_time_parameters(prm, *this);
  in_section(prm, "Quasi-static",
             [&]
             {
               regularisation = prm.get_double("Regularisation");
               unbalanced_force = prm.get_double("Unbalanced force");
               max_held_steps = prm.get_integer("Held steps");
               wall_motion = prm.get_double("Wall motion");
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
               check_linear_solver(linear_solver.type);
               linear_solver.tolerance = prm.get_double("Tolerance");
               linear_solver.max_iterations = prm.get_integer("Maximum iterations");
               linear_solver.automatic_dofs = prm.get_integer("Automatic limit");
             });
  in_section(prm, "Contact", [&] { parse_contact(prm, *this); });
  check_contact(*this);
  check_shape_function(*this);
  check_refinement(*this);
}
} // namespace softgrain::mpm
