// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_outlook_h
#define softgrain_app_outlook_h

#include <softgrain/app/input.h>
#include <softgrain/model/forecast.h>

namespace softgrain
{
/**
 * @brief Foretells how long the run of @p input will be: its walls move as they are driven, and nothing
 * resists them.
 *
 * Walls under pressure stand still, because how they move only the run itself can tell.
 * @return nothing when the packing cannot say what bodies it will bring
 */
std::optional<RunOutline> outline_of(Input &input);
} // namespace softgrain

#endif
