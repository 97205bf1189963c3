// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/base/exact_sum.h>
#include <softgrain/base/exchange.h>

#include <cmath>
#include <cstring>

namespace softgrain
{
namespace
{
constexpr unsigned int digit_bits = 32;
constexpr std::uint64_t digit_mask = (std::uint64_t(1) << digit_bits) - 1;
/// Exponent of the lowest bit of the lowest digit: that of the smallest double.
constexpr int lowest_exponent = -1074;
} // namespace

void ExactSum::add(const double number)
{
  std::uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  constexpr std::uint64_t hidden = std::uint64_t(1) << 52;
  const unsigned int exponent = (bits >> 52) & 0x7ff;
  if (exponent == 0x7ff)
  {
    not_finite += number;
    return;
  }
  const std::uint64_t mantissa = (bits & (hidden - 1)) | (exponent > 0 ? hidden : 0);
  // Of the lowest bit of the mantissa.
  const unsigned int place = exponent > 0 ? exponent - 1 : 0;
  const unsigned int shift = place % digit_bits;
  const std::uint64_t low = (mantissa & digit_mask) << shift, high = (mantissa >> digit_bits) << shift;
  const std::int64_t parts[3] = {static_cast<std::int64_t>(low & digit_mask),
                                 static_cast<std::int64_t>((low >> digit_bits) + (high & digit_mask)),
                                 static_cast<std::int64_t>(high >> digit_bits)};
  std::int64_t *const at = &digits[place / digit_bits];
  const std::int64_t sign = bits >> 63 ? -1 : 1;
  for (unsigned int i = 0; i < 3; ++i)
    at[i] += sign * parts[i];
}

void ExactSum::carry(Digits &digits)
{
  for (unsigned int i = 0; i + 1 < n_digits; ++i)
  {
    const std::int64_t rest = digits[i] & static_cast<std::int64_t>(digit_mask);
    digits[i + 1] += (digits[i] - rest) / (std::int64_t(1) << digit_bits);
    digits[i] = rest;
  }
}

void ExactSum::add(const ExactSum &other)
{
  Digits theirs = other.digits;
  carry(theirs);
  for (unsigned int i = 0; i < n_digits; ++i)
    digits[i] += theirs[i];
  not_finite += other.not_finite;
}

double ExactSum::value() const
{
  if (not_finite != 0.) // also where it is not a number
    return not_finite;
  Digits sum = digits;
  carry(sum);
  const bool negative = sum.back() < 0;
  if (negative)
  {
    for (std::int64_t &digit : sum)
      digit = -digit;
    carry(sum);
  }
  unsigned int n = n_digits;
  while (n > 0 && sum[n - 1] == 0)
    --n;
  if (n == 0)
    return 0.;
  const auto digit = [&](const unsigned int below) -> std::uint64_t
  { return n > below ? static_cast<std::uint64_t>(sum[n - 1 - below]) : 0; };
  // The highest 64 bits, of which a double keeps 53. Rounding digit by digit would depend on where a digit
  // begins, so that a sum of the same numbers in another unit had other bits.
  std::uint64_t bits = (digit(0) << digit_bits) | digit(1);
  unsigned int shift = 0;
  while (!(bits >> 63))
  {
    bits <<= 1;
    ++shift;
  }
  bits |= (digit(2) << shift) >> digit_bits;
  bool more = ((digit(2) << shift) & digit_mask) != 0;
  for (unsigned int i = 3; i < n && !more; ++i)
    more = digit(i) != 0;
  const double result = std::ldexp(
      static_cast<double>(bits | (more ? 1 : 0)),
      lowest_exponent + (static_cast<int>(n) - 2) * static_cast<int>(digit_bits) - static_cast<int>(shift));
  return negative ? -result : result;
}

void ExactSum::pack(std::vector<double> &numbers) const
{
  Digits sum = digits;
  carry(sum);
  numbers.insert(numbers.end(), sum.begin(), sum.end());
  numbers.push_back(not_finite);
}

void ExactSum::add_packed(const double *&number)
{
  for (std::int64_t &digit : digits)
    digit += static_cast<std::int64_t>(*number++);
  not_finite += *number++;
}

void add_over_all(std::vector<ExactSum> &sums, const Exchange &exchange)
{
  if (exchange.alone())
    return;
  std::vector<double> here;
  for (const ExactSum &sum : sums)
    sum.pack(here);
  sums.assign(sums.size(), ExactSum());
  for (const std::vector<double> &packed : exchange.of_all(here))
  {
    const double *number = packed.data();
    for (ExactSum &sum : sums)
      sum.add_packed(number);
  }
}
} // namespace softgrain
