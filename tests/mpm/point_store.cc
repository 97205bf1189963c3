// SPDX-License-Identifier: LGPL-2.1-or-later
// Points as particles: what they carry, and that sorting finds every one of them with what it carries, on
// faces and vertices of cells too and however far it went, in an order that does not depend on the way it
// took.
#include <softgrain/base/exceptions.h>
#include <softgrain/mpm/body/point_store.h>
#include <softgrain/mpm/field/lattice.h>

#include <iostream>
#include <random>

using namespace softgrain;
using Point = dealii::Point<2>;

namespace
{
void print_layout(const std::string &what, const mpm::PointNeeds &needs)
{
  const mpm::PointLayout<2> layout(needs);
  std::cout << what << ", " << layout.n_components() << " numbers per point:\n";
  for (const mpm::PointSlotDescription &slot : layout.slots())
    std::cout << "  " << layout.offset(slot.slot) << ' ' << slot.name << " " << slot.n_components << " ["
              << slot.unit << "]\n";
}

/// What differs from what it should be: cells of the mesh, cells of points, what they carry.
unsigned int n_wrong(const mpm::PointStore<2> &store, const mpm::Lattice<2> &lattice)
{
  unsigned int wrong = 0;
  for (const auto &particle : store.handler())
  {
    const auto expected = store.cell(lattice.cell_of(particle.get_location()));
    const auto point = store(particle.get_local_index());
    wrong += particle.get_surrounding_cell() != expected || point.velocity()[1] != particle.get_id() ||
             point.body() != particle.get_id() % 3;
  }
  return wrong;
}

/// Ids of all bodies in their order.
std::vector<unsigned int> order(const mpm::PointStore<2> &store)
{
  std::vector<unsigned int> ids;
  for (const auto &list : store.by_body(mpm::PointStore<2>::LevelsOfBodies(3, nullptr)))
    for (const auto handle : list)
      ids.push_back(store.id(handle));
  return ids;
}

void move(mpm::PointStore<2> &store, const mpm::Lattice<2> &lattice, const std::vector<Point> &places)
{
  for (const auto &particle : store.handler())
    store(particle.get_local_index()).move_to(lattice.off_faces(places[particle.get_id()]));
  store.sort();
}
} // namespace

int main()
{
  print_layout("least", mpm::PointNeeds());
  print_layout("without inertia", {false});
  print_layout("most", {true, true, true, 2});

  // A cell size that is no binary fraction, so that faces suffer from rounding.
  const mpm::Lattice<2> lattice(Point(-0.7, 0.3), Point(2.4, 2.2), 0.1);
  mpm::PointStore<2> store(lattice, mpm::PointLayout<2>());
  store.cover_all();
  unsigned int wrong_cells = 0;
  for (int j = 0; j < lattice.n_cells()[1]; ++j)
    for (int i = 0; i < lattice.n_cells()[0]; ++i)
      wrong_cells += store.cell({{i, j}})->center().distance(Point(-0.65 + 0.1 * i, 0.35 + 0.1 * j)) > 1e-12;
  std::cout << lattice.n_cells()[0] << " x " << lattice.n_cells()[1] << " cells, wrong: " << wrong_cells
            << '\n';

  // Every vertex, every midpoint of a face and every centre.
  std::vector<Point> special;
  for (int j = 0; j < 2 * lattice.n_cells()[1]; ++j)
    for (int i = 0; i < 2 * lattice.n_cells()[0]; ++i)
      special.emplace_back(-0.7 + 0.05 * i, 0.3 + 0.05 * j);
  std::vector<Point> random, near = special;
  std::mt19937 generator(3);
  std::uniform_real_distribution<> x(-0.7, 2.4), y(0.3, 2.2), small(-0.03, 0.03);
  for (Point &place : near)
  {
    random.emplace_back(x(generator), y(generator));
    place[0] = std::max(-0.7, place[0] + small(generator));
    place[1] = std::max(0.3, place[1] + small(generator));
  }
  store.reserve(special.size());
  for (unsigned int p = 0; p < special.size(); ++p)
    store(store.add(special[p], p % 3)).velocity()[1] = p;
  std::cout << store.size() << " points on vertices, faces and centres, wrong: " << n_wrong(store, lattice)
            << '\n';
  const std::vector<unsigned int> at_first = order(store);
  const char *const names[] = {"next cells", "anywhere", "back"};
  const std::vector<Point> *const ways[] = {&near, &random, &special};
  for (unsigned int k = 0; k < 3; ++k)
  {
    move(store, lattice, *ways[k]);
    std::cout << names[k] << ", wrong: " << n_wrong(store, lattice) << '\n';
  }
  std::cout << "order " << (order(store) == at_first ? "as at first" : "differs") << '\n';

  // A mesh of the middle alone, as a rank makes that has no points elsewhere.
  mpm::PointStore<2> part(lattice, mpm::PointLayout<2>()), whole(lattice, mpm::PointLayout<2>());
  part.cover({{7, 4}}, {{20, 13}});
  whole.cover_all();
  for (const Point &place : random)
    if (part.covers(lattice.cell_of(place)))
      for (mpm::PointStore<2> *const some : {&part, &whole})
      {
        const unsigned int id = some->size();
        (*some)(some->add(place, id % 3)).velocity()[1] = id;
      }
  std::cout << (part.size() > 300 ? "hundreds of" : "few")
            << " points in the middle, wrong: " << n_wrong(part, lattice) << ", order "
            << (order(part) == order(whole) ? "that of the whole" : "differs") << '\n';

  special[7] = Point(2.4000001, 1.);
  try
  {
    move(store, lattice, special);
    std::cout << "nothing said about a lost point\n";
  }
  catch (const ComputationError &error)
  {
    std::cout << error.what() << '\n';
  }
}
