// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/ranks.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <iostream>
#include <limits>
#include <new>
#include <numeric>
#include <thread>

namespace softgrain
{
namespace
{
/// What a rank may throw, so that the others throw the same.
enum class Failure
{
  none,
  input,
  computation,
  interrupted,
  memory,
  other
};

Failure kind_of(const std::exception_ptr &failure, std::string &text)
{
  if (!failure)
    return Failure::none;
  try
  {
    std::rethrow_exception(failure);
  }
  catch (const InputError &error)
  {
    text = error.what();
    return Failure::input;
  }
  catch (const ComputationError &error)
  {
    text = error.what();
    return Failure::computation;
  }
  catch (const Interrupted &)
  {
    return Failure::interrupted;
  }
  catch (const std::bad_alloc &)
  {
    return Failure::memory;
  }
  catch (const std::exception &error)
  {
    text = error.what();
    return Failure::other;
  }
}

[[noreturn]] void fail(const Failure kind, const std::string &text)
{
  switch (kind)
  {
  case Failure::input:
    throw InputError(text);
  case Failure::computation:
    throw ComputationError(text);
  case Failure::interrupted:
    throw Interrupted();
  case Failure::memory:
    throw std::bad_alloc();
  default:
    throw std::runtime_error(text);
  }
}
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

double Ranks::now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void Ranks::agree(const std::exception_ptr &failure) const
{
  std::string text;
  const Failure kind = kind_of(failure, text);
  // The lowest rank that has failed, and whether any is asked to stop, in one go.
  int here[2] = {kind == Failure::none ? 0 : static_cast<int>(n - rank), interruption_noted() ? 1 : 0},
      all[2];
  const double begin = now();
  MPI_Allreduce(here, all, 2, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  times.waiting += now() - begin;
  ++times.messages;
  if (all[1] != 0)
    tell_interruption();
  if (all[0] == 0)
    return;
  const unsigned int failed = n - all[0];
  const std::string message = share(std::to_string(static_cast<int>(kind)) + text, failed);
  if (failure)
    std::rethrow_exception(failure);
  fail(static_cast<Failure>(message.at(0) - '0'), message.substr(1));
}

bool Ranks::any(const bool here) const
{
  if (alone())
    return here;
  const double begin = now();
  const int mine = here ? 1 : 0;
  int result = 0;
  MPI_Allreduce(&mine, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  times.waiting += now() - begin;
  ++times.messages;
  return result != 0;
}

void Ranks::share(const std::vector<Piece> &pieces) const
{
  if (alone())
    return;
  std::vector<std::size_t> count(n, 0);
  for (const Piece &piece : pieces)
    count[piece.owner] += piece.size;
  const std::size_t total = std::accumulate(count.begin(), count.end(), std::size_t(0));
  if (total > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw ComputationError("ranks have to exchange more than 2^31 numbers at once: use fewer bodies");
  std::vector<int> counts(count.begin(), count.end()), starts(n, 0);
  std::partial_sum(counts.begin(), counts.end() - 1, starts.begin() + 1);
  // In the order of ranks, within a rank in that of the list.
  std::vector<double> all(total);
  std::vector<double *> at(n);
  for (unsigned int r = 0; r < n; ++r)
    at[r] = all.data() + starts[r];
  for (const Piece &piece : pieces)
    if (piece.owner == rank)
      at[rank] = std::copy_n(piece.begin, piece.size, at[rank]);
  at[rank] = all.data() + starts[rank];
  const double begin = now();
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, all.data(), counts.data(), starts.data(), MPI_DOUBLE,
                 MPI_COMM_WORLD);
  times.waiting += now() - begin;
  ++times.messages;
  times.bytes += (total - count[rank]) * sizeof(double);
  for (const Piece &piece : pieces)
  {
    if (piece.owner != rank)
      std::copy_n(at[piece.owner], piece.size, piece.begin);
    at[piece.owner] += piece.size;
  }
}

std::string Ranks::share(const std::string &text, const unsigned int owner) const
{
  if (alone())
    return text;
  const double begin = now();
  const std::string result = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, text, owner);
  times.waiting += now() - begin;
  times.messages += 2;
  times.bytes += result.size();
  return result;
}

void Ranks::check_alike(const std::vector<double> &numbers) const
{
  if (alone())
    return;
  std::vector<double> of_first = numbers;
  share({{0, of_first.data(), of_first.size()}});
  if (any(std::memcmp(of_first.data(), numbers.data(), numbers.size() * sizeof(double)) != 0))
    throw ComputationError(
        "ranks have come to different results, so the run cannot go on: all have to run on processors of the "
        "same kind, with the same program and libraries");
}

void Ranks::fail_alike(const std::string &why) const
{
  if (alone())
    return;
  constexpr double patience = 10.; // [s]
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for (const double begin = now();;)
  {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done)
      return;
    if (now() - begin > patience)
      break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::cerr << "softgrain: error: rank " << rank << " failed alone: " << why << std::endl;
  MPI_Abort(MPI_COMM_WORLD, 1);
}
} // namespace softgrain
