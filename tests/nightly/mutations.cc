// SPDX-License-Identifier: LGPL-2.1-or-later
// Shipped parameter files, a packing, formulas and a checkpoint with random damage: each is read, or refused
// by an InputError of one line; nothing else is thrown, and nothing crashes (most to say under sanitizers).
#include <softgrain/app/input.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/base/expression.h>
#include <softgrain/base/registry.h>
#include <softgrain/model/model_factory.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/packing/packing.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

using namespace softgrain;

namespace
{
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
                                                  ")",      "pi",          "99999999999999999999"};
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
  declare_all_parameters(prm, std::count(models.begin(), models.end(), model) > 0 ? model : "mpm", names);
  file.apply(prm);
}

/// Damages a text @p n times and reads it; returns how often it was neither taken nor clearly refused.
template <typename Read>
unsigned int n_wrong(
    const std::string &what, const std::string &good, const unsigned int n, Chance &chance, const Read &read)
{
  unsigned int wrong = 0, refused = 0;
  for (unsigned int i = 0; i < n; ++i)
  {
    const std::string bad = mutated(good, chance);
    std::string complaint;
    try
    {
      read(bad);
    }
    catch (const InputError &error)
    {
      ++refused;
      const std::string message = error.what();
      if (message.empty() || message.size() > 5000)
        complaint = "a message of " + std::to_string(message.size()) + " characters";
    }
    catch (const std::exception &error)
    {
      complaint = error.what();
    }
    if (complaint.empty())
      continue;
    put("wrong-" + what + "-" + std::to_string(wrong++), bad);
    std::cout << what << ": " << complaint << '\n';
  }
  if (refused < n / 10)
    std::cout << what << ": only " << refused << " of " << n << " refused\n";
  return wrong;
}
} // namespace

int main(const int argc, char **argv)
{
  // With an argument as many files as one has time for; ctest gives none.
  const unsigned int n = argc > 1 ? std::stoul(argv[1]) : 3000;
  Chance chance;
  unsigned int wrong = 0;
  std::vector<std::string> shipped;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(SOFTGRAIN_SOURCE_DIR "/parameters"))
    if (entry.path().extension() == ".prm")
      shipped.push_back(entry.path());
  std::sort(shipped.begin(), shipped.end());
  for (const std::string &path : shipped)
    wrong += n_wrong(std::filesystem::path(path).filename(), content(path), n / shipped.size(), chance,
                     [](const std::string &bad)
                     {
                       put("bad.prm", bad);
                       read_parameters("bad.prm");
                     });
  wrong += n_wrong(
      "json",
      R"({"Model": "bpm", "Materials": {"Names": ["a", "b"], "a": {"Density": 1e3}}, "Loads": {"Gravity": [0, -9.8]}})",
      n, chance,
      [](const std::string &bad)
      {
        put("bad.json", bad);
        read_parameters("bad.json");
      });
  wrong += n_wrong("packing", "x_m,y_m,radius_m\n0.1,0.2,1e-3\n-3,4.5,2e-3\n", n, chance,
                   [](const std::string &bad)
                   {
                     put("bad.csv", bad);
                     read_packing("bad.csv");
                   });
  wrong += n_wrong("formula", "t < 0.01 ? 5*t^2 : min(0.05, sin(2*pi*50*t))", 10 * n, chance,
                   [](const std::string &bad) { Expression(bad, {"t"})({1.}); });
  {
    CheckpointWriter writer("good.h5");
    writer.write("numbers", std::vector<double>(100, 1.5));
    writer.write("texts/name", std::string("disk"));
    writer.commit();
  }
  wrong += n_wrong("checkpoint", content("good.h5"), n, chance,
                   [](const std::string &bad)
                   {
                     put("bad.h5", bad);
                     const CheckpointReader reader("bad.h5");
                     reader.read_doubles("numbers");
                     reader.read_text("texts/name");
                   });
  std::cout << "inputs neither read nor clearly refused: " << wrong << '\n';
}
