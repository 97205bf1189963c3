// SPDX-License-Identifier: LGPL-2.1-or-later
// Neighbours in a cell that repeats: the pairs that every disk and every image give, each once, wherever in
// the lattice disks are; tiles of a colour share no disk; memories survive; a lattice that deforms with all
// disks makes no new list before its strain uses up the skin.
#include <softgrain/base/random.h>
#include <softgrain/contact/neighbour_list.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <tuple>

using namespace softgrain;
using contact::ImageLattice;
using contact::NeighbourList;

namespace
{
using Places = std::vector<std::array<double, 2>>;
using Pair = std::tuple<std::uint32_t, std::uint32_t, int, int>;

/// One name for a pair, whichever disk comes first.
Pair name(const std::uint32_t a, const std::uint32_t b, const ImageLattice::Image &n)
{
  if (a < b || (a == b && (n[1] > 0 || (n[1] == 0 && n[0] > 0))))
    return {a, b, n[0], n[1]};
  return {b, a, -n[0], -n[1]};
}

std::set<Pair>
all_pairs(const Places &places, const std::vector<double> &radii, const ImageLattice &lattice, double reach)
{
  std::set<Pair> pairs;
  const int far = 20;
  for (std::uint32_t a = 0; a < places.size(); ++a)
    for (std::uint32_t b = 0; b <= a; ++b)
      for (int up = -far; up <= far; ++up)
        for (int right = -far; right <= far; ++right)
        {
          if ((!lattice.periodic[0] && right != 0) || (!lattice.periodic[1] && up != 0) ||
              (a == b && up == 0 && right == 0))
            continue;
          const auto shift = lattice.shift({{right, up}});
          const double dx = places[a][0] - places[b][0] - shift[0],
                       dy = places[a][1] - places[b][1] - shift[1];
          if (std::hypot(dx, dy) < radii[a] + radii[b] + reach)
            pairs.insert(name(a, b, {{right, up}}));
        }
  return pairs;
}

void compare(const std::string &what, const ImageLattice &lattice)
{
  const unsigned int n = 300;
  Uniform random(7);
  Places places;
  std::vector<double> radii;
  for (unsigned int i = 0; i < n; ++i)
  {
    radii.push_back(0.3 + 0.2 * random());
    // Three cells away in the directions that repeat.
    places.push_back({(lattice.periodic[0] ? 7. * random() - 3. : random()) * lattice.length[0],
                      (lattice.periodic[1] ? 7. * random() - 3. : random()) * lattice.length[1]});
  }
  const double skin = 0.2, gap = 0.1;
  NeighbourList list(radii, {}, {gap, 0., skin});
  list.build(places, lattice);
  std::set<Pair> found;
  for (std::size_t p = 0; p < list.n_pairs(); ++p)
    found.insert(name(list.a(p), list.b(p), list.image(p)));
  const std::set<Pair> expected = all_pairs(places, radii, lattice, gap + skin);
  bool shared = false;
  for (std::size_t colour = 0; colour + 1 < list.colour_start().size(); ++colour)
  {
    std::vector<int> tile_of(n, -1);
    for (std::uint32_t tile = list.colour_start()[colour]; tile < list.colour_start()[colour + 1]; ++tile)
      for (std::uint32_t p = list.tile_start()[tile]; p < list.tile_start()[tile + 1]; ++p)
        for (const std::uint32_t disk : {list.a(p), list.b(p)})
        {
          shared = shared || (tile_of[disk] >= 0 && tile_of[disk] != static_cast<int>(tile));
          tile_of[disk] = tile;
        }
  }
  for (std::size_t p = 0; p < list.n_pairs(); ++p)
    list.memory().set(p, {1. * list.a(p) + list.b(p), 1. * std::abs(list.image(p)[0]), 1.});
  // Everything moves on by some cells: the same pairs.
  Places moved = places;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int d = 0; d < 2; ++d)
      moved[i][d] += lattice.periodic[d] ? 0.37 * lattice.length[d] : 0.;
  list.build(moved, lattice);
  unsigned int kept = 0;
  for (std::size_t p = 0; p < list.n_pairs(); ++p)
    kept += list.memory()[p] == softgrain::contact::PairMemory::Impulses{1. * list.a(p) + list.b(p),
                                                                         1. * std::abs(list.image(p)[0]), 1.};
  std::cout << what << ": " << found.size() << " pairs, listed " << list.n_pairs() << ", "
            << (found == expected ? "those expected" : "OTHERS") << ", tiles " << (shared ? "SHARE" : "apart")
            << ", memories kept " << (kept == list.n_pairs() ? "all" : "NOT ALL") << '\n';
}

void deform()
{
  ImageLattice lattice{{{true, true}}, {{0, 0}}, {{10, 8}}, 0.};
  Uniform random(3);
  Places start;
  for (unsigned int i = 0; i < 50; ++i)
    start.push_back({30. * random(), 30. * random()});
  NeighbourList list(std::vector<double>(50, 0.5), {}, {0.1, 0., 0.2});
  list.build(start, lattice);
  // Pairs are nearer than 1.3, so 0.2 / 1.3 = 0.154 of strain brings them nearer by the skin.
  for (const double strain : {0.05, 0.15, 0.16})
  {
    Places places = start;
    for (auto &x : places)
      x[0] += strain * x[1];
    ImageLattice sheared = lattice;
    sheared.offset = strain * lattice.length[1];
    NeighbourList copy = list;
    std::cout << "sheared by " << strain << ": list " << (copy.update(places, sheared) ? "new" : "kept")
              << '\n';
  }
}
} // namespace

int main()
{
  compare("both", {{{true, true}}, {{-1, 2}}, {{14, 12}}, 0.});
  compare("offset", {{{true, true}}, {{-1, 2}}, {{14, 12}}, 5.9});
  compare("offset of many cells", {{{true, true}}, {{-1, 2}}, {{14, 12}}, 19.3});
  compare("x", {{{true, false}}, {{0, 0}}, {{14, 12}}, 0.});
  compare("y", {{{false, true}}, {{0, 0}}, {{14, 12}}, 0.});
  deform();
}
