// SPDX-License-Identifier: LGPL-2.1-or-later
// What ranks tell each other. Known: numbers go from their owners to all, to the first, and between
// neighbours, to the bit; a failure of one is everybody's, that of the lowest rank first; a request to stop
// that comes to one rank stops all at the same place.
#include <softgrain/base/exceptions.h>
#include <softgrain/base/exchange.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/mpi_session.h>

#include <cmath>
#include <cstring>
#include <iostream>
#include <limits>
#include <vector>

using namespace softgrain;

/// Of number i; odd bits, and one that is no number.
double value(const unsigned int i)
{
  return i == 5 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(2. + i);
}

unsigned int wrong_values(const std::vector<std::vector<double>> &lists)
{
  unsigned int wrong = 0;
  for (unsigned int i = 0; i < lists.size(); ++i)
    for (const double number : lists[i])
      wrong += !(number == value(i) || (std::isnan(number) && std::isnan(value(i))));
  return wrong;
}

/// Numbers that differ from what their owners have, after they were shared: rank i % n owns i % 4 of them.
unsigned int wrong_numbers(const Exchange &ranks)
{
  std::vector<std::vector<double>> lists(17);
  std::vector<Exchange::Piece> pieces;
  for (unsigned int i = 0; i < lists.size(); ++i)
  {
    const unsigned int owner = i % ranks.number();
    lists[i].assign(i % 4, owner == ranks.here() ? value(i) : 0.);
    pieces.push_back({owner, lists[i].data(), lists[i].size()});
  }
  ranks.share(pieces);
  return wrong_values(lists);
}

/// Numbers that differ from what their owners have, after they were brought to the first rank.
unsigned int wrong_at_first(const Exchange &ranks)
{
  std::vector<std::vector<double>> lists(17);
  std::vector<Exchange::Piece> pieces;
  for (unsigned int i = 0; i < lists.size(); ++i)
  {
    const unsigned int owner = i * i % ranks.number();
    if (owner == ranks.here())
      lists[i].assign(i % 4, value(i));
    else if (ranks.first())
      lists[i].assign(i % 4, 0.);
    pieces.push_back({owner, lists[i].data(), i % 4});
  }
  ranks.bring(pieces);
  return wrong_values(lists);
}

/// The same for numbers each of which one rank has, joined at the first rank; zeros of both signs among them.
unsigned int wrong_joined(const Exchange &ranks)
{
  std::vector<double> numbers(40), expected(40);
  for (unsigned int i = 0; i < numbers.size(); ++i)
  {
    expected[i] = i % 7 == 3 ? 0. : i % 7 == 4 ? -0. : value(i % 7);
    numbers[i] = i * i % ranks.number() == ranks.here() ? expected[i] : 0.;
  }
  const std::vector<double> before = numbers;
  ranks.join_at_first(numbers.data(), numbers.size());
  const std::vector<double> &right = ranks.first() ? expected : before;
  unsigned int wrong = 0;
  for (unsigned int i = 0; i < numbers.size(); ++i)
    wrong += std::memcmp(&numbers[i], &right[i], sizeof(double)) != 0;
  return wrong;
}

/// Numbers that differ from what the neighbours on a ring have sent, each a list of its own length.
unsigned int wrong_messages(const Exchange &ranks)
{
  const unsigned int n = ranks.number(), here = ranks.here();
  if (n < 2)
    return 0;
  const auto number = [](const unsigned int from, const unsigned int to, const std::size_t i)
  { return value(10 * from + to) + i; };
  unsigned int wrong = 0;
  for (unsigned int round = 0; round < 20; ++round)
  {
    std::vector<std::vector<double>> out(n), in(n);
    std::vector<Exchange::Message> outgoing, incoming;
    for (const unsigned int other : {(here + 1) % n, (here + n - 1) % n})
      if (out[other].empty()) // with two ranks both neighbours are the same
      {
        out[other].resize(1 + 3 * here + round);
        in[other].resize(1 + 3 * other + round);
        for (std::size_t i = 0; i < out[other].size(); ++i)
          out[other][i] = number(here, other, i);
        outgoing.push_back({other, out[other].data(), out[other].size()});
        incoming.push_back({other, in[other].data(), in[other].size()});
      }
    ranks.swap(outgoing, incoming);
    for (const Exchange::Message &message : incoming)
      for (std::size_t i = 0; i < message.size; ++i)
        wrong += message.begin[i] != number(message.other, here, i);
  }
  return wrong;
}

/// Numbers that differ from what others have in lists for each rank, for the first one, and for all.
unsigned int wrong_lists(const Exchange &ranks)
{
  const unsigned int n = ranks.number(), here = ranks.here();
  // Of rank i for rank j, some of them empty.
  const auto list = [](const unsigned int i, const unsigned int j)
  { return std::vector<double>((3 * i + j) % 4, 10. * i + j); };
  std::vector<std::vector<double>> out, all;
  for (unsigned int r = 0; r < n; ++r)
    out.push_back(list(here, r));
  const auto came = ranks.to_each(out), at_first = ranks.lists_at_first(list(here, 7)),
             of_all = ranks.lists_of_all(list(here, 8));
  unsigned int wrong = 0;
  for (unsigned int r = 0; r < n; ++r)
  {
    wrong += came.at(r) != list(r, here);
    wrong += at_first.at(r) != (ranks.first() ? list(r, 7) : std::vector<double>());
    wrong += of_all.at(r) != list(r, 8);
  }
  return wrong;
}

/// What this rank catches when those from @p lowest on fail.
std::string failure(const Exchange &ranks, const unsigned int lowest)
{
  try
  {
    ranks.together(
        [&]()
        {
          if (ranks.here() >= lowest)
            throw InputError("no good on " + std::to_string(ranks.here()));
        });
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "none";
}

int main(int, char **argv)
{
  const MPISession mpi(argv);
  const Exchange ranks;
  const unsigned int last = ranks.number() - 1;
  std::vector<double> wrong(ranks.number()), caught(ranks.number()), stopped(ranks.number()),
      parted(ranks.number());
  const unsigned int here = ranks.here();
  wrong[here] = wrong_numbers(ranks) + wrong_at_first(ranks) + wrong_joined(ranks) + wrong_messages(ranks) +
                wrong_lists(ranks);
  caught[here] = failure(ranks, last) == "no good on " + std::to_string(last) &&
                 failure(ranks, ranks.number()) == "none";
  await_telling_of_interruption();
  forget_interruption();
  ranks.together([]() {});
  if (here == last)
    request_interruption();
  const bool too_early = interruption_requested();
  ranks.together([]() {});
  stopped[here] = !too_early && interruption_requested();
  ranks.check_alike({1., value(3)});
  try
  {
    ranks.check_alike({1., here == last ? std::nextafter(value(3), 2.) : value(3)});
  }
  catch (const ComputationError &)
  {
    parted[here] = 1.;
  }
  std::vector<Exchange::Piece> pieces;
  for (unsigned int r = 0; r < ranks.number(); ++r)
    for (std::vector<double> *const numbers : {&wrong, &caught, &stopped, &parted})
      pieces.push_back({r, &(*numbers)[r], 1});
  ranks.share(pieces);
  const std::string told = ranks.share(ranks.first() ? "" : "rank " + std::to_string(here), last);
  if (!ranks.first())
    return 0;
  std::cout << "ranks " << ranks.number() << ", the last one says '" << told << "'\n";
  for (unsigned int r = 0; r < ranks.number(); ++r)
    std::cout << "rank " << r << ": wrong numbers " << wrong[r] << ", failures as told " << caught[r]
              << ", stops when told " << stopped[r] << ", notices one bit " << parted[r] << '\n';
}
