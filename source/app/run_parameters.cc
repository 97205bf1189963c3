// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/analysis/measure.h>
#include <softgrain/app/run_parameters.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/nearest_name.h>
#include <softgrain/parameters/within_section.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>

namespace softgrain
{
namespace
{
const std::string all_parts = "points, outlines, contacts, walls, deformation gradient, extra fields";

/// Names of all measures, with the word for all of them.
template <int dim>
std::string measures_to_choose()
{
  std::string choice = "all";
  for (const std::string &name : Registry<MeasureIn<dim>>::instance().names())
    choice += "|" + name;
  return choice;
}

void declare_output(dealii::ParameterHandler &prm, const unsigned int dimension)
{
  using namespace dealii::Patterns;
  prm.enter_subsection("Output");
  prm.declare_entry(
      "Fields every", "0", Double(0),
      "Simulated time between pictures (fields.pvd); 0: see 'Number of field outputs'. Units: s.");
  prm.declare_entry("Number of field outputs", "0", Integer(0),
                    "Number of pictures spread evenly over Stop/End time, besides that of the start; used "
                    "when 'Fields every' is 0. Units: none.");
  prm.declare_entry("Field parts", all_parts,
                    MultipleSelection("points|outlines|contacts|walls|deformation gradient|extra fields"),
                    "What the pictures contain. Units: none.");
  prm.declare_entry("Snapshots every", "0", Double(0),
                    "Simulated time between entries of snapshots.h5, for analysis; 0: none. Units: s.");
  prm.declare_entry("Points in snapshots", "true", Bool(),
                    "Whether snapshots.h5 contains the points. Units: none.");
  prm.declare_entry("Measures", "",
                    MultipleSelection(dimension == 3 ? measures_to_choose<3>() : measures_to_choose<2>()),
                    "Measures written to measures.csv with every snapshot; doc/measures.md says what each "
                    "one is. Units: none.");
  prm.declare_entry("Compression level", "1", Integer(0, 9),
                    "Compression of pictures and snapshots by zlib: 0 none, 9 most. Units: none.");
  prm.declare_entry("History every", "1", Integer(1),
                    "Number of steps between rows of history.csv. Units: steps.");
  prm.declare_entry(
      "Forces on", "", Anything(),
      "Columns of history.csv with force and torque by contact on a body, a wall or an obstacle: "
      "'NAME' from all that touch it, 'NAME / PARTNER' from one; several with commas between. "
      "Units: none.");
  prm.declare_entry("Checkpoint every", "10", Double(0),
                    "Wall time between checkpoints; 0: only at the end. Units: min.");
  prm.declare_entry("Checkpoints kept", "2", Integer(1),
                    "Number of checkpoints that are kept; older ones are removed. Units: none.");
  prm.leave_subsection();
}
} // namespace

void RunParameters::declare_parameters(dealii::ParameterHandler &prm,
                                       const std::vector<std::string> &models,
                                       const unsigned int dimension)
{
  using namespace dealii::Patterns;
  std::string choice;
  for (const std::string &name : models)
    choice += (choice.empty() ? "" : "|") + name;
  const bool has_mpm = std::find(models.begin(), models.end(), "mpm") != models.end();
  prm.declare_entry("Model", has_mpm || models.empty() ? (models.empty() ? "" : "mpm") : models.front(),
                    Selection(choice),
                    "How the bodies are computed: mpm, material points; bpm, bonded particles. Units: none.");
  prm.declare_entry(
      "Dimension", "2", Integer(2, 3),
      "2: bodies lie in the plane, and all is per metre of thickness; 3: they are in space, where "
      "few scenes can be computed so far (doc/three-dimensions.md). Units: none.");
  prm.declare_entry("Fidelity", "standard", Selection("draft|standard|reference"),
                    "What the parameters on which accuracy and cost depend most are set to where this file "
                    "does not set them: cells and steps (doc/results/trade.md). Units: none.");
  prm.declare_entry(
      "Output directory", "", Anything(),
      "Folder for the results; empty: output/NAME, where NAME.prm is the parameter file. Units: none.");
  prm.declare_entry("Additional shared libraries", "", List(Anything()),
                    "Libraries with laws and other parts of your own. Units: none.");
  prm.declare_entry("Threads", "0", Integer(0), "Number of threads; 0: one per core. Units: none.");
  declare_output(prm, dimension);
}

void RunParameters::parse_parameters(dealii::ParameterHandler &prm,
                                     const std::string &file_name,
                                     const double end_time)
{
  model = prm.get("Model");
  output_directory = prm.get("Output directory");
  if (output_directory.empty())
    output_directory = (std::filesystem::path("output") / std::filesystem::path(file_name).stem()).string();
  libraries = dealii::Utilities::split_string_list(prm.get("Additional shared libraries"));
  threads = prm.get_integer("Threads");

  const WithinSection section(prm, "Output");
  fields_every = prm.get_double("Fields every");
  const unsigned int n_field_outputs = prm.get_integer("Number of field outputs");
  const std::vector<std::string> parts = dealii::Utilities::split_string_list(prm.get("Field parts"));
  snapshots_every = prm.get_double("Snapshots every");
  snapshots.points = prm.get_bool("Points in snapshots");
  measures = dealii::Utilities::split_string_list(prm.get("Measures"));
  if (!measures.empty() && snapshots_every == 0)
    throw InputError("'Output/Measures' = '" + prm.get("Measures") +
                     "' needs 'Output/Snapshots every': measures are taken with the snapshots");
  fields.compression_level = snapshots.compression_level = prm.get_integer("Compression level");
  history_every = prm.get_integer("History every");
  loads = parse_load_wishes(prm.get("Forces on"));
  checkpoint_minutes = prm.get_double("Checkpoint every");
  checkpoints_kept = prm.get_integer("Checkpoints kept");

  const auto shows = [&parts](const std::string &part)
  { return std::find(parts.begin(), parts.end(), part) != parts.end(); };
  fields.points = shows("points");
  fields.outlines = shows("outlines");
  fields.contacts = shows("contacts");
  fields.walls = shows("walls");
  fields.deformation_gradient = shows("deformation gradient");
  fields.extra_fields = shows("extra fields");

  if (fields_every == 0 && n_field_outputs > 0)
  {
    if (!(end_time > 0))
      throw InputError("'Output/Number of field outputs' = '" + std::to_string(n_field_outputs) +
                       "' needs 'Stop/End time'; set 'Output/Fields every' instead");
    fields_every = end_time / n_field_outputs;
  }
}
} // namespace softgrain
