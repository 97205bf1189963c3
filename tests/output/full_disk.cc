// SPDX-License-Identifier: LGPL-2.1-or-later
// A disk that is full at some byte of a checkpoint, a hundred places all over the file: every time the reason
// is told, the checkpoint that was there stays whole, nothing is left beside it, and HDF5 lives on; where
// there is room, what was written in pieces comes back to the bit.
#include <softgrain/base/exceptions.h>
#include <softgrain/output/checkpoint.h>

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <string>

using namespace softgrain;

namespace
{
constexpr std::size_t n_rows = 150000, width = 3, n_bodies = 400; // of a list, and of many small ones

double number(const std::size_t i, const double salt)
{
  return std::sin(0.1 * i) + salt;
}

void write_state(const std::string &path, const double salt)
{
  CheckpointWriter writer(path);
  writer.write_rows("long", n_rows, width,
                    [salt](const std::size_t begin, const std::size_t end, double *const rows)
                    {
                      for (std::size_t i = begin * width; i < end * width; ++i)
                        rows[i - begin * width] = number(i, salt);
                    });
  for (std::size_t body = 0; body < n_bodies; ++body)
    writer.write("bodies/" + std::to_string(body) + "/place", std::vector<double>(30, salt + body));
  writer.write_rows("none", 0, width, [](std::size_t, std::size_t, double *) { std::abort(); });
  writer.commit();
}

/// Numbers that are not those of @p salt.
std::size_t wrong_numbers(const std::string &path, const double salt)
{
  const CheckpointReader reader(path);
  std::size_t n_wrong = 0, next = 0;
  reader.read_rows("long", n_rows, width,
                   [&](const std::size_t begin, const std::size_t end, const double *const rows)
                   {
                     n_wrong += begin != next;
                     next = end;
                     for (std::size_t i = begin * width; i < end * width; ++i)
                       n_wrong += rows[i - begin * width] != number(i, salt);
                   });
  n_wrong += next != n_rows || !reader.read_doubles("none", 0).empty();
  for (std::size_t body = 0; body < n_bodies; ++body)
    n_wrong += reader.read_doubles("bodies/" + std::to_string(body) + "/place", 30) !=
               std::vector<double>(30, salt + body);
  return n_wrong;
}

void allow(const std::uintmax_t bytes)
{
  rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = bytes;
  setrlimit(RLIMIT_FSIZE, &limit);
}
} // namespace

int main()
{
  std::signal(SIGXFSZ, SIG_IGN);
  const std::string path = "full_disk.out/state.h5";
  std::filesystem::remove_all("full_disk.out");
  write_state(path, 0.);
  const std::uintmax_t size = std::filesystem::file_size(path);
  std::cout << "wrong numbers " << wrong_numbers(path, 0.) << '\n';
  unsigned int told = 0, left = 0;
  std::size_t wrong = 0;
  for (unsigned int k = 0; k < 100; ++k)
  {
    // Everywhere in the file, and byte for byte at its end.
    allow(k < 80 ? size * k / 80 : size - 100 + k);
    try
    {
      write_state(path, 1.);
    }
    catch (const ComputationError &error)
    {
      told += error.what() == "cannot write " + path + ".part: File too large";
    }
    left += std::filesystem::exists(path + ".part");
    if (k % 20 == 19)
      wrong += wrong_numbers(path, 0.);
  }
  std::cout << "told " << told << " of 100, left behind " << left << ", wrong numbers of the old one "
            << wrong << '\n';
  allow(size);
  write_state(path, 1.);
  std::cout << "with as much room as it needs: wrong numbers " << wrong_numbers(path, 1.) << '\n';
}
