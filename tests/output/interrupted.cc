// SPDX-License-Identifier: LGPL-2.1-or-later
// A checkpoint that is not finished leaves the old one; damage anywhere in a file is found before anything is
// read; missing names are named.
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>

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
    std::cout << error.what() << '\n';
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

/// Whether the reader notices: refuses, or gives everything as it was.
bool safe(const std::string &path)
{
  try
  {
    const CheckpointReader reader(path);
    return reader.read_doubles("numbers") == std::vector<double>(500, 1.5) &&
           reader.read_text("name") == "disk" &&
           reader.read_integers("step") == std::vector<std::uint64_t>{7};
  }
  catch (const InputError &)
  {
    return true;
  }
}
} // namespace

int main()
{
  const std::string path = checkpoint_path("run", 1);
  write_state(path, 1.5, true);
  write_state(path, 2.5, false);
  std::cout << "after an unfinished write: " << CheckpointReader(path).read_doubles("numbers")[0]
            << ", files: "
            << std::distance(std::filesystem::directory_iterator("run"),
                             std::filesystem::directory_iterator())
            << '\n';

  expect_error([] { CheckpointReader("run/state-000000009.h5"); });
  expect_error([&] { CheckpointReader(path).read_doubles("mpm/mass"); });
  expect_error([&] { CheckpointReader(path).read_doubles("step"); });
  expect_error([&] { CheckpointReader(path).read_text("numbers"); });

  const std::string good = content(path);
  unsigned int unsafe = 0, refused = 0;
  for (std::size_t at = 0; at < good.size(); at += 13)
  {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x24);
    put("damaged.h5", bad);
    unsafe += !safe("damaged.h5");
  }
  for (std::size_t size = 0; size < good.size(); size += 97)
  {
    put("damaged.h5", good.substr(0, size));
    try
    {
      CheckpointReader reader("damaged.h5");
    }
    catch (const InputError &)
    {
      ++refused;
    }
  }
  std::cout << "damaged bytes that pass unseen: " << unsafe << '\n'
            << "cut files accepted: " << (good.size() + 96) / 97 - refused << '\n';

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
