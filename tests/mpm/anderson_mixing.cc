// SPDX-License-Identifier: LGPL-2.1-or-later
// Fixed-point iterations x -> A x + b whose errors change by the factors 0.9, -1.3 and 0.5: plain iteration
// diverges, mixed iteration is done after one iteration more than there are factors.
#include <softgrain/mpm/stepping/anderson_mixing.h>

#include <Eigen/LU>

#include <iostream>

int main()
{
  Eigen::MatrixXd A = Eigen::Vector3d(0.9, -1.3, 0.5).asDiagonal();
  const Eigen::Matrix3d turn =
      Eigen::Matrix3d((Eigen::Matrix3d() << 2., 1., 0., -1., 2., 1., 0.5, 0., 1.).finished());
  A = turn * A * turn.inverse();
  const Eigen::VectorXd b = Eigen::Vector3d(1., 2., 3.);
  const Eigen::VectorXd exact = (Eigen::MatrixXd::Identity(3, 3) - A).fullPivLu().solve(b);
  for (const unsigned int depth : {0u, 1u, 3u, 5u})
  {
    softgrain::mpm::AndersonMixing mixing(depth);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(3);
    unsigned int n = 0;
    for (; n < 30 && (x - exact).norm() > 1e-6 * exact.norm(); ++n)
      x = mixing.next(x, A * x + b);
    std::cout << "depth " << depth << ": "
              << (n < 30 ? "done after " + std::to_string(n) + " iterations" : "not done after 30") << '\n';
  }
}
