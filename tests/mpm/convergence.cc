// SPDX-License-Identifier: LGPL-2.1-or-later
// Order of convergence of every shape function. A square block, turned against the mesh and shifted, is
// pulled by a load for which the answer is known: with Poisson's ratio 0 and the displacement A sin²(pi s / 2
// a)-like along its axis s, stress is E f'(s) along the axis, zero on all sides. The error of the stress at
// the points falls with the cell to the power of the degree: hats 1, B-splines and quadratic functions 2.
#include "scene_of.h"

#include <iostream>

using namespace softgrain;

namespace
{
constexpr double half = 1., E = 3., strain = 1e-5, angle = 0.5;

std::string scene()
{
  std::ostringstream text;
  text.precision(12);
  // u = A (s + a/pi sin(pi s / a)) / 2 has u' = A cos²(pi s / 2 a), which vanishes at s = ± a; the load is -E
  // u''.
  const double c = std::cos(angle), s = std::sin(angle), k = dealii::numbers::PI / half;
  std::ostringstream load;
  load.precision(15);
  load << 0.5 * E * strain * k << " * sin(" << k << " * (" << c << " * (X - 2.03) + " << s
       << " * (Y - 1.96)))";
  text << "subsection Mesh\n  set Lower = 0, 0\n  set Upper = 4, 4\nend\n"
          "subsection Time\n  set Scheme = quasi_static\n  set Time step = 1\nend\n"
          "subsection Quasi-static\n  set Regularisation = 1e-9\nend\n"
          "subsection Materials\n  set Names = m\n  subsection m\n    set Law = neo_hookean\n    set Density "
          "= 1\n"
          "    subsection Neo-Hookean\n      set Young's modulus = "
       << E
       << "\n      set Poisson's ratio = 0\n    end\n  end\nend\n"
          "subsection Bodies\n  set Names = b\n  subsection b\n    set Shape = rectangle\n"
          "    set Center = 2.03, 1.96\n    set Size = 2, 2\n    set Angle = "
       << angle * 180. / dealii::numbers::PI << "\n    set Body force = " << c << " * " << load.str() << "; "
       << s << " * " << load.str() << "\n  end\nend\nsubsection Stop\n  set End time = 1\nend\n";
  return text.str();
}

/// Root of the mean square of the error of the stress, over that of the stress.
double error(const std::string &shape, const double h)
{
  std::ostringstream size;
  size << "Mesh/Cell size=" << h;
  const auto model = scene_of_text(scene(), {"Material points/Shape function=" + shape,
                                             "Material points/Points per direction=3", size.str()});
  const Snapshot<2> start = model->snapshot();
  run_until(*model, 1.);
  const Snapshot<2> now = model->snapshot();
  double sum = 0., scale = 0.;
  const dealii::Tensor<1, 2> axis({std::cos(angle), std::sin(angle)});
  for (unsigned int p = 0; p < now.points.position.size(); ++p)
  {
    const double s = axis * (start.points.position[p] - dealii::Point<2>(2.03, 1.96));
    const double stress = E * strain * std::pow(std::cos(0.5 * dealii::numbers::PI * s / half), 2);
    const dealii::SymmetricTensor<2, 2> exact = stress * symmetrize(outer_product(axis, axis));
    sum += now.points.size[p] * (now.points.stress[p] - exact).norm_square();
    scale += now.points.size[p] * exact.norm_square();
  }
  return std::sqrt(sum / scale);
}
} // namespace

int main(int argc, char **)
{
  const std::vector<double> sizes = {0.2, 0.1, 0.05, 0.025};
  for (const std::string shape : {"linear", "gimp", "bspline", "quadratic"})
  {
    std::vector<double> errors;
    for (const double h : sizes)
      errors.push_back(error(shape, h));
    if (argc > 1)
      for (unsigned int i = 0; i < sizes.size(); ++i)
        std::cout << shape << " h " << sizes[i] << " error " << errors[i]
                  << (i == 0 ? "" : " order " + std::to_string(std::log2(errors[i - 1] / errors[i]))) << '\n';
    const double order = std::log(errors.front() / errors.back()) / std::log(sizes.front() / sizes.back());
    std::cout << shape << ": order " << order << '\n';
  }
}
