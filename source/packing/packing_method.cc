// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/packing/packing_method.h>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::PackingMethod<2>)
SOFTGRAIN_DEFINE_REGISTRY(softgrain::PackingMethod<3>)
