// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_units_h
#define softgrain_output_units_h

#include <string>

namespace softgrain
{
class Hdf5Writer;

/**
 * @brief The unit that the end of a name says, in the notation of UDUNITS: "Pa" for `stress_Pa`, "kg m/s",
 * "m^2".
 * @return "1" for a pure number
 */
std::string unit_of(const std::string &name);

/// Gives every array of numbers that is not a list of indices the attribute `units`.
void write_units(Hdf5Writer &file);
} // namespace softgrain

#endif
