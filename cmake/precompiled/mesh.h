// SPDX-License-Identifier: LGPL-2.1-or-later
// Stable headers that sources of material points need beside those of base.h.
#include "base.h"

#include <deal.II/base/timer.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/particles/property_pool.h>

#include <Eigen/SparseCore>
