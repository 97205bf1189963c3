// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/parameters/parameter_tree.h>
#include <softgrain/scene/obstacle_drive.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <memory>
#include <vector>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::ObstacleDrive)

namespace softgrain
{
namespace
{
/// Nothing that an obstacle meets moves it.
class ToldObstacle final : public ObstacleDrive
{
public:
  void declare_parameters(dealii::ParameterHandler &) const override {}
  void parse_parameters(const dealii::ParameterHandler &, const std::string &) override {}
  bool is_free() const override { return false; }
};

[[maybe_unused]] const bool registered =
    Registry<ObstacleDrive>::instance().add("told",
                                            "it goes where 'Displacement' and 'Angle' say, whatever it meets",
                                            [] { return std::make_unique<ToldObstacle>(); });

std::vector<ParameterEntry> parameters_of(const std::string &drive)
{
  dealii::ParameterHandler own;
  Registry<ObstacleDrive>::instance().create(drive)->declare_parameters(own);
  return parameter_tree(own).entries;
}
} // namespace

void declare_obstacle_drive(dealii::ParameterHandler &prm)
{
  const Registry<ObstacleDrive> &drives = Registry<ObstacleDrive>::instance();
  prm.declare_entry("Drive", "told", dealii::Patterns::Selection(drives.choice()), drives.choice_in_words());
  for (const std::string &drive : drives.names())
    drives.create(drive)->declare_parameters(prm);
}

std::shared_ptr<const ObstacleDrive> parse_obstacle_drive(const dealii::ParameterHandler &prm,
                                                          const std::string &obstacle)
{
  const Registry<ObstacleDrive> &drives = Registry<ObstacleDrive>::instance();
  const std::string chosen = prm.get("Drive");
  const std::vector<ParameterEntry> own = parameters_of(chosen);
  for (const std::string &other : drives.names())
    for (const ParameterEntry &entry : parameters_of(other))
      if (prm.get(entry.name) != entry.default_value &&
          std::none_of(own.begin(), own.end(),
                       [&entry](const ParameterEntry &mine) { return mine.name == entry.name; }))
        throw InputError("'" + obstacle + "/" + entry.name + "' = '" + prm.get(entry.name) +
                         "' has no effect with 'Drive' = '" + chosen + "': leave it out, or choose '" +
                         other + "'");
  std::shared_ptr<ObstacleDrive> drive = drives.create(chosen);
  drive->parse_parameters(prm, obstacle);
  return drive;
}
} // namespace softgrain
