// SPDX-License-Identifier: LGPL-2.1-or-later
// A step that is refused leaves nothing behind: the shorter one that follows it is that of a model which was
// asked for no more, bit for bit, with walls whose pressure depends on what they felt before. Likewise where
// a linear solver fails once: it gives no numbers, or gives up.
#include "gel.h"
#include "scene_of.h"

#include <softgrain/base/exceptions.h>
#include <softgrain/base/mpi_session.h>
#include <softgrain/linear/cholesky_solver.h>
#include <softgrain/linear/linear_solver_kind.h>

#include <iostream>
#include <limits>

using namespace softgrain;

namespace
{
const std::string scene = R"(
subsection Mesh
  set Lower     = -7e-3, -7e-3
  set Upper     = 7e-3, 7e-3
  set Cell size = 1e-3
end
)" + gel("0.3") + R"(subsection Bodies
  set Names = disk
  subsection disk
    set Radius = 5e-3
  end
end
subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Point = 0, -5e-3
  end
  subsection top
    set Point    = 0, 5e-3
    set Velocity = 10
  end
  subsection left
    set Point = -5e-3, 0
  end
  subsection right
    set Point = 5e-3, 0
  end
end
subsection Time
  set Time step = 1e-4
end
subsection Stop
  set End time = 1
end
)";

/// Fails once, in the way that the last word of its name says.
class FailingSolver final : public LinearSolver
{
public:
  explicit FailingSolver(const std::string &how) : how(how) {}
  bool factorize(SystemMatrix &matrix) override { return inner.factorize(matrix); }
  std::optional<unsigned int> n_negative() const override { return inner.n_negative(); }
  void solve(const Eigen::VectorXd &b, Eigen::VectorXd &x) override
  {
    inner.solve(b, x);
    if (fails("solve"))
      x.setConstant(std::numeric_limits<double>::quiet_NaN());
    if (fails("converge"))
      throw ComputationError("the solver does not converge");
  }
  void condense(const Rows &rows, Eigen::MatrixXd &W) override
  {
    inner.condense(rows, W);
    if (fails("condense"))
      W.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

private:
  bool fails(const std::string &here)
  {
    const bool now = here == how;
    if (now)
      how.clear();
    return now;
  }
  std::string how;
  CholeskySolver inner;
};

class Failing final : public LinearSolverKind
{
public:
  explicit Failing(const std::string &how) : how(how) {}
  std::unique_ptr<LinearSolver> create(const LinearSolverSettings &, unsigned int) const override
  {
    return std::make_unique<FailingSolver>(how);
  }

private:
  const std::string how;
};

std::string state(const mpm::MpmModel &model)
{
  std::ostringstream text;
  text << std::hexfloat << model.time();
  for (const auto &body : model.bodies())
    text << ' ' << body.nodes.velocity.sum() << ' ' << body.nodes.displacement.squaredNorm();
  for (const auto &wall : model.walls())
    text << ' ' << wall.position << ' ' << wall.velocity << ' ' << wall.normal_force;
  return text.str();
}

void refuse(const std::string &what,
            const std::vector<std::string> &of_bold,
            const std::vector<std::string> &of_careful)
{
  const auto bold = scene_of_text(scene, of_bold), careful = scene_of_text(scene, of_careful);
  const StepReport report = bold->advance(1.);
  careful->advance(report.dt);
  std::cout << what << ": refused before " << (report.attempts > 0 ? "yes" : "no") << ", then "
            << (state(*bold) == state(*careful) ? "the same" : "another") << " step\n";
}

void refuse(const std::string &what, const std::vector<std::string> &changes)
{
  refuse(what, changes, changes);
}

void fail(const std::string &how)
{
  const std::string type = "Linear solver/Type=";
  refuse("a solver fails to " + how, {type + "fails_to_" + how}, {type + "cholesky"});
}
} // namespace

int main(int, char **argv)
{
  const softgrain::MPISession mpi(argv);
  const std::string strain = "Newton/Largest strain=0.02";
  refuse("prescribed", {strain});
  refuse("pressure", {strain, "Walls/right/Drive=pressure", "Walls/right/Pressure=1e5"});
  refuse("mean pressure", {strain, "Walls/right/Drive=mean_pressure", "Walls/right/Mean pressure=1e5"});
  for (const std::string how : {"solve", "condense", "converge"})
  {
    Registry<LinearSolverKind>::instance().add("fails_to_" + how, how,
                                               [=] { return std::make_unique<Failing>(how); });
    fail(how);
  }
}
