// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/failure.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/ranks.h>
#include <softgrain/base/wait.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <limits>
#include <numeric>
#include <thread>

namespace softgrain
{
namespace
{
/// Pieces that go from their owners to all at once. Numbers stand rank after rank: whether it failed and
/// whether it was asked to stop, then its pieces in the order of the list.
class ExchangeOfPieces
{
public:
  using Some = std::vector<Ranks::Piece>::const_iterator;

  /// @param all where the numbers stand
  ExchangeOfPieces(const Some begin, const Some end, const unsigned int n, std::vector<double> &all)
      : begin(begin), end(end), starts(n, 0), at(n), all(all)
  {
    std::vector<std::size_t> count(n, 1);
    for (Some piece = begin; piece != end; ++piece)
      count[piece->owner] += piece->size;
    const std::size_t total = std::accumulate(count.begin(), count.end(), std::size_t(0));
    if (total > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw ComputationError("ranks have to exchange more than 2^31 numbers at once: use fewer bodies");
    counts.assign(count.begin(), count.end());
    std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
    all.resize(total);
    for (unsigned int r = 0; r < n; ++r)
      at[r] = all.data() + starts[r];
  }

  /// Puts down what this rank has.
  void pack(const unsigned int here, const bool failed)
  {
    *at[here] = (failed ? 2. : 0.) + (interruption_noted() ? 1. : 0.);
    double *own = at[here] + 1;
    for (Some piece = begin; piece != end; ++piece)
      if (piece->owner == here)
        own = std::copy_n(piece->begin, piece->size, own);
  }

  void send()
  {
    MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, all.data(), counts.data(), starts.data(), MPI_DOUBLE,
                   MPI_COMM_WORLD);
  }

  std::size_t bytes_from_others(const unsigned int here) const
  {
    return (all.size() - counts[here]) * sizeof(double);
  }

  /// Tells a request to stop that has come to any rank. @return the lowest rank that failed, or their number
  unsigned int take_flags()
  {
    unsigned int failed = at.size();
    for (unsigned int r = at.size(); r-- > 0;)
    {
      const double flags = *at[r]++;
      if (flags == 1. || flags == 3.)
        tell_interruption();
      if (flags >= 2.)
        failed = r;
    }
    return failed;
  }

  /// Brings what the others have to its places, after take_flags().
  void unpack(const unsigned int here)
  {
    for (Some piece = begin; piece != end; ++piece)
    {
      if (piece->owner != here)
        std::copy_n(at[piece->owner], piece->size, piece->begin);
      at[piece->owner] += piece->size;
    }
  }

private:
  const Some begin, end;
  std::vector<int> counts, starts;
  std::vector<double *> at; ///< where the next number of every rank is
  std::vector<double> &all;
};
} // namespace

Ranks::Ranks()
{
  int initialised = 0, finalised = 0;
  MPI_Initialized(&initialised);
  MPI_Finalized(&finalised);
  if (!initialised || finalised)
    return;
  n = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
}

void Ranks::exchange(const std::vector<Piece> &pieces, const std::exception_ptr &failure) const
{
  std::string text;
  const Failure kind = kind_of(failure, text);
  // Not all at once: what is exchanged takes memory on every rank.
  constexpr std::size_t most_at_once = 1 << 18;
  auto first = pieces.begin();
  do
  {
    auto end = first;
    for (std::size_t size = 0; end != pieces.end() && (end == first || size + end->size <= most_at_once);
         ++end)
      size += end->size;
    ExchangeOfPieces some(first, end, n, all);
    some.pack(rank, kind != Failure::none);
    {
      const Wait wait(times);
      some.send();
    }
    times.bytes += some.bytes_from_others(rank);
    if (const unsigned int failed = some.take_flags(); failed < n)
    {
      const std::string message = share(std::to_string(static_cast<int>(kind)) + text, failed);
      if (failure)
        std::rethrow_exception(failure);
      fail(static_cast<Failure>(message.at(0) - '0'), message.substr(1));
    }
    some.unpack(rank);
    first = end;
  } while (first != pieces.end());
  if (all.size() > most_at_once + n)
    std::vector<double>().swap(all); // for once there was more
}

bool Ranks::any(const bool here) const
{
  if (alone())
    return here;
  const int mine = here ? 1 : 0;
  int result = 0;
  const Wait wait(times);
  MPI_Allreduce(&mine, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return result != 0;
}

void Ranks::share(const std::vector<Piece> &pieces) const
{
  if (!alone())
    exchange(pieces, nullptr);
}

std::string Ranks::share(const std::string &text, const unsigned int owner) const
{
  if (alone())
    return text;
  const Wait wait(times);
  const std::string result = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, text, owner);
  times.bytes += result.size();
  return result;
}

std::vector<std::vector<double>> Ranks::of_all(const std::vector<double> &numbers) const
{
  std::vector<std::vector<double>> of_ranks(n, numbers);
  std::vector<Piece> pieces;
  for (unsigned int r = 0; r < n; ++r)
    pieces.push_back({r, of_ranks[r].data(), of_ranks[r].size()});
  share(pieces);
  return of_ranks;
}

void Ranks::fail_alike(const std::string &why) const
{
  if (alone())
    return;
  constexpr double patience = 10.; // [s]
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for (const double begin = steady_seconds();;)
  {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done)
      return;
    if (steady_seconds() - begin > patience)
      break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::cerr << "softgrain: error: rank " << rank << " failed alone: " << why << std::endl;
  MPI_Abort(MPI_COMM_WORLD, 1);
}
} // namespace softgrain
