// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/balance.h>
#include <softgrain/model/state_file.h>

#include <algorithm>

namespace softgrain
{
void Balance::note_momentum(const double moving)
{
  largest_momentum = std::max({largest_momentum, moving, wall_impulse.norm(), body_force_impulse.norm()});
}

double Balance::momentum_error(const dealii::Tensor<1, 2> &momentum) const
{
  const auto error = momentum - initial_momentum - wall_impulse - body_force_impulse;
  return largest_momentum > 0. ? error.norm() / largest_momentum : error.norm();
}

void Balance::save(StateWriter &out, const std::string &name) const
{
  out.write(name,
            std::vector<double>{initial_momentum[0], initial_momentum[1], body_force_impulse[0],
                                body_force_impulse[1], wall_impulse[0], wall_impulse[1], largest_momentum,
                                wall_work, body_force_work, contact_loss, wall_damping_loss, adhesion_work});
}

void Balance::load(const StateReader &in, const std::string &name)
{
  const std::vector<double> b = in.read_doubles(name);
  initial_momentum = dealii::Tensor<1, 2>({b.at(0), b.at(1)});
  body_force_impulse = dealii::Tensor<1, 2>({b.at(2), b.at(3)});
  wall_impulse = dealii::Tensor<1, 2>({b.at(4), b.at(5)});
  largest_momentum = b.at(6);
  wall_work = b.at(7);
  body_force_work = b.at(8);
  contact_loss = b.at(9);
  wall_damping_loss = b.at(10);
  adhesion_work = b.size() > 11 ? b[11] : 0.; // checkpoints of earlier versions have none
}
} // namespace softgrain
