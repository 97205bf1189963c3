// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_ranks_h
#define softgrain_base_ranks_h

#include <softgrain/base/rank_times.h>

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

namespace softgrain
{
/**
 * @brief The processes that compute one scene together, as mpirun has started them; without it, one.
 *
 * All ranks go the same way through the program: what is done by one of them alone, or by each for its share,
 * stands in together() or at_first(). These end alike on all ranks, with an exception when any rank had one,
 * so that no rank waits for one that has left.
 *
 * With one rank nothing is sent, copied or timed. What the parts of a model have to tell each other goes by
 * an Exchange.
 */
class Ranks
{
public:
  /// Those of this program; MPI need not have been started when there is but one.
  Ranks();

  unsigned int number() const { return n; }
  unsigned int here() const { return rank; }
  bool alone() const { return n == 1; }
  /// Whether this rank is the one that writes and speaks.
  bool first() const { return rank == 0; }

  /// Numbers in memory that one rank knows.
  struct Piece
  {
    unsigned int owner;
    double *begin;
    std::size_t size; ///< the same on all ranks
  };

  /**
   * @brief Calls @p work on every rank, each for its share, and waits until all are done.
   *
   * @p work must not meet other ranks itself. A request to stop the program that has come to any rank is
   * known to all of them afterwards (interruption.h).
   * @throw the exception of this rank, else one that says what that of the lowest rank said
   */
  template <class Work>
  void together(const Work &work) const
  {
    together(work, []() { return std::vector<Piece>(); });
  }

  /// Does @p work together, and then share() of what @p pieces() names, in one exchange. The sizes of pieces
  /// must be alike on all ranks also when @p work has failed.
  template <class Work, class Pieces>
  void together(const Work &work, const Pieces &pieces) const
  {
    std::exception_ptr failure;
    const double begin = alone() ? 0. : processor_seconds();
    try
    {
      // Called here alone: where the compiler copies it to two places, it may round differently in each, and
      // one rank would not find what several do.
      work();
    }
    catch (...)
    {
      if (alone())
        throw;
      failure = std::current_exception();
    }
    if (alone())
      return;
    times.own += processor_seconds() - begin;
    exchange(pieces(), failure);
  }

  /// Calls @p work on the first rank only; how it ends, it ends for all.
  template <class Work>
  void at_first(const Work &work) const
  {
    together(
        [&]()
        {
          if (first())
            work();
        });
  }

  /// Whether it is so on any rank.
  bool any(bool here) const;

  /// Copies pieces from their owners to all. Every rank has the same list, with its own places.
  void share(const std::vector<Piece> &pieces) const;

  /// @p numbers of every rank, as many on each; first those of the first rank.
  std::vector<std::vector<double>> of_all(const std::vector<double> &numbers) const;

  /// The text that @p owner has.
  std::string share(const std::string &text, unsigned int owner) const;

  /**
   * @brief Waits on a rank that has caught what ends the run, and returns when all ranks have, which is so
   * when all went the same way. When some do not come within ten seconds, it ends the program on all ranks,
   * with exit code 1 and a line that says @p why: they would wait for this one for ever.
   */
  void fail_alike(const std::string &why) const;

  RankTimes taken() const { return times; }

protected:
  mutable RankTimes times;

private:
  void exchange(const std::vector<Piece> &pieces, const std::exception_ptr &failure) const;

  unsigned int n = 1, rank = 0;
  mutable std::vector<double> all; ///< what is exchanged; kept, for fresh memory is dear
};
} // namespace softgrain

#endif
