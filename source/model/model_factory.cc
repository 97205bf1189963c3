// SPDX-License-Identifier: LGPL-2.1-or-later
#include <softgrain/model/model_factory.h>

SOFTGRAIN_DEFINE_REGISTRY(softgrain::ModelFactory)
