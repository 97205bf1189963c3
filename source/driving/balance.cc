// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/driving/balance.h>
#include <softgrain/model/state_file.h>

#include <algorithm>
#include <limits>

namespace softgrain
{
void MomentumBalance::note(const double moving)
{
  largest = std::max({largest, moving, of_walls.norm(), of_loads.norm()});
}

double MomentumBalance::error(const dealii::Tensor<1, 2> &now, const double rounding) const
{
  const auto error = now - initial - of_walls - of_loads;
  if (!(largest > rounding))
    return std::numeric_limits<double>::quiet_NaN();
  return error.norm() / largest;
}

void Balance::save(StateWriter &out, const std::string &name) const
{
  out.write(name, std::vector<double>{momentum.initial[0], momentum.initial[1], momentum.of_loads[0],
                                      momentum.of_loads[1], momentum.of_walls[0], momentum.of_walls[1],
                                      momentum.largest, contact_loss, wall_damping_loss, adhesion_work,
                                      growth_work, cell_work, driven_work});
  load_work.save(out, name + "_of_loads");
  losses.save(out, name + "_of_losses");
  sums.save(out, name + "_of_sums");
}

void Balance::load(const StateReader &in, const std::string &name)
{
  const std::vector<double> b = in.read_doubles(name, 13);
  momentum.initial = dealii::Tensor<1, 2>({b[0], b[1]});
  momentum.of_loads = dealii::Tensor<1, 2>({b[2], b[3]});
  momentum.of_walls = dealii::Tensor<1, 2>({b[4], b[5]});
  momentum.largest = b[6];
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
