// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_base_scattered_numbers_h
#define softgrain_base_scattered_numbers_h

#include <mpi.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace softgrain
{
/// Numbers that lie in several places, as one message of MPI.
class ScatteredNumbers
{
public:
  void add(double *const begin, const std::size_t size)
  {
    // MPI counts with an int.
    constexpr std::size_t most = std::numeric_limits<int>::max();
    for (std::size_t first = 0; first < size; first += most)
    {
      MPI_Aint place;
      MPI_Get_address(begin + first, &place);
      places.push_back(place);
      sizes.push_back(static_cast<int>(std::min(most, size - first)));
    }
  }
  bool empty() const { return places.empty(); }
  /// The type of these numbers for MPI, which the caller has to free.
  MPI_Datatype type() const
  {
    MPI_Datatype result;
    MPI_Type_create_hindexed(sizes.size(), sizes.data(), places.data(), MPI_DOUBLE, &result);
    MPI_Type_commit(&result);
    return result;
  }

private:
  std::vector<MPI_Aint> places;
  std::vector<int> sizes;
};
} // namespace softgrain

#endif
