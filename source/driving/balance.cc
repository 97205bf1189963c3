// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/balance.h>
#include <softgrain/model/state_file.h>

#include <algorithm>
#include <limits>

namespace softgrain
{
void Balance::note_momentum(const double moving)
{
  largest_momentum = std::max({largest_momentum, moving, wall_impulse.norm(), body_force_impulse.norm()});
}

double Balance::momentum_error(const dealii::Tensor<1, 2> &momentum, const double rounding) const
{
  const auto error = momentum - initial_momentum - wall_impulse - body_force_impulse;
  if (!(largest_momentum > rounding))
    return std::numeric_limits<double>::quiet_NaN();
  return error.norm() / largest_momentum;
}

void Balance::save(StateWriter &out, const std::string &name) const
{
  out.write(name, std::vector<double>{initial_momentum[0], initial_momentum[1], body_force_impulse[0],
                                      body_force_impulse[1], wall_impulse[0], wall_impulse[1],
                                      largest_momentum, contact_loss, wall_damping_loss, adhesion_work,
                                      growth_work, cell_work, driven_work});
  load_work.save(out, name + "_of_loads");
  losses.save(out, name + "_of_losses");
  sums.save(out, name + "_of_sums");
}

void Balance::load(const StateReader &in, const std::string &name)
{
  const std::vector<double> b = in.read_doubles(name, 13);
  initial_momentum = dealii::Tensor<1, 2>({b[0], b[1]});
  body_force_impulse = dealii::Tensor<1, 2>({b[2], b[3]});
  wall_impulse = dealii::Tensor<1, 2>({b[4], b[5]});
  largest_momentum = b[6];
  contact_loss = b[7];
  wall_damping_loss = b[8];
  adhesion_work = b[9];
  growth_work = b[10];
  cell_work = b[11];
  driven_work = b[12];
  load_work.load(in, name + "_of_loads");
  losses.load(in, name + "_of_losses");
  sums.load(in, name + "_of_sums");
}
} // namespace softgrain
