// SPDX-License-Identifier: LGPL-2.1-or-later
// The list of pictures, fields.pvd, and which of them are there.
#include <softgrain/base/exceptions.h>
#include <softgrain/output/atomic_file.h>
#include <softgrain/output/field_writer.h>
#include <softgrain/output/series.h>

#include <boost/property_tree/xml_parser.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace softgrain
{
namespace
{
/// Beginnings of the names of files, and their end.
const std::vector<std::string> prefixes = {"points-", "outlines-", "contacts-", "walls-", "obstacles-"};
const std::string suffix = ".vtu";
} // namespace

void FieldWriter::resume(const double time)
{
  frames.clear();
  const std::string path = directory + "/fields.pvd";
  if (!std::filesystem::exists(path))
    return;
  try
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(path, tree);
    for (const auto &[tag, item] : tree.get_child("VTKFile.Collection"))
      if (tag == "DataSet")
      {
        const double frame_time = item.get<double>("<xmlattr>.timestep");
        if (frames.empty() || frames.back().time != frame_time)
          frames.push_back({frame_time, {}});
        frames.back().parts.emplace_back(item.get<std::string>("<xmlattr>.name"),
                                         item.get<std::string>("<xmlattr>.file"));
      }
  }
  catch (const boost::property_tree::ptree_error &error)
  {
    throw InputError(path + " is not a series of pictures to go on with: " + error.what());
  }
  while (!frames.empty() && frames.back().time > time)
    frames.pop_back();
}

void FieldWriter::write_index()
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n<Collection>\n";
  for (const Frame &frame : frames)
    for (std::size_t part = 0; part < frame.parts.size(); ++part)
      text += "<DataSet timestep=\"" + exact_text(frame.time) + "\" part=\"" + std::to_string(part) +
              "\" name=\"" + frame.parts[part].first + "\" file=\"" + frame.parts[part].second + "\"/>\n";
  // A failure of power may take the newest pictures, but never the index of all.
  AtomicFile file(directory + "/fields.pvd");
  file.write(text + "</Collection>\n</VTKFile>\n");
  file.sync();
  file.commit(late);
}

void FieldWriter::remove_stale_files() const
{
  std::set<std::string> kept;
  for (const Frame &frame : frames)
    for (const auto &part : frame.parts)
      kept.insert(std::filesystem::path(part.second).filename());
  remove_series_files(directory + "/fields", prefixes, suffix, kept);
}

void remove_pictures(const std::string &directory)
{
  remove_series(directory + "/fields.pvd", directory + "/fields", prefixes, suffix);
}
} // namespace softgrain
