// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/bpm/attraction.h>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::bpm::Attraction)
