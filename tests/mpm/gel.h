// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_gel_h
#define softgrain_tests_mpm_gel_h

#include <string>

namespace softgrain
{
/// Text of the one material of a scene: a neo-Hookean gel of 10 MPa.
inline std::string gel(const std::string &poisson_ratio)
{
  return R"(
subsection Materials
  set Names = gel
  subsection gel
    set Law     = neo_hookean
    set Density = 990
    subsection Neo-Hookean
      set Young's modulus = 10e6
      set Poisson's ratio = )" +
         poisson_ratio + R"(
    end
  end
end
)";
}
} // namespace softgrain

#endif
