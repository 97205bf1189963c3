// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_driving_stages_h
#define softgrain_driving_stages_h

#include <softgrain/base/exceptions.h>
#include <softgrain/driving/stop_condition.h>
#include <softgrain/scene/scene.h>

#include <memory>
#include <string>
#include <vector>

namespace softgrain
{
/// A part of a run: how walls are driven in it, and when it ends.
struct Stage
{
  std::string name;
  std::vector<std::shared_ptr<const WallDrive>> drives; ///< one per wall; null: it goes on as before
  std::vector<std::string> drive_names;
  StopConditions stop; ///< its times and strains count from where the stage begins
};

/// Section `Stages`: one subsection per name, one stage after the other.
class Stages
{
public:
  /// @param names of the stages, in their order, @param walls names of the walls
  static void declare_parameters(dealii::ParameterHandler &prm,
                                 const std::vector<std::string> &names,
                                 const std::vector<std::string> &walls);

  /// @param run the stop conditions of the whole run: the last stage may end with them
  /// @throw InputError when a stage would never end
  void parse_parameters(dealii::ParameterHandler &prm,
                        const std::vector<std::string> &names,
                        const std::vector<std::string> &walls,
                        const StopConditions &run);

  /// Calls check(scene) for the scene of every stage. @throw InputError as it does
  template <int dim, typename Check>
  void check(const Scene<dim> &scene, const Check &check) const
  {
    Scene<dim> here = scene;
    for (const Stage &stage : list)
    {
      for (std::size_t w = 0; w < here.walls.size(); ++w)
        if (stage.drives[w])
        {
          here.walls[w].drive = stage.drives[w];
          here.walls[w].drive_name = stage.drive_names[w];
        }
      try
      {
        if constexpr (dim == 2)
          stage.stop.check(here);
        else
          stage.stop.check_in_space(here);
        check(here);
      }
      catch (const InputError &error)
      {
        std::vector<std::string> walls;
        for (const WallDescription<dim> &wall : here.walls)
          walls.push_back(wall.name);
        throw InputError(as_said_in(stage, walls, error.what()));
      }
    }
  }

  /// The end of the last stage if the ends of all are known beforehand [s]; 0: not known.
  double end_time() const;

  bool empty() const { return list.empty(); }
  std::size_t size() const { return list.size(); }
  const Stage &operator[](const std::size_t n) const { return list[n]; }

private:
  /// @p message with the parameters of the stage in place of those of the run.
  static std::string
  as_said_in(const Stage &stage, const std::vector<std::string> &walls, std::string message);

  std::vector<Stage> list;
};
} // namespace softgrain

#endif
