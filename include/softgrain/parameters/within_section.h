// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_parameters_within_section_h
#define softgrain_parameters_within_section_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace softgrain
{
/**
 * @brief Stands in a section of a ParameterHandler as long as it lives, so that the handler comes out of it
 * after an exception, too: whoever collects mistakes goes on reading.
 */
class WithinSection
{
public:
  WithinSection(dealii::ParameterHandler &prm, const std::string &section) : prm(prm)
  {
    prm.enter_subsection(section);
  }
  ~WithinSection() { prm.leave_subsection(); }
  WithinSection(const WithinSection &) = delete;
  WithinSection &operator=(const WithinSection &) = delete;

private:
  dealii::ParameterHandler &prm;
};
} // namespace softgrain

#endif
