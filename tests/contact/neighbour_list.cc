// SPDX-License-Identifier: LGPL-2.1-or-later
// The list holds the pairs that a search over all pairs finds, no tile shares a disk with another of its
// colour, it is made anew exactly when a disk has gone half the skin, and what pairs remember survives.
#include <softgrain/base/exceptions.h>
#include <softgrain/contact/neighbour_list.h>

#include <cmath>
#include <iostream>
#include <map>
#include <random>
#include <set>

using namespace softgrain;
using contact::NeighbourList;
using Places = std::vector<std::array<double, 2>>;

namespace
{
using Pairs = std::set<std::pair<unsigned int, unsigned int>>;

Pairs brute_force(const Places &x,
                  const std::vector<double> &r,
                  const std::vector<std::uint32_t> &group,
                  const NeighbourList::Range &range)
{
  Pairs pairs;
  for (unsigned int i = 0; i < x.size(); ++i)
    for (unsigned int j = i + 1; j < x.size(); ++j)
    {
      double reach = r[i] + r[j] + range.gap;
      if (!group.empty() && group[i] == group[j])
        reach = std::max(reach, range.stretch * (r[i] + r[j]));
      if (std::hypot(x[i][0] - x[j][0], x[i][1] - x[j][1]) < reach + range.skin)
        pairs.emplace(i, j);
    }
  return pairs;
}

Pairs listed(const NeighbourList &list)
{
  Pairs pairs;
  for (std::size_t p = 0; p < list.n_pairs(); ++p)
    pairs.emplace(std::min(list.a(p), list.b(p)), std::max(list.a(p), list.b(p)));
  return pairs.size() == list.n_pairs() ? pairs : Pairs(); // a pair listed twice is an error
}

/// Disks that occur in two tiles of one colour.
unsigned int shared_disks(const NeighbourList &list)
{
  unsigned int shared = 0;
  for (unsigned int c = 0; c + 1 < list.colour_start().size(); ++c)
  {
    std::map<unsigned int, unsigned int> owner;
    for (unsigned int t = list.colour_start()[c]; t < list.colour_start()[c + 1]; ++t)
      for (unsigned int p = list.tile_start()[t]; p < list.tile_start()[t + 1]; ++p)
        for (const unsigned int disk : {list.a(p), list.b(p)})
          shared += owner.emplace(disk, t).first->second != t;
  }
  return shared;
}

void random_disks(const std::string &what,
                  const unsigned int n,
                  const unsigned int n_groups,
                  const double width)
{
  std::mt19937 generator(n);
  std::uniform_real_distribution<double> uniform(0., 1.);
  const double height = n / width;
  Places x(n);
  std::vector<double> r(n);
  std::vector<std::uint32_t> group(n_groups > 0 ? n : 0);
  for (unsigned int i = 0; i < n; ++i)
  {
    x[i] = {width * uniform(generator) - 3., height * uniform(generator) + 7.};
    r[i] = 0.3 + 0.3 * uniform(generator);
    if (n_groups > 0)
      group[i] = static_cast<unsigned int>(x[i][1]) % n_groups;
  }
  const NeighbourList::Range range{0.05, 2., 0.3};
  NeighbourList list(r, group, range);
  list.update(x);
  const Pairs all = brute_force(x, r, group, range);
  std::cout << what << ": " << (listed(list) == all ? "the pairs of a search over all" : "OTHER PAIRS")
            << ", " << (list.tile_start().size() > 3 ? "several tiles" : "one or two tiles")
            << ", disks shared " << shared_disks(list) << '\n';

  // Pairs remember their own numbers; after a small move nothing is searched, after a larger one they still
  // do.
  for (std::size_t p = 0; p < list.n_pairs(); ++p)
    list.memory().set(p, {1. + std::min(list.a(p), list.b(p)), 1. + std::max(list.a(p), list.b(p)), 0.});
  x[n / 2][0] += 0.149;
  const bool small = list.update(x);
  x[n / 2][0] += 0.002;
  const bool large = list.update(x);
  unsigned int right = 0, wrong = 0, forgotten = 0;
  for (std::size_t p = 0; p < list.n_pairs(); ++p)
  {
    const double low = 1. + std::min(list.a(p), list.b(p)), high = 1. + std::max(list.a(p), list.b(p));
    const softgrain::contact::PairMemory::Impulses memory = list.memory()[p];
    if (memory[0] == low && memory[1] == high)
      ++right;
    else if (memory == softgrain::contact::PairMemory::Impulses{})
      forgotten += all.count({static_cast<unsigned int>(low) - 1, static_cast<unsigned int>(high) - 1});
    else
      ++wrong;
  }
  std::cout << "  searched anew after 0.149: " << small << ", after 0.151: " << large << "; memories kept "
            << (right > 0 ? "all" : "none") << ", wrong " << wrong << ", forgotten " << forgotten << '\n';
}
} // namespace

int main()
{
  random_disks("many disks", 4000, 0, 150.);
  random_disks("many disks in groups", 4000, 7, 60.);
  random_disks("a column", 300, 3, 1.);
  random_disks("a few", 5, 0, 2.);
  try
  {
    Places x = {{0., 0.}, {std::nan(""), 1.}};
    NeighbourList list({1., 1.}, {}, {0., 0., 0.1});
    list.update(x);
  }
  catch (const ComputationError &error)
  {
    std::cout << error.what() << '\n';
  }
}
