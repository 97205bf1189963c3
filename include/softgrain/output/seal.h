// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_output_seal_h
#define softgrain_output_seal_h

#include <string>

namespace softgrain
{
/// @name A line at the end of a file with the CRC-32 of all bytes before it. HDF5 ignores what follows its
/// last byte, and may crash on damaged files: who looks at the seal first never shows it one.
///@{

/// Puts the seal behind a file. @throw ComputationError "cannot write PATH: REASON"
void seal(const std::string &path);

/// Whether a file ends with the seal of what comes before.
bool is_sealed(const std::string &path);
///@}
} // namespace softgrain

#endif
