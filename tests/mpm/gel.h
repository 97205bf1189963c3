// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_gel_h
#define softgrain_tests_mpm_gel_h

#include <string>

namespace softgrain
{
/// Text of the one material of a scene: a neo-Hookean gel, of 10 MPa where nothing else is said.
inline std::string gel(const std::string &poisson_ratio,
                       const std::string &young_modulus = "10e6",
                       const std::string &density = "990")
{
  return R"(
subsection Materials
  set Names = gel
  subsection gel
    set Law     = neo_hookean
    set Density = )" +
         density + R"(
    subsection Neo-Hookean
      set Young's modulus = )" +
         young_modulus + R"(
      set Poisson's ratio = )" +
         poisson_ratio + R"(
    end
  end
end
)";
}
} // namespace softgrain

#endif
