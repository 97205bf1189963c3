// SPDX-License-Identifier: LGPL-2.1-or-later
// Things shared out by recursive bisection. Known: a square of equal weights falls into squares; no sum of
// weights is further from the mean than the largest weight times the number of cuts; no part is empty as long
// as things are enough.
#include <softgrain/base/random.h>
#include <softgrain/geometry/bisection.h>

#include <algorithm>
#include <iostream>
#include <set>

using namespace softgrain;

int main()
{
  std::vector<dealii::Point<2>> square;
  for (unsigned int i = 0; i < 8; ++i)
    for (unsigned int j = 0; j < 8; ++j)
      square.emplace_back(i, j);
  const std::vector<unsigned int> quarters = bisect(square, std::vector<double>(64, 1.), 4);
  for (const unsigned int row : {0, 3, 4, 7})
  {
    std::cout << "row " << row << ':';
    for (unsigned int i = 0; i < 8; ++i)
      std::cout << ' ' << quarters[8 * i + row];
    std::cout << '\n';
  }

  Uniform random(7);
  std::vector<dealii::Point<2>> places;
  std::vector<double> weights;
  for (unsigned int i = 0; i < 1000; ++i)
  {
    const double x = random(), y = random();
    places.emplace_back(3. * x, y);
    weights.push_back(0.5 + random());
  }
  for (const unsigned int n : {1, 2, 3, 7, 16})
  {
    const std::vector<unsigned int> part = bisect(places, weights, n);
    std::vector<double> sum(n, 0.);
    double total = 0.;
    for (unsigned int i = 0; i < part.size(); ++i)
    {
      sum[part[i]] += weights[i];
      total += weights[i];
    }
    const double busiest = *std::max_element(sum.begin(), sum.end()) * n / total;
    std::cout << n << " parts: balanced within two percent " << (busiest < 1.02) << '\n';
  }
  for (const unsigned int n : {5, 9})
  {
    const std::vector<unsigned int> part = bisect(
        std::vector<dealii::Point<2>>(places.begin(), places.begin() + 7), {9., 0., 0., 0., 0., 0., 0.}, n);
    std::cout << "7 things in " << n << " parts fill "
              << std::set<unsigned int>(part.begin(), part.end()).size() << '\n';
  }
}
