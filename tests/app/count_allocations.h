// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_app_count_allocations_h
#define softgrain_tests_app_count_allocations_h

// How often a program asks for memory. Included by one file of a program: malloc itself is replaced, for
// Eigen goes around operator new. Sanitizers have a malloc of their own; there operator new alone is counted.
#include <atomic>
#include <cstdlib>
#include <new>

namespace softgrain
{
inline std::atomic<unsigned long> n_allocations{0};

/// Allocations of @p work().
template <class Work>
unsigned long allocations_of(const Work &work)
{
  const unsigned long before = n_allocations;
  work();
  return n_allocations - before;
}
} // namespace softgrain

#ifdef __SANITIZE_ADDRESS__
void *operator new(const std::size_t size)
{
  ++softgrain::n_allocations;
  if (void *memory = std::malloc(size > 0 ? size : 1))
    return memory;
  throw std::bad_alloc();
}
void operator delete(void *memory) noexcept
{
  std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept
{
  std::free(memory);
}
#else
extern "C" void *__libc_malloc(std::size_t size) noexcept;
extern "C" void *malloc(const std::size_t size) noexcept
{
  ++softgrain::n_allocations;
  return __libc_malloc(size);
}
#endif

#endif
