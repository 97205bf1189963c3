// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_model_model_facts_h
#define softgrain_model_model_facts_h

#include <softgrain/analysis/snapshot.h>
#include <softgrain/base/rank_times.h>

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace softgrain
{
/// A line of `softgrain check` and of the log's head: name and value with unit.
using SizeReport = std::vector<std::pair<std::string, std::string>>;

/**
 * @brief What a model tells of its state and of its work in numbers: what logs, histories and summaries are
 * made of. Units are those of space; in the plane all is per metre of thickness.
 */
class ModelFacts
{
public:
  virtual ~ModelFacts() = default;

  virtual double time() const = 0; ///< [s]
  virtual std::size_t step() const = 0;

  /// What working with other processes has taken so far.
  virtual RankTimes rank_times() const { return {}; }

  /// Largest |force on a wall - its load| over its load, of the walls that are free to move; 0 without any.
  virtual double unbalanced_walls() const { return 0.; }
  /// May cost a pass over the points.
  virtual Energies energies() const = 0;
  /// What rounding alone can make of energies [J/m]; no balance is formed of energies that are not above it.
  virtual double energy_of_rounding() const { return 0.; }

  /// Sum of the areas, in space of the volumes, that the bodies enclose now [m^dim], for the packing
  /// fraction.
  virtual double solid_area() const = 0;
  /// Mean number of bodies and walls a body touches.
  virtual double coordination() const = 0;
  /// |momentum - (initial momentum + impulses of walls and body forces)| over the largest momentum term;
  /// rounding only. No number while no momentum was above what rounding makes.
  virtual double momentum_error() const = 0;

  virtual std::size_t n_points() const = 0; ///< material points or primaries
  virtual std::size_t n_bodies() const = 0;

  /// Sizes, CFL step, ratio of the time step to it, estimate of cost: printed before step 0.
  virtual SizeReport size_report() const = 0;
  /// What was done on the bodies since the start, by whom [J/m]: columns of history.csv. Their sum is
  /// external_work of energies().
  virtual std::vector<std::pair<std::string, double>> works() const { return {}; }
  /// Names of the columns that this model adds to history.csv, and their values.
  virtual std::vector<std::pair<std::string, double>> extra_history() const { return {}; }
  /// Seconds spent per phase since the start.
  virtual std::map<std::string, double> phases() const = 0;
};
} // namespace softgrain

#endif
