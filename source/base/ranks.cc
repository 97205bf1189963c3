// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/failure.h>
#include <softgrain/base/interruption.h>
#include <softgrain/base/ranks.h>
#include <softgrain/base/scattered_numbers.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <iostream>
#include <limits>
#include <numeric>
#include <thread>

namespace softgrain
{
namespace
{
double seconds()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Books what passes while it lives as waiting.
class Wait
{
public:
  explicit Wait(RankTimes &times) : times(times), begin(seconds()), processor_begin(processor_seconds()) {}
  ~Wait()
  {
    times.waiting += seconds() - begin;
    times.spinning += processor_seconds() - processor_begin;
    ++times.messages;
  }
  Wait(const Wait &) = delete;

private:
  RankTimes &times;
  const double begin, processor_begin;
};

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

double processor_seconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
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

void Ranks::bring(const std::vector<Piece> &pieces) const
{
  if (alone())
    return;
  constexpr int tag = 2;
  // Of the first rank, what every other one sends; of another, what it sends itself.
  std::vector<ScatteredNumbers> of_ranks(n);
  for (const Piece &piece : pieces)
    if (piece.owner != 0 && (first() || piece.owner == rank))
    {
      of_ranks[piece.owner].add(piece.begin, piece.size);
      if (first())
        times.bytes += piece.size * sizeof(double);
    }
  const Wait wait(times);
  for (unsigned int r = 1; r < n; ++r)
  {
    if (of_ranks[r].empty())
      continue;
    MPI_Datatype type = of_ranks[r].type();
    if (first())
      MPI_Recv(MPI_BOTTOM, 1, type, r, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    else
      MPI_Send(MPI_BOTTOM, 1, type, 0, tag, MPI_COMM_WORLD);
    MPI_Type_free(&type);
  }
}

void Ranks::join_at_first(double *const numbers, const std::size_t size) const
{
  if (alone())
    return;
  static_assert(sizeof(double) == sizeof(std::uint64_t), "numbers are joined by their bits");
  const Wait wait(times);
  constexpr std::size_t most = std::numeric_limits<int>::max(); // MPI counts with an int
  for (std::size_t begin = 0; begin < size; begin += most)
    MPI_Reduce(first() ? MPI_IN_PLACE : numbers + begin, numbers + begin,
               static_cast<int>(std::min(most, size - begin)), MPI_UINT64_T, MPI_BOR, 0, MPI_COMM_WORLD);
  if (first())
    times.bytes += size * sizeof(double);
}

void Ranks::swap(const std::vector<Message> &outgoing, const std::vector<Message> &incoming) const
{
  if (outgoing.empty() && incoming.empty())
    return;
  constexpr int tag = 1;
  const Wait wait(times);
  std::vector<MPI_Request> requests;
  requests.reserve(outgoing.size() + incoming.size());
  for (const Message &message : incoming)
  {
    MPI_Irecv(message.begin, message.size, MPI_DOUBLE, message.rank, tag, MPI_COMM_WORLD,
              &requests.emplace_back());
    times.bytes += message.size * sizeof(double);
  }
  for (const Message &message : outgoing)
    MPI_Isend(message.begin, message.size, MPI_DOUBLE, message.rank, tag, MPI_COMM_WORLD,
              &requests.emplace_back());
  MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
}

Ranks::OwnWork::OwnWork(const Ranks &ranks) : ranks(ranks)
{
  if (ranks.alone())
    return;
  own = ranks.times.own;
  spinning = ranks.times.spinning;
  begin = processor_seconds();
}

Ranks::OwnWork::~OwnWork()
{
  // What has been booked in between is in it.
  if (!ranks.alone())
    ranks.times.own = own + processor_seconds() - begin - (ranks.times.spinning - spinning);
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

std::vector<std::vector<double>> Ranks::lists_of_all(const std::vector<double> &list) const
{
  const std::vector<std::vector<double>> sizes = of_all({static_cast<double>(list.size())});
  std::vector<std::vector<double>> lists(n);
  std::vector<Piece> pieces;
  for (unsigned int r = 0; r < n; ++r)
  {
    lists[r].resize(static_cast<std::size_t>(sizes[r][0]));
    if (r == rank)
      lists[r] = list;
    pieces.push_back({r, lists[r].data(), lists[r].size()});
  }
  share(pieces);
  return lists;
}

std::vector<std::vector<double>> Ranks::to_each(std::vector<std::vector<double>> lists) const
{
  std::vector<double> sizes;
  for (const std::vector<double> &list : lists)
    sizes.push_back(list.size());
  const std::vector<std::vector<double>> sizes_of_all = of_all(sizes);
  std::vector<std::vector<double>> came(n);
  std::vector<Message> outgoing, incoming;
  for (unsigned int r = 0; r < n; ++r)
  {
    if (r == rank)
    {
      came[r] = std::move(lists[r]);
      continue;
    }
    came[r].resize(static_cast<std::size_t>(sizes_of_all[r][rank]));
    if (!lists[r].empty())
      outgoing.push_back({r, lists[r].data(), lists[r].size()});
    if (!came[r].empty())
      incoming.push_back({r, came[r].data(), came[r].size()});
  }
  swap(outgoing, incoming);
  return came;
}

std::vector<std::vector<double>> Ranks::lists_at_first(std::vector<double> list) const
{
  std::vector<std::vector<double>> lists(n);
  lists[0] = std::move(list);
  return to_each(std::move(lists));
}

void Ranks::check_alike(const std::vector<double> &numbers) const
{
  if (alone())
    return;
  // Everyone sees those of all, and so comes to the same verdict.
  const std::vector<std::vector<double>> of_ranks = of_all(numbers);
  const auto differs = [&](const std::vector<double> &others)
  { return std::memcmp(others.data(), of_ranks[0].data(), others.size() * sizeof(double)) != 0; };
  if (std::any_of(of_ranks.begin(), of_ranks.end(), differs))
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
  for (const double begin = seconds();;)
  {
    int done = 0;
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done)
      return;
    if (seconds() - begin > patience)
      break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  std::cerr << "softgrain: error: rank " << rank << " failed alone: " << why << std::endl;
  MPI_Abort(MPI_COMM_WORLD, 1);
}
} // namespace softgrain
