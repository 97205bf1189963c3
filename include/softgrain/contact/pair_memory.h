// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_contact_pair_memory_h
#define softgrain_contact_pair_memory_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace softgrain::contact
{
/// Impulses that pairs remember of their contacts: normal, tangential, rolling, of each pair as many as there
/// are in the scene [N s/m, the last N s].
class PairMemory
{
public:
  /// All three; those that the scene does not have are zero.
  using Impulses = std::array<double, 3>;

  /// @param n_impulses of a pair: 1 without friction, 2 with it, 3 with rolling resistance
  explicit PairMemory(const unsigned int n_impulses = 3) : width(n_impulses) {}

  unsigned int n_impulses() const { return width; }
  std::size_t size() const { return numbers.size() / width; }

  /// Makes @p n_pairs pairs that remember nothing.
  void assign(const std::size_t n_pairs) { numbers.assign(n_pairs * width, 0.); }

  Impulses operator[](const std::size_t pair) const
  {
    Impulses impulses{};
    std::copy_n(&numbers[pair * width], width, impulses.begin());
    return impulses;
  }
  void set(const std::size_t pair, const Impulses &impulses)
  {
    std::copy_n(impulses.begin(), width, &numbers[pair * width]);
  }
  /// Pairs from @p begin to @p end, without it, remember nothing.
  void forget(const std::size_t begin, const std::size_t end)
  {
    std::fill(numbers.begin() + begin * width, numbers.begin() + end * width, 0.);
  }
  bool remembers(const std::size_t pair) const { return (*this)[pair] != Impulses{}; }

  /// Pair after pair.
  std::vector<double> &values() { return numbers; }
  const std::vector<double> &values() const { return numbers; }

private:
  unsigned int width;
  std::vector<double> numbers;
};
} // namespace softgrain::contact

#endif
