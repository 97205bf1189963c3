// SPDX-License-Identifier: LGPL-2.1-or-later
// One disk that is far away, large or fast costs the others nothing: pairs are those of a search over all,
// the number of distances that are looked at hardly grows, and a disk that flies alone makes no new lists.
#include <softgrain/contact/neighbour_list.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <random>
#include <set>

using namespace softgrain;
using contact::ImageLattice;
using contact::NeighbourList;
using Places = std::vector<std::array<double, 2>>;
using Pairs = std::set<std::pair<unsigned int, unsigned int>>;

namespace
{
const NeighbourList::Range range{0.1, 0., 0.3};

/// Pairs nearer than the gap and @p skin; where it repeats, to any image.
Pairs brute_force(const Places &x,
                  const std::vector<double> &r,
                  const ImageLattice &lattice,
                  const double skin)
{
  Pairs pairs;
  const int m = lattice.periodic[0] ? 2 : 0, n = lattice.periodic[1] ? 2 : 0;
  for (unsigned int i = 0; i < x.size(); ++i)
    for (unsigned int j = i + 1; j < x.size(); ++j)
      for (int a = -m; a <= m; ++a)
        for (int b = -n; b <= n; ++b)
        {
          std::array<double, 2> shift{};
          if (lattice.repeats())
            shift = lattice.shift({{a, b}});
          const double dx = x[i][0] - x[j][0] - shift[0], dy = x[i][1] - x[j][1] - shift[1];
          if (std::hypot(dx, dy) < r[i] + r[j] + range.gap + skin)
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

/// A square heap of disks with radii around one half.
Places heap(const unsigned int n, std::vector<double> &r)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  const unsigned int side = static_cast<unsigned int>(std::sqrt(n));
  Places x;
  for (unsigned int i = 0; i < side; ++i)
    for (unsigned int j = 0; j < side; ++j)
    {
      x.push_back({{i + uniform(generator), j + uniform(generator)}});
      r.push_back(0.5 + 0.3 * uniform(generator));
    }
  return x;
}

double alone = 0.; ///< distances looked at for the heap alone

void made(const std::string &what, const Places &x, const std::vector<double> &r)
{
  NeighbourList list(r, {}, range);
  list.build(x);
  const double looked = list.n_looked_at();
  std::cout << what << ": "
            << (listed(list) == brute_force(x, r, {}, range.skin) ? "the pairs of a search over all"
                                                                  : "OTHER PAIRS")
            << ", disks shared " << shared_disks(list) << ", distances looked at ";
  if (alone == 0.)
    alone = looked;
  if (looked < 1.2 * alone)
    std::cout << "as for the heap\n";
  else
    std::cout << looked / alone << " times\n";
}

void made_with(const std::string &what, const std::array<double, 2> &place, const double radius)
{
  std::vector<double> r;
  Places x = heap(2500, r);
  x.push_back(place);
  r.push_back(radius);
  made(what, x, r);
}

/// The last disks fly, all others stay: two of one group the same way, others against each other. @p lattice
/// in which they are
void flown(const std::string &what,
           Places x,
           const std::vector<double> &r,
           const unsigned int n_fliers,
           const std::array<double, 2> &way,
           const ImageLattice &lattice = {},
           const std::vector<std::uint32_t> &group = {})
{
  NeighbourList list(r, group, range);
  unsigned int lists = 0, missed = 0, steps = 60;
  for (unsigned int step = 0; step < steps; ++step)
  {
    lists += list.update(x, lattice);
    const Pairs has = listed(list), needs = brute_force(x, r, lattice, 0.);
    missed += !std::includes(has.begin(), has.end(), needs.begin(), needs.end());
    // The first flies on; a second comes the other way.
    for (unsigned int f = 0; f < n_fliers; ++f)
      for (unsigned int d = 0; d < 2; ++d)
        x[x.size() - 1 - f][d] += f == 0 || !group.empty() ? way[d] : -way[d];
  }
  std::cout << what << ": " << lists << " lists in " << steps << " steps, pairs missed in " << missed << '\n';
}

Places with(Places x, const Places &more)
{
  x.insert(x.end(), more.begin(), more.end());
  return x;
}
} // namespace

int main()
{
  std::vector<double> r;
  const Places x = heap(2500, r);
  made("a heap", x, r);
  made_with("one disk far above", {{25., 1e6}}, 0.5);
  made_with("far below", {{25., -1e6}}, 0.5);
  made_with("far to the right", {{1e6, 3.}}, 0.5);
  made_with("far along a diagonal", {{-1e6, -1e6}}, 0.5);
  made_with("a hundred million diameters away", {{1e8, 1e8}}, 0.5);
  made_with("out of all numbers of cells", {{-1e30, 1e30}}, 0.5);
  made_with("a disk a thousand times as large", {{25., -501.}}, 500.);
  made_with("a disk a thousand times as large, beside", {{-501., 25.}}, 500.);
  made_with("a disk a thousand times as large, far away", {{1e7, 25.}}, 500.);

  Places apart = x;
  for (std::size_t i = 0; i < apart.size(); i += 2)
    apart[i][0] += 1e6;
  made("two heaps far apart", apart, r);
  Places thin = x;
  for (std::array<double, 2> &place : thin)
    place = {{1e3 * place[0], 1e3 * place[1]}};
  made("a thin gas", thin, r);
  std::vector<double> sizes = r;
  Places mixed = x;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    sizes[i] = 0.5 * std::pow(10., -static_cast<double>(i % 7) / 2.);
    mixed[i] = {{2. * x[i][0], 2. * x[i][1]}};
  }
  made("sizes from 1 to 1000", mixed, sizes);

  std::vector<double> small;
  const Places few = heap(100, small);
  std::vector<double> r1 = small, r2 = small;
  r1.push_back(0.5);
  r2.insert(r2.end(), {0.5, 0.5});
  flown("a disk flies away far above", with(few, {{{5., 1e3}}}), r1, 1, {{0., 10.}});
  flown("a disk flies past at some distance", with(few, {{{12., -30.}}}), r1, 1, {{0., 1.}});
  flown("a disk flies into the heap", with(few, {{{40., 5.}}}), r1, 1, {{-0.8, 0.}});
  flown("two disks meet", with(few, {{{30., 60.}}, {{0., 60.}}}), r2, 2, {{0.5, 0.}});
  // Groups: the heap, and two disks that touch.
  std::vector<std::uint32_t> groups(few.size(), 0);
  groups.insert(groups.end(), {1, 1});
  flown("two disks of a body fly past", with(few, {{{12., -30.}}, {{13., -30.}}}), r2, 2, {{0., 1.}}, {},
        groups);
  flown("two disks of a body fly into the heap", with(few, {{{39., 5.}}, {{40., 5.}}}), r2, 2, {{-0.8, 0.}},
        {}, groups);
  ImageLattice cell;
  cell.periodic = {{true, true}};
  cell.lower = {{-1., -1.}};
  cell.length = {{60., 60.}};
  cell.offset = 7.;
  flown("a disk flies through a cell that repeats", with(few, {{{30., 30.}}}), r1, 1, {{3., 0.}}, cell);
  flown("through the side of it into the heap", with(few, {{{30., 5.}}}), r1, 1, {{0.9, 0.}}, cell);
  flown("down through the skewed side of it", with(few, {{{12., 30.}}}), r1, 1, {{0., 0.9}}, cell);
  flown("two meet across a side", with(few, {{{50., 30.}}, {{20., 30.}}}), r2, 2, {{0.6, 0.}}, cell);
}
