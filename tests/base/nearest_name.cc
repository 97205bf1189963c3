// SPDX-License-Identifier: LGPL-2.1-or-later
// Edit distances with known values, and the suggestion a user gets for a misspelt name.
#include <softgrain/base/nearest_name.h>

#include <iostream>

int main()
{
  using namespace softgrain;
  std::cout << edit_distance("kitten", "sitting") << '\n'
            << edit_distance("thete", "Theta") << '\n'
            << edit_distance("tiem", "time") << '\n'
            << nearest_name("neo_hokean", {"hencky", "linear_elastic", "neo_hookean"}) << '\n'
            << '[' << nearest_name("banana", {"hencky", "linear_elastic"}) << "]\n"
            << join({"a", "b"}) << '\n'
            << join({}) << '\n';
}
