// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_exchange_h
#define softgrain_base_exchange_h

#include <softgrain/base/ranks.h>

#include <cstddef>
#include <vector>

namespace softgrain
{
/**
 * @brief Numbers and lists that those who compute one scene together tell each other: the one place through
 * which the parts of a model ask for what others have.
 *
 * A list of lists has one for each of them, in their order. All call the same in the same order; only swap()
 * is between those who have something for each other.
 */
class Exchange : public Ranks
{
public:
  /// Copies pieces from their owners to the first one, without a copy on the way. All have the same list; of
  /// the places it names, an owner needs its own, and the first one all.
  void bring(const std::vector<Piece> &pieces) const;

  /// Brings numbers each of which one has to the first one, where the others have +0. The others keep what
  /// they have.
  void join_at_first(double *numbers, std::size_t size) const;

  /// Lists of all, where each has one of its own length.
  std::vector<std::vector<double>> lists_of_all(const std::vector<double> &list) const;

  /// Sends list r of @p lists to number r. @return those that came here
  std::vector<std::vector<double>> to_each(std::vector<std::vector<double>> lists) const;

  /// The lists of all on the first one, empty ones on the others.
  std::vector<std::vector<double>> lists_at_first(std::vector<double> list) const;

  /// Does @p work together, after which all know the numbers that it has put into its list: as many on each.
  /// @param numbers what they are where it has failed
  template <class Work>
  std::vector<std::vector<double>> told_by_all(const std::vector<double> &numbers, const Work &work) const
  {
    std::vector<std::vector<double>> told(number(), numbers);
    together([&]() { work(told[here()]); },
             [&]()
             {
               std::vector<Piece> pieces;
               for (unsigned int r = 0; r < told.size(); ++r)
                 pieces.push_back({r, told[r].data(), told[r].size()});
               return pieces;
             });
    return told;
  }

  /// Numbers in memory that another one sends, or gets.
  struct Message
  {
    unsigned int other; ///< its number
    double *begin;
    std::size_t size;
  };

  /// Sends @p outgoing and waits for @p incoming; at most one message to and from every other one, and what
  /// one sends here, this one expects. Nobody else has to come.
  void swap(const std::vector<Message> &outgoing, const std::vector<Message> &incoming) const;
  /// Sends lists that are not empty, and fills those that come, whose sizes are known.
  void swap(std::vector<std::vector<double>> &leave, std::vector<std::vector<double>> &come) const;

  /**
   * @brief Makes sure that all have come to the same, to the last bit: they decide by it.
   * @throw ComputationError for all when they have not, as on machines whose processors differ
   */
  void check_alike(const std::vector<double> &numbers) const;

  /// What passes while it lives is own work, but for what it waits, and what goes through together().
  class OwnWork
  {
  public:
    explicit OwnWork(const Exchange &exchange);
    ~OwnWork();
    OwnWork(const OwnWork &) = delete;
    OwnWork &operator=(const OwnWork &) = delete;

  private:
    const Exchange &exchange;
    double begin = 0., own = 0., spinning = 0.; ///< [processor s]
  };
};
} // namespace softgrain

#endif
