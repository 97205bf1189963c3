// SPDX-License-Identifier: LGPL-2.1-or-later
// Balls in cells that repeat, in space.
// A ball between two plates without friction is half of a ball and its mirror image in a cell of twice the
// height, so sides bear what plates do. A cell that is told twice, side by side, is the same. Where the cell
// begins says nothing: places are moved by whole cells of the grid, and bodies reach through its sides.
// Simple shear to the other side is its mirror image. Sides under pressure stand where told ones bear as
// much. Work of the sides is stored. Two balls that move meet through a side as they do in the middle, and a
// cell that deforms while they move gives them no energy but its own.
#include "moving_balls.h"
#include "two_balls.h"

#include <array>
#include <cmath>
#include <utility>

namespace
{
const std::string head = R"(
set Dimension = 3
subsection Mesh
  set Lower = -20, -20, -20
  set Upper = 30, 30, 30
  set Cell size = 1
end
)";

std::string wall(const std::string &name, const std::string &point, const std::string &more)
{
  return "  subsection " + name + "\n    set Point = " + point + "\n    " + more + "\n  end\n";
}

std::string balls(const std::vector<std::string> &centers, const std::vector<std::string> &radii)
{
  std::string names, text;
  for (unsigned int b = 0; b < centers.size(); ++b)
  {
    const std::string name(1, static_cast<char>('a' + b));
    names += (b == 0 ? "" : ", ") + name;
    text += "  subsection " + name + "\n    set Shape = sphere\n    set Center = " + centers[b] +
            "\n    set Radius = " + radii[b] + "\n  end\n";
  }
  return "subsection Bodies\n  set Names = " + names + "\n" + text + "end\n";
}

const std::string at_rest = "subsection Time\n  set Scheme = quasi_static\n  set Time step = 0.5\nend\n",
                  side = "set Type = periodic", stop = "subsection Stop\n  set End time = 1e9\nend\n";

struct Run
{
  std::vector<WallState<3>> walls;
  Energies energies;
  unsigned int steps = 0, iterations = 0;
  double worst = 0., coordination = 0.;

  double energy() const { return (energies.elastic + energies.dissipated) / energies.external_work - 1.; }
};

Run run_of(const std::string &text, const std::vector<std::string> &changes, const double end)
{
  std::ofstream("scene.prm") << text;
  const auto model = model_of("scene.prm", changes);
  const Outcome outcome = run(*model, end, 0.01);
  return {model->walls(),     model->energies(), outcome.steps,
          outcome.iterations, outcome.left_over, outcome.coordination};
}

/// A cell of three directions with @p text of bodies. @param sides what each pair of sides is told
std::string cell(const std::string &bodies,
                 const std::array<double, 3> &from,
                 const std::array<double, 3> &to,
                 const std::array<std::string, 3> &sides)
{
  const std::array<std::array<std::string, 2>, 3> names = {
      {{{"left", "right"}}, {{"front", "back"}}, {{"bottom", "top"}}}};
  std::string text = head + at_rest + gel("0.4", "1", "1000") + bodies +
                     "subsection Walls\n  set Names = left, right, front, back, bottom, top\n";
  for (unsigned int d = 0; d < 3; ++d)
    for (unsigned int k = 0; k < 2; ++k)
    {
      std::array<double, 3> point{};
      point[d] = k == 0 ? from[d] : to[d];
      text +=
          wall(names[d][k],
               std::to_string(point[0]) + ", " + std::to_string(point[1]) + ", " + std::to_string(point[2]),
               side + "\n    " + sides[d]);
    }
  return text + "end\n" + stop;
}

void show_plates()
{
  const std::string law = gel("0.4", "1", "1000"),
                    beside = "subsection Walls\n  set Names = bottom, top, left, right, front, back\n" +
                             wall("left", "-2.2, 0, 0", "") + wall("right", "2.6, 0, 0", "") +
                             wall("front", "0, -2.3, 0", "") + wall("back", "0, 2.5, 0", "");
  const Run plates = run_of(head + at_rest + law + balls({"0.2, 0.1, 2.6"}, {"2.4"}) + beside +
                                wall("bottom", "0, 0, 0", "") + wall("top", "0, 0, 5", "set Velocity = 0.3") +
                                "end\n" + stop,
                            {}, 3.);
  const Run mirrored =
      run_of(head + at_rest + law + balls({"0.2, 0.1, 2.6", "0.2, 0.1, -2.6"}, {"2.4", "2.4"}) + beside +
                 wall("bottom", "0, 0, -5", side + "\n    set Velocity = 0.3") +
                 wall("top", "0, 0, 5", side + "\n    set Velocity = 0.3") + "end\n" + stop,
             {}, 3.);
  std::cout << "a ball between plates: force of sides off by "
            << below(1e-3, mirrored.walls[1].normal_force / plates.walls[1].normal_force - 1.)
            << ", sides alike within "
            << below(1e-12, mirrored.walls[0].normal_force / mirrored.walls[1].normal_force - 1.)
            << ", energy in the cell off by " << below(0.02, mirrored.energy()) << ", twice that of plates "
            << below(1e-3, 0.5 * mirrored.energies.elastic / plates.energies.elastic - 1.) << '\n';
}

const std::array<std::string, 3> pressed = {
    {"set Velocity = 0.12", "set Velocity = 0.12", "set Velocity = 0.12"}};

/// Four balls in a cell with edges of 7, moved by some way, and so many cells beside each other along x.
std::string four(const std::array<int, 3> &way, const unsigned int cells)
{
  const double place[4][3] = {{1.6, 1.4, 1.3}, {5.1, 4.9, 1.5}, {5.2, 1.3, 5.}, {1.5, 5., 4.9}};
  std::vector<std::string> centers, radii;
  for (unsigned int c = 0; c < cells; ++c)
    for (unsigned int b = 0; b < 4; ++b)
    {
      std::ostringstream center;
      for (unsigned int d = 0; d < 3; ++d)
        center << (d == 0 ? "" : ", ") << place[b][d] + way[d] + (d == 0 ? 7. * c : 0.);
      centers.push_back(center.str());
      radii.push_back(b == 0 ? "2.2" : "2.3");
    }
  return balls(centers, radii);
}

double off(const Run &one, const Run &other, const std::array<double, 6> &factor)
{
  double worst = 0.;
  for (unsigned int w = 0; w < 6; ++w)
    worst =
        std::max(worst, std::abs(other.walls[w].normal_force / factor[w] / one.walls[w].normal_force - 1.));
  return worst;
}

void show_same_cells()
{
  const Run one = run_of(cell(four({}, 1), {}, {7., 7., 7.}, pressed), {}, 3.);
  std::cout << "four balls in a cell: balance within 1e-3 " << (one.worst < 1e-3) << ", coordination "
            << one.coordination << ", less than 10 iterations a step " << (one.iterations < 10 * one.steps)
            << '\n';
  const Run half = run_of(cell(four({}, 1), {}, {{7., 7., 7.}}, pressed), {"Time/Time step=0.25"}, 3.);
  std::cout << "steps half as long: energy off by " << below(0.04, half.energy()) << ", three times less "
            << (std::abs(half.energy()) < std::abs(one.energy()) / 3.) << ", force by "
            << below(2e-3, half.walls[5].normal_force / one.walls[5].normal_force - 1.) << '\n';
  // Balls are moved, too, some by a whole cell.
  const Run moved = run_of(cell(four({{-2, 4, -3}}, 1), {{-2., 1., 2.}}, {{5., 8., 9.}}, pressed), {}, 3.);
  std::cout << "the cell begins elsewhere: off by " << below(2e-5, off(one, moved, {1., 1., 1., 1., 1., 1.}))
            << '\n';
  std::array<std::string, 3> twice = pressed;
  twice[0] = "set Velocity = 0.24";
  const Run doubled = run_of(cell(four({}, 2), {}, {14., 7., 7.}, twice), {}, 3.);
  std::cout << "the cell twice: forces off by " << below(2e-5, off(one, doubled, {1., 1., 2., 2., 2., 2.}))
            << '\n';
}

void show_shear()
{
  const auto sheared =
      [](const std::string &slide, const bool mirrored, const std::string &friction, const double end)
  {
    const std::vector<std::string> right = {"1.6, 1.4, 1.3", "5.1, 4.6, 1.5", "5.0, 1.3, 4.6",
                                            "1.4, 4.7, 4.5"},
                                   left = {"5.4, 1.4, 1.3", "1.9, 4.6, 1.5", "2.0, 1.3, 4.6",
                                           "5.6, 4.7, 4.5"};
    return run_of(
        cell(balls(mirrored ? left : right, {"2.1", "2.2", "2.2", "2.2"}), {}, {{7., 6.6, 6.4}}, {}),
        {"Walls/top/Tangential velocity=" + slide, "Walls/top/Velocity=0.3", "Contact/Friction=" + friction},
        end);
  };
  // Later friction has more than one end.
  for (const auto &[friction, end] : {std::pair<std::string, double>{"0", 3.}, {"0.3", 2.}})
  {
    const Run right = sheared("0.3", false, friction, end), left = sheared("-0.3", true, friction, end);
    const WallState<3> &top = right.walls[5], &other = left.walls[5];
    std::cout << "simple shear, friction " << friction << ": the cell above stands at " << top.offset
              << ", and to the left at " << other.offset << "; shear forces opposite within "
              << below(1e-5, top.tangential_force / other.tangential_force + 1.)
              << ", top and bottom opposite within "
              << below(1e-12, right.walls[4].tangential_force / top.tangential_force + 1.)
              << ", pressures alike within " << below(1e-5, top.normal_force / other.normal_force - 1.)
              << '\n';
  }
}

void show_pressed()
{
  std::array<std::string, 3> told = pressed;
  told[2] = "";
  const std::string text = cell(four({}, 1), {}, {7., 7., 7.}, told);
  const Run driven = run_of(text, {"Walls/bottom/Velocity=0.24"}, 3.);
  const double area = std::pow(7. - 0.72, 2);
  std::ostringstream pressure;
  pressure.precision(12);
  pressure << "Walls/bottom/Pressure=" << driven.walls[4].normal_force / area << " * min(1, t / 3)";
  const Run loaded = run_of(text, {"Walls/bottom/Drive=pressure", pressure.str()}, 3.);
  std::cout << "a side under pressure bears it within "
            << below(2e-4, loaded.walls[4].normal_force / driven.walls[4].normal_force - 1.)
            << ", stands off by " << below(0.02, (loaded.walls[4].position - driven.walls[4].position) / 7.)
            << ", energy off by " << below(0.03, loaded.energy()) << '\n';
}

struct Moving
{
  std::vector<dealii::Tensor<1, 3>> velocity;
  double energy = 0., momentum = 0.;
};

Moving moving(const std::string &centers_a,
              const std::string &center_b,
              const std::string &tell,
              const double dt,
              const double end)
{
  std::string text = head + "subsection Time\n  set Scheme = moreau_jean\nend\n" + gel("0.4", "1", "1") +
                     balls({centers_a, center_b}, {"2.4", "2.4"}) +
                     "subsection Walls\n  set Names = bottom, top\n" + wall("bottom", "0, 0, 0", side) +
                     wall("top", "0, 0, 12", side + "\n    " + tell) + "end\n" + stop;
  std::ofstream("scene.prm") << text;
  const auto model = model_of("scene.prm", {"Bodies/a/Velocity=0; 0; .05", "Bodies/b/Velocity=.01; 0; -.05",
                                            "Time/Time step=" + std::to_string(dt)});
  const double before = model->energies().kinetic;
  double largest = before;
  Moving result;
  while (model->time() < end * (1. - 1e-12))
  {
    StepReport report = model->advance(end - model->time());
    model->settle(report);
    const Energies energies = model->energies();
    largest = std::max(largest, energies.kinetic + energies.elastic);
    result.energy = std::max(result.energy, std::abs(energies.kinetic + energies.elastic +
                                                     energies.dissipated - energies.external_work - before));
    result.momentum = std::max(result.momentum, model->momentum_error());
  }
  result.energy /= largest;
  for (const Body<3> &body : state_of(*model).bodies)
    result.velocity.push_back(body.nodes.momentum() / body.nodes.mass.sum());
  return result;
}

void show_motion()
{
  // They meet in the middle, and through the sides.
  const Moving middle = moving("0.13, 0.02, 3.4", "0.05, 0.12, 8.6", "", 0.5, 18.),
               across = moving("0.13, 0.02, 9.4", "0.05, 0.12, 2.6", "", 0.5, 18.);
  double off_by = 0.;
  for (unsigned int b = 0; b < 2; ++b)
    off_by = std::max(off_by, (middle.velocity[b] - across.velocity[b]).norm() / 0.05);
  std::cout << "balls that move meet through a side: velocities off by " << below(1e-9, off_by)
            << ", energy by " << below(1e-3, across.energy) << ", momentum by "
            << below(1e-11, across.momentum) << '\n';
  for (const double dt : {0.5, 0.25})
  {
    const Moving closing = moving("0.13, 0.02, 3.4", "0.05, 0.12, 8.6", "set Velocity = 0.02", dt, 24.);
    std::cout << "in a cell that closes, steps of " << dt << ": energy off by " << below(0.02, closing.energy)
              << ", momentum by " << below(1e-11, closing.momentum) << '\n';
  }
}
} // namespace

int main()
{
  show_plates();
  show_same_cells();
  show_shear();
  show_pressed();
  show_motion();
  const std::string of_four = cell(four({}, 1), {}, {7., 7., 7.}, pressed);
  refused(of_four, {"Bodies/a/Center=0.4, 1.4, 1.3"});
  refused(cell(balls({"3.5, 3.5, 3.5"}, {"3.3"}), {}, {7., 7., 7.}, pressed), {});
  refused(of_four, {"Walls/top/Type=plane", "Bodies/c/Center=5.2, 1.3, 4.5", "Bodies/d/Center=1.5, 5, 4.5"});
  refused(of_four, {"Walls/left/Tangential velocity=1"});
  refused(of_four, {"Walls/top/Friction=0.3"});
}
