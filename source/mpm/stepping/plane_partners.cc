// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/partner_numbers.h>
#include <softgrain/driving/obstacle_partner.h>
#include <softgrain/driving/wall_partner.h>
#include <softgrain/mpm/stepping/plane_partners.h>

namespace softgrain::mpm
{
namespace
{
/// A body that is told how to move, in the books of a step.
class DrivenBodyPartner : public RigidPartner<2>
{
public:
  DrivenBodyPartner(const dealii::Tensor<1, 2> &velocity, double &work) : velocity(velocity), work(work) {}

  double take(const PartnerImpulse<2> &impulse) override
  {
    const double done = impulse.acting * (impulse.direction * velocity);
    work += done;
    return done;
  }
  // What acts is the mean already.
  void book_mean(std::vector<DrivenWork> &) override {}

private:
  const dealii::Tensor<1, 2> velocity; ///< [m/s]
  double &work;                        ///< [J/m]
};
} // namespace

PlanePartners::PlanePartners(State &state, const Workspace &work, const FoundStep &step)
    : n_walls(state.walls.size())
{
  const double held = step.plan.held ? step.plan.dt : 0.;
  std::vector<dealii::Tensor<1, 2>> loads(n_walls); // a wall loses what it has felt when its book is begun
  for (std::size_t w = 0; w < n_walls && step.balanced; ++w)
    loads[w] = load_at(state.walls, w, begin_of_load(state.walls[w], state.time, held));
  for (std::size_t w = 0; w < n_walls; ++w)
    numbered.push_back(std::make_unique<WallPartner>(state.walls[w],
                                                     WallRates{step.motion[w].rate, step.motion[w].slide},
                                                     step.plan.dt, step.balanced, loads[w]));
  for (Obstacle<2> &obstacle : state.obstacles)
    numbered.push_back(std::make_unique<ObstaclePartner<2>>(obstacle, step.balanced));
  driven_bodies.resize(state.bodies.size());
  for (const Body<2> &body : state.bodies)
    if (body.rigid.driven)
      driven_bodies[body.index] =
          std::make_unique<DrivenBodyPartner>(work.drive[body.index], state.balance.driven_work);
}

RigidPartner<2> *PlanePartners::of(const ContactRow<2> &row) const
{
  return row.wall != PartnerNumbers::none      ? numbered[row.wall].get()
         : row.partner != PartnerNumbers::none ? driven_bodies[row.partner].get()
                                               : nullptr;
}

void PlanePartners::book_means(std::vector<DrivenWork> &works) const
{
  for (std::size_t n = n_walls; n < numbered.size(); ++n)
    numbered[n]->book_mean(works);
  for (std::size_t n = 0; n < n_walls; ++n)
    numbered[n]->book_mean(works);
}

double PlanePartners::book_loads() const
{
  double lost = 0.;
  for (const std::unique_ptr<RigidPartner<2>> &partner : numbered)
    lost += partner->book_load();
  return lost;
}

void PlanePartners::go_on() const
{
  for (const std::unique_ptr<RigidPartner<2>> &partner : numbered)
    partner->go_on();
}

std::string partner_in_words(const State &state, const unsigned int number, const unsigned int body)
{
  if (number == PartnerNumbers::none)
    return "body '" + state.bodies[body].name;
  const unsigned int o = PartnerNumbers(state.walls.size()).obstacle(number);
  return o == PartnerNumbers::none ? "wall '" + state.walls[number].description.name
                                   : "obstacle '" + state.obstacles[o].description.name;
}
} // namespace softgrain::mpm
