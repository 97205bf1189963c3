// SPDX-License-Identifier: LGPL-2.1-or-later
// Files of every kind that softgrain reads, with random damage: each is read, or refused by an InputError of
// one line, or of some that are one mistake each; nothing else is thrown, nothing crashes or hangs (most to
// say under sanitizers). An argument gives the number of inputs.
#include <softgrain/app/input.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/base/mistakes.h>
#include <softgrain/base/registry.h>
#include <softgrain/bpm/aggregate_library.h>
#include <softgrain/contact/problem_io.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/field_writer.h>
#include <softgrain/output/history.h>
#include <softgrain/packing/packing.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>
#include <sstream>

using namespace softgrain;

namespace
{
/// Seconds after which an input counts as a hang; the signal then ends the program.
constexpr unsigned int limit = 60;

/// Generator and choices that are the same on every platform.
class Chance
{
public:
  std::size_t below(const std::size_t n) { return n == 0 ? 0 : generator() % n; }

private:
  std::mt19937_64 generator{7};
};

std::string mutated(std::string text, Chance &chance)
{
  static const std::vector<std::string> pieces = {"set ",   "subsection ", "end\n",
                                                  "=",      "\n",          "#",
                                                  "\\\n",   "include x\n", "-1",
                                                  "1e-308", "1e999",       "nan",
                                                  "inf",    "0",           ",",
                                                  ";",      "\"",          "{",
                                                  "[",      "\r\n",        "\xEF\xBB\xBF",
                                                  "\xFF",   "/",           "(",
                                                  ")",      "pi",          "99999999999999999999",
                                                  "<",      "-0x1",        "4294967295"};
  for (std::size_t n = 1 + chance.below(4); n > 0; --n)
  {
    const std::size_t at = chance.below(text.size()),
                      length = std::min(text.size() - at, 1 + chance.below(40));
    switch (chance.below(6))
    {
    case 0:
      if (!text.empty())
        text[at] = static_cast<char>(text[at] ^ (1 << chance.below(8)));
      break;
    case 1:
      text.erase(at, length);
      break;
    case 2:
      text.insert(at, pieces[chance.below(pieces.size())]);
      break;
    case 3:
      text.insert(chance.below(text.size()), text.substr(at, length));
      break;
    case 4:
      text.replace(at, length, pieces[chance.below(pieces.size())]);
      break;
    default:
      if (chance.below(8) == 0)
        text.resize(at);
    }
  }
  return text;
}

std::string content(const std::string &path)
{
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void put(const std::string &path, const std::string &text)
{
  std::ofstream(path, std::ios::binary) << text;
}

void read_parameters(const std::string &path)
{
  const ParameterFile file(path);
  const SceneNames names{file.names("Materials"), file.names("Bodies"), file.names("Walls"),
                         file.names("Stages"), file.names("Obstacles")};
  const std::vector<std::string> models = Registry<ModelFactory>::instance().names();
  const std::string model = file.value({}, "Model", "mpm");
  dealii::ParameterHandler prm;
  declare_all_parameters(prm, std::count(models.begin(), models.end(), model) > 0 ? model : "mpm", names,
                         file.value({}, "Dimension", "2") == "3" ? 3 : 2);
  file.apply(prm);
}

/// One kind of input: a good one, and who reads a file like it.
struct Kind
{
  std::string name, good, file;
  std::function<void(const std::string &file)> read;
  double share;           ///< of all inputs
  std::size_t inputs = 0; ///< looked at so far
  std::size_t refused = 0;
};

/// Why a message is not one clear line; empty when it is.
std::string unclear(const std::string &message)
{
  if (message.empty() || message.size() > 5000)
    return "a message of " + std::to_string(message.size()) + " characters";
  if (message.find('\n') != std::string::npos) // other control characters are replaced when it is printed
    return "not one line: " + message;
  return "";
}

class Mutations
{
public:
  /// Damages the input @p n times and reads it.
  void run(Kind &kind, const std::size_t n)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::string bad = mutated(kind.good, chance);
      put(kind.file, bad);
      std::string complaint;
      alarm(limit);
      try
      {
        kind.read(kind.file);
      }
      catch (const InputErrors &errors)
      {
        ++kind.refused;
        for (const std::string &line : errors.lines())
          complaint += unclear(line);
        if (errors.lines().empty() || errors.lines().size() > 11)
          complaint = std::to_string(errors.lines().size()) + " lines";
      }
      catch (const InputError &error)
      {
        ++kind.refused;
        complaint = unclear(error.what());
      }
      catch (const std::exception &error)
      {
        complaint = std::string("no InputError: ") + error.what();
      }
      alarm(0);
      if (complaint.empty())
        continue;
      put("wrong-" + kind.name + "-" + std::to_string(wrong++), bad);
      std::cout << kind.name << ": " << complaint << '\n';
    }
    kind.inputs += n;
  }

  std::size_t wrong = 0; ///< inputs that were neither read nor clearly refused

private:
  Chance chance;
};

std::vector<Kind> parameter_files()
{
  std::vector<Kind> kinds;
  std::vector<std::string> shipped;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(SOFTGRAIN_SOURCE_DIR "/parameters"))
    if (entry.path().extension() == ".prm" && entry.path().parent_path().filename() != "studies") // no scenes
      shipped.push_back(entry.path());
  std::sort(shipped.begin(), shipped.end());
  for (const std::string &path : shipped)
  {
    const std::filesystem::path name = std::filesystem::path(path).filename();
    // Some include others, which then lie beside them.
    std::filesystem::copy_file(path, name, std::filesystem::copy_options::overwrite_existing);
    kinds.push_back({name, content(path), "bad.prm", read_parameters, 0.3 / shipped.size()});
  }
  kinds.push_back(
      {"json",
       R"({"Model": "bpm", "Materials": {"Names": ["a", "b"], "a": {"Density": 1e3}}, "Loads": {"Gravity": [0, -9.8]}})",
       "bad.json", read_parameters, 0.1});
  kinds.push_back({"formula", "t < 0.01 ? 5*t^2 : min(0.05, sin(2*pi*50*t))", "bad.txt",
                   [](const std::string &file)
                   {
                     std::string line = content(file); // a formula is what stands in one
                     std::replace(line.begin(), line.end(), '\n', ' ');
                     Expression(line, {"t"})({1.});
                   },
                   0.15});
  return kinds;
}

std::vector<Kind> tables()
{
  return {{"packing", "x_m,y_m,radius_m\n0.1,0.2,1e-3\n-3,4.5,2e-3\n", "bad.csv", read_packing<2>, 0.1},
          {"packing with materials", "x_m,y_m,radius_m,material\n0.1,0.2,1e-3,gel\n-3,4.5,2e-3,stone\n",
           "bad.csv", read_packing<2>, 0.05},
          {"library", "key,x_m,y_m,radius_m\n00ff,1e-3,2e-3,1e-4\n00ff,-1e-3,2.5e-3,2e-4\n", "bad.csv",
           [](const std::string &file) { bpm::AggregateLibrary library(file); }, 0.05},
          {"history", "time_s,step,dt_s\n0,0,0\n0.1,1,0.1\n0.2,2,0.1\n", "history.csv",
           [](const std::string &) { HistoryWriter(".").resume(1); }, 0.03},
          {"pictures",
           "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\"><Collection>\n"
           "<DataSet timestep=\"0.1\" name=\"points\" file=\"fields/points_000000.vtu\"/>\n"
           "</Collection></VTKFile>\n",
           "fields.pvd", [](const std::string &) { FieldWriter(".", {}).resume(1.); }, 0.02}};
}

std::vector<Kind> contact_problems()
{
  const std::string head = "2\n1\n", tail = "0.1\n-1\n0.5\n";
  const auto kind = [&](const std::string &name, const std::string &matrix) {
    return Kind{name, head + matrix + tail, "bad.dat", contact::load_siconos_problem, 0.04};
  };
  return {
      kind("dense", "0\n2\n2\n2\t2\n4\n1\n1\n3\n"),
      kind("blocks", "1\n2\n2\n1\n1\n1\n2\n2\n2\n1\n0 1\n0\n0\n4 1 1 3\n"),
      kind("triplets",
           "2\n2\n2\n1\nCSparse Version 3\ntriplet: 2-by-2, nzmax: 4 nnz: 3\n0 0 : 4\n1 1 : 3\n1 1 : 1\n"),
      kind("columns",
           "2\n2\n2\n2\nCSparse Version 3\n2-by-2, nzmax: 2 nnz: 2, 1-norm: 4\n    col 0 : locations 0 to "
           "0\n 0 : 4\n    col 1 : locations 1 to 1\n 1 : 3\n")};
}

std::vector<Kind> checkpoints()
{
  CheckpointWriter writer("good.h5");
  writer.write("numbers", std::vector<double>(100, 1.5));
  writer.write("steps", std::vector<std::uint64_t>(10, 3));
  writer.write("texts/name", std::string("disk"));
  writer.commit();
  return {{"checkpoint", content("good.h5"), "bad.h5",
           [](const std::string &file)
           {
             const CheckpointReader reader(file);
             reader.read_doubles("numbers", ListSize::rows_of(1));
             reader.read_integers("steps", ListSize::rows_of(1));
             reader.read_text("texts/name");
           },
           0.15}};
}
} // namespace

int main(const int argc, char **argv)
{
  const double n = argc > 1 ? std::stod(argv[1]) : 3000;
  std::vector<Kind> all;
  for (const auto &kinds : {parameter_files(), tables(), contact_problems(), checkpoints()})
    all.insert(all.end(), kinds.begin(), kinds.end());
  for (const Kind &kind : all)
  {
    put(kind.file, kind.good);
    kind.read(kind.file); // or the test shows nothing
  }
  // Every kind in every round, so that a run that is ended has seen all of them.
  Mutations mutations;
  constexpr unsigned int rounds = 20;
  const auto begin = std::chrono::steady_clock::now();
  for (unsigned int round = 1; round <= rounds; ++round)
  {
    std::size_t inputs = 0, refused = 0;
    for (Kind &kind : all)
    {
      put(kind.file, kind.good); // some readers look at more files than one
      mutations.run(kind, static_cast<std::size_t>(n * kind.share * round / rounds) + 1 - kind.inputs);
      inputs += kind.inputs;
      refused += kind.refused;
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    std::cerr << "after " << inputs << " inputs " << refused << " refused, " << mutations.wrong
              << " neither read nor clearly refused, " << time.count() << " s\n";
  }
  for (const Kind &kind : all)
    if (kind.refused < kind.inputs / 10)
      std::cout << kind.name << ": only " << kind.refused << " of " << kind.inputs << " refused\n";
  std::cout << "inputs neither read nor clearly refused: " << mutations.wrong << '\n';
}
