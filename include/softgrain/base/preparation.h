// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_preparation_h
#define softgrain_base_preparation_h

#include <chrono>
#include <cstddef>
#include <mutex>
#include <streambuf>
#include <string>

namespace softgrain
{
/**
 * @brief Tells how far something that is made before a run has come, once it takes longer than part of a
 * second.
 *
 * What it tells goes to std::clog; PreparationLog says where that leads. All threads may tell.
 */
class Preparation
{
public:
  /// @param what is made, as "aggregates" @param n how many parts it has
  Preparation(const std::string &what, std::size_t n);

  /// One more part is done.
  void advance();
  /// This share of it is done, from 0 to 1.
  void reach(double share);

private:
  using Clock = std::chrono::steady_clock;

  /// Whether it is time to tell something.
  bool is_due();

  const std::string what;
  const std::size_t n;
  std::size_t n_done = 0;
  std::mutex mutex;
  const Clock::time_point begin = Clock::now();
  Clock::time_point last = begin;
};

/// Brings what Preparation tells to where results go, std::cout, as long as it lives.
class PreparationLog
{
public:
  /// @param prints whether anything is printed at all: one of several processes does
  explicit PreparationLog(bool prints);
  ~PreparationLog();

  PreparationLog(const PreparationLog &) = delete;
  PreparationLog &operator=(const PreparationLog &) = delete;

private:
  std::streambuf *const before;
};
} // namespace softgrain

#endif
