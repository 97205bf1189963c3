// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_app_check_report_h
#define softgrain_app_check_report_h

#include <softgrain/model/model.h>

#include <iosfwd>

namespace softgrain
{
class Input;

/// What `softgrain check` prints: the scene in numbers, the model's sizes and cost, what would be written.
void print_check_report(std::ostream &out, const Input &input, const Model<2> &model);
} // namespace softgrain

#endif
