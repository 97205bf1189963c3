// SPDX-License-Identifier: LGPL-2.1-or-later
// Stable headers of what knows no deal.II: the kernel of contact.
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>
