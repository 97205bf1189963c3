// SPDX-License-Identifier: LGPL-2.1-or-later
// Matrices of a body that is pressed hard have one negative eigenvalue, against rotation; a rank-one term
// makes them positive definite. Both factorisations against dense algebra: solution, Delassus operator, and
// that more than the term can lift is refused.
#include "scene_of.h"

#include <softgrain/linear/banded_solver.h>
#include <softgrain/linear/cholesky_solver.h>
#include <softgrain/linear/rank_one_solver.h>
#include <softgrain/mpm/body/whole_rotation.h>
#include <softgrain/mpm/stepping/stiffness.h>
#include <softgrain/mpm/stepping/stress.h>

#include <Eigen/Dense>

#include <iostream>

using namespace softgrain;

namespace
{
/// A disk squeezed evenly by 0.5 %, its stiffness with a little mass, and its rotation.
struct Squeezed
{
  Squeezed()
      : model(shipped_scene("verification/line_contact.prm",
                            {"Mesh/Cell size=1.3e-3", "Mesh/Lower=-8e-3, -8e-3", "Mesh/Upper=8e-3, 8e-3"}))
      , body(model->bodies()[0])
  {
    Eigen::VectorXd u(body.field.n_dofs());
    for (unsigned int i = 0; i < body.field.n_independent(); ++i)
      for (unsigned int d = 0; d < 2; ++d)
        u[2 * i + d] = -0.005 * body.field.place(i)[d];
    body.nodes.displacement = u;
    mpm::evaluate_stress(body, u, u, {0., true, 0.}, points);
    lay_out_stiffness(body.field, matrix, false);
    matrix.set_zero();
    mpm::add_stiffness(body, points, 1., matrix);
    matrix.add_mass<2>(body.nodes.mass, 1e-3 * body.material.law->young_modulus() / body.nodes.mass.sum());
    rotation = mpm::whole_rotation(body);
  }

  Eigen::MatrixXd dense(const double k) const
  {
    const Eigen::MatrixXd B = Eigen::MatrixXd(matrix.lower()).selfadjointView<Eigen::Lower>();
    return B + k * rotation * rotation.transpose();
  }

  std::unique_ptr<mpm::MpmModel> model;
  mpm::Body<2> body;
  mpm::StepState<2> points;
  SystemMatrix matrix;
  Eigen::VectorXd rotation;
};

template <class Solver>
void check(const std::string &name)
{
  Squeezed at;
  const double k = 2.5 * mpm::pressure_area(at.body, at.points);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> bare(at.dense(0.)), held(at.dense(k));
  RankOneSolver solver(std::make_unique<Solver>());
  solver.set_update(at.rotation, k);
  const bool fine = solver.factorize(at.matrix);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(at.body.field.n_dofs(), -1., 2.);
  Eigen::VectorXd x;
  solver.solve(b, x);
  const Eigen::MatrixXd A = at.dense(k);
  LinearSolver::Rows rows(b.size(), 3);
  for (unsigned int c = 0; c < 3; ++c)
    for (unsigned int i = c; i < b.size(); i += 5)
      rows.insert(i, c) = 1. + c;
  rows.makeCompressed();
  Eigen::MatrixXd W;
  solver.condense(rows, W);
  const Eigen::MatrixXd H = rows, exact = H.transpose() * A.ldlt().solve(H);
  std::cout << name << ": negative eigenvalues " << (bare.eigenvalues().array() < 0.).count()
            << " and with the term " << (held.eigenvalues().array() < 0.).count() << ", accepted "
            << (fine ? "yes" : "no") << ", residual " << below(1e-9, (A * x - b).norm() / b.norm())
            << ", Delassus operator " << below(1e-9, (W - exact).norm() / exact.norm());
  // Half of what turns it is not enough.
  solver.set_update(at.rotation, 0.3 * k);
  std::cout << ", 0.3 of the term: accepted " << (solver.factorize(at.matrix) ? "yes" : "no");
  solver.set_update(at.rotation, 0.);
  std::cout << ", none: " << (solver.factorize(at.matrix) ? "yes" : "no") << '\n';
}
/// The same matrix less more and more mass: the solvers themselves count its negative eigenvalues.
template <class Solver>
void count(const std::string &name)
{
  for (const double less : {1., 30., 300.})
  {
    Squeezed at;
    at.matrix.add_mass<2>(at.body.nodes.mass,
                          -less * at.body.material.law->young_modulus() / at.body.nodes.mass.sum());
    const Eigen::MatrixXd A = at.dense(0.);
    const unsigned int n =
        (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues().array() < 0.).count();
    Solver solver;
    const bool fine = solver.factorize(at.matrix);
    const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(A.rows(), -1., 2.);
    Eigen::VectorXd x;
    solver.solve(b, x);
    LinearSolver::Rows rows(b.size(), 1);
    for (unsigned int i = 0; i < b.size(); i += 3)
      rows.insert(i, 0) = 1.;
    rows.makeCompressed();
    Eigen::MatrixXd W;
    solver.condense(rows, W);
    const Eigen::VectorXd h = rows;
    const double exact = h.dot(A.partialPivLu().solve(h));
    std::cout << name << ", less mass: negative eigenvalues " << n << ", factorised " << (fine ? "yes" : "no")
              << ", counted right " << (solver.n_negative() == n ? "yes" : "no") << ", residual "
              << below(1e-7, (A * x - b).norm() / b.norm()) << ", Delassus operator "
              << below(1e-6, std::abs(W(0, 0) / exact - 1.)) << '\n';
  }
}
} // namespace

int main()
{
  check<BandedSolver>("banded");
  check<CholeskySolver>("sparse");
  count<BandedSolver>("banded");
  count<CholeskySolver>("sparse");
}
