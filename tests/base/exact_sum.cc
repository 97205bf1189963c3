// SPDX-License-Identifier: LGPL-2.1-or-later
// Sums that do not round. Known: numbers that cancel leave what they should, and the bits of a sum depend
// neither on the order of its numbers nor on which rank has which.
#include <softgrain/base/exact_sum.h>
#include <softgrain/base/exchange.h>
#include <softgrain/base/mpi_session.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

using namespace softgrain;

namespace
{
double sum_of(const std::vector<double> &numbers)
{
  ExactSum sum;
  for (const double number : numbers)
    sum.add(number);
  return sum.value();
}

/// Numbers of all sizes and both signs.
std::vector<double> mixed(const unsigned int n)
{
  std::mt19937 generator(7);
  std::vector<double> numbers;
  for (unsigned int i = 0; i < n; ++i)
  {
    const double digits = generator() / 4294967296. - 0.5;
    numbers.push_back(std::ldexp(digits, static_cast<int>(generator() % 80) - 40));
  }
  return numbers;
}

/// Whether parts, in whatever order, come to the same as all.
bool same_in_parts(std::vector<double> numbers)
{
  const double expected = sum_of(numbers);
  std::reverse(numbers.begin(), numbers.end());
  ExactSum first, second;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    (i % 3 == 0 ? first : second).add(numbers[i]);
  second.add(first);
  return second.value() == expected && sum_of(numbers) == expected;
}

/// Whether a little more than half of the last bit is rounded up, wherever the digits of the sum begin, and
/// sums of the same numbers in other units have the same bits.
bool rounded_once(const std::vector<double> &numbers)
{
  bool good = true;
  for (int power = -40; power <= 40; ++power)
  {
    const double one = std::ldexp(1., power);
    good = good && sum_of({one, std::ldexp(one, -53), std::ldexp(one, -120)}) == one + std::ldexp(one, -52) &&
           sum_of({one, std::ldexp(one, -53), -std::ldexp(one, -120)}) == one;
    std::vector<double> scaled = numbers;
    for (double &number : scaled)
      number = std::ldexp(number, power);
    good = good && sum_of(scaled) == std::ldexp(sum_of(numbers), power);
  }
  return good;
}

/// Numbers of which each rank has some.
bool same_on_ranks(const std::vector<double> &numbers, const Exchange &ranks)
{
  std::vector<ExactSum> sums(2);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (i % ranks.number() == ranks.here())
    {
      sums[0].add(numbers[i]);
      sums[1].add(-numbers[i]);
    }
  add_over_all(sums, ranks);
  return sums[0].value() == sum_of(numbers) && sums[1].value() == -sum_of(numbers);
}
} // namespace

int main(int, char **argv)
{
  const MPISession mpi(argv);
  const Exchange ranks;
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const double infinite = std::numeric_limits<double>::infinity();
  const std::vector<double> numbers = mixed(100000);
  const bool on_ranks = !ranks.any(!same_on_ranks(numbers, ranks));
  if (!ranks.first())
    return 0;
  std::cout << "nothing " << sum_of({}) << ", one " << sum_of({0.1}) << ", negative " << sum_of({-3., 1.})
            << '\n'
            << "what cancels leaves " << sum_of({1e300, 1., -1e300, 1e-300, -1., 2.}) << '\n'
            << "the least numbers " << sum_of({least, 1., least, -1., -3. * least}) / least << '\n'
            << "the largest ones " << sum_of({most, most, -most, -most, most}) / most << ", too large "
            << sum_of({most, most}) << '\n'
            << "infinite " << sum_of({1., infinite}) << ", no number "
            << std::isnan(sum_of({infinite, -infinite})) << '\n';
  long double reference = 0.L;
  for (const double number : numbers)
    reference += number;
  std::cout << "against long double "
            << (std::abs(sum_of(numbers) / reference - 1.L) < 1e-15L ? "right" : "WRONG") << ", in parts "
            << (same_in_parts(numbers) ? "the same" : "DIFFERENT") << ", on ranks "
            << (on_ranks ? "the same" : "DIFFERENT") << ", rounded "
            << (rounded_once(mixed(1000)) ? "once" : "TWICE") << '\n';
}
