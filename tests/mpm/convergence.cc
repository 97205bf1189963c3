// SPDX-License-Identifier: LGPL-2.1-or-later
// Order of convergence of every shape function. A square block is pulled by a load for which the answer is
// known: with Poisson's ratio 0 and the displacement A (s + a/pi sin(pi s / a)) / 2 along its axis s, stress
// is E A cos²(pi s / 2 a) along the axis, zero on all sides. Where the mesh fits the block the error of the
// stress at the points is of first order with hats and of second with B-splines. Quadratic functions get the
// first only, with a fifth of the error of hats: three points evenly spaced do not integrate their stiffness
// exactly. Where the mesh cuts the block, few points integrate what is left of a cell, and no function gets
// more than the first.
#include <deal.II/base/numbers.h>

#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
constexpr double half = 1., E = 3., strain = 1e-5;

/// How the block lies in the mesh.
struct Place
{
  double angle, x, y;
};

std::string scene(const Place &place)
{
  std::ostringstream text;
  text.precision(12);
  // The load is -E u''.
  const double c = std::cos(place.angle), s = std::sin(place.angle), k = dealii::numbers::PI / half;
  std::ostringstream load;
  load.precision(15);
  load << 0.5 * E * strain * k << " * sin(" << k << " * (" << c << " * (X - " << place.x << ") + " << s
       << " * (Y - " << place.y << ")))";
  text << "subsection Mesh\n  set Lower = 0, 0\n  set Upper = 4, 4\nend\n"
          "subsection Time\n  set Scheme = quasi_static\n  set Time step = 1\nend\n"
          "subsection Quasi-static\n  set Regularisation = 1e-5\nend\n"
          "subsection Materials\n  set Names = m\n  subsection m\n    set Law = neo_hookean\n    set Density "
          "= 1\n"
          "    subsection Neo-Hookean\n      set Young's modulus = "
       << E
       << "\n      set Poisson's ratio = 0\n    end\n  end\nend\n"
          "subsection Bodies\n  set Names = b\n  subsection b\n    set Shape = rectangle\n"
          "    set Center = "
       << place.x << ", " << place.y
       << "\n    set Size = 2, 2\n    set Angle = " << place.angle * 180. / dealii::numbers::PI
       << "\n    set Body force = " << c << " * " << load.str() << "; " << s << " * " << load.str()
       << "\n  end\nend\nsubsection Stop\n  set End time = 1\nend\n";
  return text.str();
}

/// Root of the mean square of the error of the stress, over that of the stress.
double error(const std::string &shape, const double h, const Place &place)
{
  std::ostringstream size;
  size << "Mesh/Cell size=" << h;
  const auto model = scene_of_text(scene(place), {"Material points/Shape function=" + shape,
                                                  "Material points/Points per direction=3", size.str()});
  const Snapshot<2> start = model->snapshot();
  run_until(*model, 1.);
  const Snapshot<2> now = model->snapshot();
  double sum = 0., scale = 0.;
  const dealii::Tensor<1, 2> axis({std::cos(place.angle), std::sin(place.angle)});
  for (unsigned int p = 0; p < now.points.position.size(); ++p)
  {
    const double s = axis * (start.points.position[p] - dealii::Point<2>(place.x, place.y));
    const double stress = E * strain * std::pow(std::cos(0.5 * dealii::numbers::PI * s / half), 2);
    const dealii::SymmetricTensor<2, 2> exact = stress * symmetrize(outer_product(axis, axis));
    sum += now.points.size[p] * std::pow((now.points.stress[p] - exact).norm(), 2);
    scale += now.points.size[p] * std::pow(exact.norm(), 2);
  }
  return std::sqrt(sum / scale);
}
} // namespace

int main(int argc, char **)
{
  const std::vector<double> sizes = {0.2, 0.1, 0.05};
  for (const Place &place : {Place{0., 2., 2.}, Place{0.5, 2.03, 1.96}})
    for (const std::string shape : {"linear", "gimp", "bspline", "quadratic"})
    {
      std::vector<double> errors;
      for (const double h : sizes)
        errors.push_back(error(shape, h, place));
      if (argc > 1)
        for (unsigned int i = 0; i < sizes.size(); ++i)
          std::cout << shape << " h " << sizes[i] << " error " << errors[i]
                    << (i == 0 ? "" : " order " + std::to_string(std::log2(errors[i - 1] / errors[i])))
                    << '\n';
      std::cout << shape << (place.angle == 0. ? " fitting" : " cut") << ": order "
                << std::log2(errors.front() / errors.back()) / 2. << ", last error " << errors.back() << '\n';
    }
}
