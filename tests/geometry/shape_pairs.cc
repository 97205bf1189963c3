// SPDX-License-Identifier: LGPL-2.1-or-later
// Overlaps in a cell that repeats: the tree finds the pair that a look at all pairs and all images finds
// first.
#include <softgrain/geometry/shape_pairs.h>
#include <softgrain/geometry/shapes_2d.h>

#include <iostream>
#include <memory>
#include <random>

using namespace softgrain;
using Pair = std::optional<std::pair<std::size_t, std::size_t>>;
using Shapes = std::vector<std::unique_ptr<Shape<2>>>;

constexpr double touching = 1e-9;

Pair look_at_all(const std::vector<const Shape<2> *> &shapes, const PeriodicCell<2> &cell)
{
  for (std::size_t a = 0; a < shapes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (int x = -6; x <= 6; ++x)
        for (int y = -7; y <= 7; ++y)
          if ((cell.periodic[0] || x == 0) && (cell.periodic[1] || y == 0) &&
              overlap_when_moved(*shapes[a], *shapes[b], cell.shift({{x, y}}), touching))
            return std::make_pair(b, a);
  return std::nullopt;
}

std::vector<const Shape<2> *> pointers(const Shapes &shapes)
{
  std::vector<const Shape<2> *> result;
  for (const auto &shape : shapes)
    result.push_back(shape.get());
  return result;
}

void show(const std::string &what, const PeriodicCell<2> &cell, const double x, const double y)
{
  Shapes shapes;
  shapes.push_back(std::make_unique<Disk2D>(dealii::Point<2>(0.5, 0.5), 0.5));
  shapes.push_back(std::make_unique<Rectangle2D>(dealii::Point<2>(x, y), dealii::Point<2>(1., 1.), 0.));
  std::cout << what << ": " << (find_overlap(pointers(shapes), cell, touching) ? "overlap" : "apart") << '\n';
}

int main()
{
  PeriodicCell<2> plane, cell;
  cell.periodic = {{true, true}};
  cell.length = {{4., 3.}};
  show("far from each other, nothing repeats", plane, 3.4, 0.5);
  show("through a side", cell, 3.6, 0.5);
  show("touching through a side", cell, 3.5, 0.5);
  show("through a corner", cell, 3.75, 2.75);
  show("beside the corner", cell, 3.6, 2.6);
  show("drawn three cells away", cell, 3.6 - 12., 0.5 + 9.);

  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-9., 9.), size(0.1, 0.25);
  unsigned int agree = 0, found = 0;
  for (unsigned int trial = 0; trial < 200; ++trial)
  {
    Shapes shapes;
    for (unsigned int i = 0; i < 8; ++i)
    {
      const dealii::Point<2> at(place(random), place(random));
      const double r = size(random);
      if (i % 2 == 0)
        shapes.push_back(std::make_unique<Disk2D>(at, r));
      else
        shapes.push_back(std::make_unique<Rectangle2D>(at, dealii::Point<2>(r, 2. * r), at[0]));
    }
    cell.periodic[1] = trial % 3 != 0;
    const Pair tree = find_overlap(pointers(shapes), cell, touching),
               all = look_at_all(pointers(shapes), cell);
    agree += tree == all;
    found += tree.has_value();
  }
  std::cout << "agree " << agree << " of 200, some overlap " << (found > 20 && found < 180) << '\n';
}
