// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_mpm_model_space_model_h
#define softgrain_mpm_model_space_model_h

#include <softgrain/driving/step_control.h>
#include <softgrain/geometry/solid.h>
#include <softgrain/model/model.h>
#include <softgrain/mpm/body/solid_builder.h>
#include <softgrain/mpm/stepping/pressed_body.h>
#include <softgrain/scene/scene.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace softgrain::mpm
{
/**
 * @brief The material point model of a scene in space, as far as it goes: one elastic body at rest between
 * flat walls that are told how to move.
 *
 * Every state is in balance, so there is nothing to settle, and works of walls are those of the mean of their
 * forces at both ends of a step.
 */
class SpaceModel final : public Model<3>
{
public:
  /// @throw InputError when the body reaches out of the mesh
  SpaceModel(const Scene<3> &scene,
             const Settings &settings,
             std::shared_ptr<const constitutive::Law<3>> law);

  std::string name() const override { return "mpm"; }
  StepReport advance(double dt_limit) override;
  void take_drives(const std::vector<std::shared_ptr<const WallDrive>> &drives) override;
  double time() const override { return now; }
  std::size_t step() const override { return steps; }
  Snapshot<3> snapshot() const override;
  std::vector<WallState<3>> walls() const override;
  Energies energies() const override;
  double energy_of_rounding() const override;
  double solid_area() const override;
  double coordination() const override;
  double momentum_error() const override { return 0.; }
  std::size_t n_points() const override { return body.n_points; }
  std::size_t n_bodies() const override { return 1; }
  SizeReport size_report() const override;
  std::vector<std::pair<std::string, double>> works() const override;
  std::map<std::string, double> phases() const override { return {{"steps", seconds}}; }
  void save(StateWriter &out) const override;
  void load(StateReader &in) override;

private:
  /// A wall on its way.
  struct DrivenWall
  {
    WallDescription<3> description;
    double travel = 0.;                          ///< along the normal since the start [m]
    double speed = 0.;                           ///< mean over the last step [m/s]
    double work = 0.;                            ///< done on the body since the start [J]
    double force = 0.;                           ///< on the body along the normal [N]
    double drive_begin = 0., travel_before = 0.; ///< when it was last driven otherwise, and how far it was

    dealii::Point<3> point() const { return description.point + travel * description.normal; }
    double velocity(double time, double dt) const;
  };
  using Pressed = PressedBody<3>;

  double wanted_step() const;
  /// One step. @return why it is no good
  std::string try_step(double dt, StepReport &report);
  Pressed::FlatWall flat(const DrivenWall &wall) const;
  BodyState<3> body_state() const;
  /// Of all walls.
  std::size_t n_places() const;

  const Settings settings;
  const BodyDescription<3> description;
  const std::unique_ptr<ShapeFunction> function;
  const Lattice<3> lattice;
  const TriangulatedSurface surface; ///< for pictures, in the configuration of the grid [m]
  const std::vector<std::vector<dealii::Point<3>>> places; ///< of the surface, that walls may meet [m]
  PointStore<3> store;
  Body<3> body;
  Pressed pressed;
  std::vector<DrivenWall> driven;
  StepControl step_control{1.5};
  double now = 0.; ///< [s]
  std::size_t steps = 0;
  double seconds = 0.; ///< spent in steps
};
} // namespace softgrain::mpm

#endif
