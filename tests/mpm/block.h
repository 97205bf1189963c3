// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef softgrain_tests_mpm_block_h
#define softgrain_tests_mpm_block_h

#include <string>

namespace softgrain
{
/// Smooth walls below and above the block.
inline const std::string plates = R"(
subsection Walls
  set Names = bottom, top
  subsection top
    set Point = 0, 10e-3
  end
end
)";

/// Smooth walls on all sides of the block.
inline const std::string box = R"(
subsection Walls
  set Names = bottom, top, left, right
  subsection top
    set Point = 0, 10e-3
  end
  subsection right
    set Point = 10e-3, 0
  end
end
)";

/// A scene without inertia: a block of 10 mm that its walls touch. @param material section of its material
inline std::string block(const std::string &material, const std::string &walls = plates)
{
  return R"(
subsection Mesh
  set Lower     = -2e-3, -2e-3
  set Upper     = 12e-3, 12e-3
  set Cell size = 2e-3
end
subsection Materials
  set Names = stuff
  subsection stuff
)" + material +
         R"(
  end
end
subsection Bodies
  set Names = block
  subsection block
    set Shape  = rectangle
    set Center = 5e-3, 5e-3
    set Size   = 10e-3, 10e-3
  end
end
)" + walls +
         R"(
subsection Time
  set Scheme    = quasi_static
  set Time step = 0.25
end
subsection Stop
  set End time = 2
end
)";
}
} // namespace softgrain

#endif
