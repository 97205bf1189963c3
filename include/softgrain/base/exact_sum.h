// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_exact_sum_h
#define softgrain_base_exact_sum_h

#include <array>
#include <cstdint>
#include <vector>

namespace softgrain
{
class Exchange;

/**
 * @brief A sum of many numbers without any rounding on the way: the same to the last bit in whatever order,
 * by however many threads and processes they are added.
 *
 * A number of fixed point as long as all that a double can be, in digits of 32 bits (Kulisch's accumulator).
 * A number takes a few ns. Good for 2^30 numbers.
 */
class ExactSum
{
public:
  void add(double number);
  void add(const ExactSum &other);

  /// The sum, rounded once to the nearest double; not a number or infinite when a number was.
  double value() const;

  /// Puts the sum behind @p numbers that go elsewhere; add_packed() adds it to a sum there.
  void pack(std::vector<double> &numbers) const;
  /// @param number first of those that pack() has made; is moved behind them
  void add_packed(const double *&number);

private:
  /// Digits that reach from 2^-1074 to 2^1024, with room for the sum of many numbers.
  static constexpr unsigned int n_digits = 68;
  using Digits = std::array<std::int64_t, n_digits>;

  /// All but the highest from 0 to below 2^32.
  static void carry(Digits &digits);

  Digits digits{};
  double not_finite = 0.; ///< sum of what is no number; else 0
};

/// Adds to each of @p sums what others have in theirs; all have as many.
void add_over_all(std::vector<ExactSum> &sums, const Exchange &exchange);
} // namespace softgrain

#endif
