// SPDX-License-Identifier: LGPL-2.1-or-later
// A checkpoint that is not finished leaves the old one; damage anywhere in a file is found before anything is
// read; missing names and other versions are named.
#include <softgrain/base/config.h>
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>
#include <softgrain/output/hdf5_writer.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>

using namespace softgrain;

namespace
{
void write_state(const std::string &path, const double value, const bool finish)
{
  CheckpointWriter writer(path);
  writer.write("numbers", std::vector<double>(500, value));
  writer.write("step", std::vector<std::uint64_t>{7});
  writer.write("name", std::string("disk"));
  if (finish)
    writer.commit();
}

template <typename Action>
void expect_error(const Action &action)
{
  try
  {
    action();
    std::cout << "NO ERROR\n";
  }
  catch (const InputError &error)
  {
    std::string text = error.what();
    const std::size_t version = text.find(SOFTGRAIN_VERSION);
    if (version != std::string::npos)
      text.replace(version, std::string(SOFTGRAIN_VERSION).size(), "VERSION");
    std::cout << text << '\n';
  }
}

std::string content(const std::string &path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void put(const std::string &path, const std::string &bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

bool refused(const std::string &path)
{
  try
  {
    const CheckpointReader reader(path);
    return false;
  }
  catch (const InputError &)
  {
    return true;
  }
}

/// As versions before wrote them: @p sealed not until format 4.
void write_of_format(const std::string &path, const std::string &format, const bool sealed)
{
  Hdf5Writer file(path);
  file.write("numbers", std::vector<double>{1.5});
  file.write_attribute("/", "format", format);
  file.close(sealed);
}
} // namespace

int main()
{
  const std::string path = checkpoint_path("run", 1);
  write_state(path, 1.5, true);
  write_state(path, 2.5, false);
  std::cout << "after an unfinished write: "
            << CheckpointReader(path).read_doubles("numbers", ListSize::rows_of(1))[0] << ", files: "
            << std::distance(std::filesystem::directory_iterator("run"),
                             std::filesystem::directory_iterator())
            << '\n';

  expect_error([] { CheckpointReader("run/state-000000009.h5"); });
  expect_error([&] { CheckpointReader(path).read_doubles("mpm/mass", ListSize::rows_of(1)); });
  expect_error([&] { CheckpointReader(path).read_doubles("step", ListSize::rows_of(1)); });
  expect_error([&] { CheckpointReader(path).read_text("numbers"); });
  // Who reads says how many numbers there must be.
  expect_error([&] { CheckpointReader(path).read_doubles("numbers", 7); });
  expect_error([&] { CheckpointReader(path).read_rows("numbers", 7, 3, [](auto, auto, auto) {}); });

  const std::string good = content(path);
  unsigned int n_damaged = 0, n_cut = 0, n_refused = 0;
  for (std::size_t at = 0; at < good.size(); at += 13, ++n_damaged)
  {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x24);
    put("damaged.h5", bad);
    n_refused += refused("damaged.h5");
  }
  std::cout << "damaged bytes accepted: " << n_damaged - n_refused << '\n';
  n_refused = 0;
  for (std::size_t size = 0; size < good.size(); size += 97, ++n_cut)
  {
    put("damaged.h5", good.substr(0, size));
    n_refused += refused("damaged.h5");
  }
  std::cout << "cut files accepted: " << n_cut - n_refused << '\n';
  put("damaged.h5", good + "more");
  expect_error([] { CheckpointReader("damaged.h5"); });
  put("foreign.h5", "a letter");
  expect_error([] { CheckpointReader("foreign.h5"); });
  write_of_format("older.h5", "softgrain checkpoint 3", false);
  expect_error([] { CheckpointReader("older.h5"); });
  write_of_format("newer.h5", "softgrain checkpoint 12", true);
  expect_error([] { CheckpointReader("newer.h5"); });
  write_of_format("other.h5", "snapshots", true);
  expect_error([] { CheckpointReader("other.h5"); });

  // The newest one is spoilt: the one before is taken.
  write_state(checkpoint_path("run", 20), 1.5, true);
  put(checkpoint_path("run", 300), good.substr(0, good.size() / 2));
  std::cout << "latest: " << latest_checkpoint("run") << '\n';
  remove_old_checkpoints("run", 2);
  std::cout << "kept 1, 20, 300: " << std::filesystem::exists(path)
            << std::filesystem::exists(checkpoint_path("run", 20))
            << std::filesystem::exists(checkpoint_path("run", 300)) << '\n';
  std::filesystem::create_directory("empty");
  expect_error([] { latest_checkpoint("empty"); });
}
