// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exceptions.h>
#include <softgrain/base/exchange.h>
#include <softgrain/base/scattered_numbers.h>
#include <softgrain/base/wait.h>

#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace softgrain
{
void Exchange::bring(const std::vector<Piece> &pieces) const
{
  if (alone())
    return;
  constexpr int tag = 2;
  // Of the first one, what every other one sends; of another, what it sends itself.
  std::vector<ScatteredNumbers> by_owner(number());
  for (const Piece &piece : pieces)
    if (piece.owner != 0 && (first() || piece.owner == here()))
    {
      by_owner[piece.owner].add(piece.begin, piece.size);
      if (first())
        times.bytes += piece.size * sizeof(double);
    }
  const Wait wait(times);
  for (unsigned int r = 1; r < number(); ++r)
  {
    if (by_owner[r].empty())
      continue;
    MPI_Datatype type = by_owner[r].type();
    if (first())
      MPI_Recv(MPI_BOTTOM, 1, type, r, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    else
      MPI_Send(MPI_BOTTOM, 1, type, 0, tag, MPI_COMM_WORLD);
    MPI_Type_free(&type);
  }
}

void Exchange::join_at_first(double *const numbers, const std::size_t size) const
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

void Exchange::swap(const std::vector<Message> &outgoing, const std::vector<Message> &incoming) const
{
  if (outgoing.empty() && incoming.empty())
    return;
  constexpr int tag = 1;
  const Wait wait(times);
  std::vector<MPI_Request> requests;
  requests.reserve(outgoing.size() + incoming.size());
  for (const Message &message : incoming)
  {
    MPI_Irecv(message.begin, message.size, MPI_DOUBLE, message.other, tag, MPI_COMM_WORLD,
              &requests.emplace_back());
    times.bytes += message.size * sizeof(double);
  }
  for (const Message &message : outgoing)
    MPI_Isend(message.begin, message.size, MPI_DOUBLE, message.other, tag, MPI_COMM_WORLD,
              &requests.emplace_back());
  MPI_Waitall(requests.size(), requests.data(), MPI_STATUSES_IGNORE);
}

void Exchange::swap(std::vector<std::vector<double>> &leave, std::vector<std::vector<double>> &come) const
{
  const auto messages = [](std::vector<std::vector<double>> &lists)
  {
    std::vector<Message> list;
    for (unsigned int r = 0; r < lists.size(); ++r)
      if (!lists[r].empty())
        list.push_back({r, lists[r].data(), lists[r].size()});
    return list;
  };
  swap(messages(leave), messages(come));
}

Exchange::OwnWork::OwnWork(const Exchange &exchange) : exchange(exchange)
{
  if (exchange.alone())
    return;
  own = exchange.times.own;
  spinning = exchange.times.spinning;
  begin = processor_seconds();
}

Exchange::OwnWork::~OwnWork()
{
  // What has been booked in between is in it.
  if (!exchange.alone())
    exchange.times.own = own + processor_seconds() - begin - (exchange.times.spinning - spinning);
}

std::vector<std::vector<double>> Exchange::lists_of_all(const std::vector<double> &list) const
{
  const std::vector<std::vector<double>> sizes = of_all({static_cast<double>(list.size())});
  std::vector<std::vector<double>> lists(number());
  std::vector<Piece> pieces;
  for (unsigned int r = 0; r < number(); ++r)
  {
    lists[r].resize(static_cast<std::size_t>(sizes[r][0]));
    if (r == here())
      lists[r] = list;
    pieces.push_back({r, lists[r].data(), lists[r].size()});
  }
  share(pieces);
  return lists;
}

std::vector<std::vector<double>> Exchange::to_each(std::vector<std::vector<double>> lists) const
{
  std::vector<double> sizes;
  for (const std::vector<double> &list : lists)
    sizes.push_back(list.size());
  const std::vector<std::vector<double>> sizes_of_all = of_all(sizes);
  std::vector<std::vector<double>> came(number());
  std::vector<Message> outgoing, incoming;
  for (unsigned int r = 0; r < number(); ++r)
  {
    if (r == here())
    {
      came[r] = std::move(lists[r]);
      continue;
    }
    came[r].resize(static_cast<std::size_t>(sizes_of_all[r][here()]));
    if (!lists[r].empty())
      outgoing.push_back({r, lists[r].data(), lists[r].size()});
    if (!came[r].empty())
      incoming.push_back({r, came[r].data(), came[r].size()});
  }
  swap(outgoing, incoming);
  return came;
}

std::vector<std::vector<double>> Exchange::lists_at_first(std::vector<double> list) const
{
  std::vector<std::vector<double>> lists(number());
  lists[0] = std::move(list);
  return to_each(std::move(lists));
}

void Exchange::check_alike(const std::vector<double> &numbers) const
{
  if (alone())
    return;
  // Everyone sees those of all, and so comes to the same verdict.
  const std::vector<std::vector<double>> by_owner = of_all(numbers);
  const auto differs = [&](const std::vector<double> &others)
  { return std::memcmp(others.data(), by_owner[0].data(), others.size() * sizeof(double)) != 0; };
  if (std::any_of(by_owner.begin(), by_owner.end(), differs))
    throw ComputationError(
        "ranks have come to different results, so the run cannot go on: all have to run on processors of the "
        "same kind, with the same program and libraries");
}
} // namespace softgrain
