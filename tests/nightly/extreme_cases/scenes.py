# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scenes of the cases: one disk, two disks, grains in a box, of material points and of bonded primaries."""

MATERIAL = """
subsection Materials
  set Names = gel
  subsection gel
    set Law     = neo_hookean
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1e6
      set Poisson's ratio = 0.3
    end
  end
end
"""

# A disk of radius 5 mm between two plates, squeezed by 10 %, 10 cells wide.
ONE = MATERIAL + """
subsection Mesh
  set Lower     = -10e-3, -7e-3
  set Upper     = 10e-3, 7e-3
  set Cell size = 1e-3
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 0.02
end
subsection Bodies
  set Names = disk
  subsection disk
    set Center = 0, 0
    set Radius = 5e-3
  end
end
subsection Walls
  set Names = bottom, top
  subsection bottom
    set Point = 0, -5e-3
  end
  subsection top
    set Point    = 0, 5e-3
    set Velocity = 10e-3
  end
end
subsection Stop
  set End time = 0.1
end
"""

# Two of them that meet at 2 m/s, bounce and part.
TWO = MATERIAL.replace("set Names = gel", "set Names = gel, other").replace("""  subsection gel
""", """  subsection other
    set Law     = neo_hookean
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1e6
      set Poisson's ratio = 0.3
    end
  end
  subsection gel
""") + """
subsection Mesh
  set Lower     = -15e-3, -8e-3
  set Upper     = 15e-3, 8e-3
  set Cell size = 1e-3
end
subsection Time
  set Theta        = 0.5
  set CFL multiple = 2
end
subsection Bodies
  set Names = left, right
  subsection left
    set Material = gel
    set Center   = -5.1e-3, 0
    set Radius   = 5e-3
    set Velocity = 1; 0
  end
  subsection right
    set Material = other
    set Center   = 5.1e-3, 0
    set Radius   = 5e-3
    set Velocity = -1; 0
  end
end
subsection Stop
  set End time = 1.5e-3
end
"""

# Eight grains in a box whose top comes down.
GRAINS = MATERIAL + """
subsection Mesh
  set Lower     = -1e-3, -1e-3
  set Upper     = 7e-3, 7e-3
  set Cell size = 3.2e-4
end
subsection Packing
  set Number            = 8
  set Smallest diameter = 1.4e-3
  set Largest diameter  = 2.4e-3
  set Upper             = 6e-3, 6e-3
end
subsection Time
  set CFL multiple = 4
end
subsection Walls
  set Names = bottom, top, left, right
  subsection top
    set Point    = 0, 6e-3
    set Velocity = 2
  end
  subsection right
    set Point = 6e-3, 0
  end
end
subsection Stop
  set End time         = 1.4e-3
  set Packing fraction = 0.9
end
"""

# A grain of forty bonded primaries between two walls.
BONDED = """
set Model = bpm
subsection Materials
  set Names = grain
  subsection grain
    set Law     = power_law
    set Density = 2000
    subsection Power law
      set Force at contact = 100
    end
  end
end
subsection Bodies
  set Names = disk
  subsection disk
    set Center = 0, 0
    set Radius = 1e-3
  end
end
subsection Primaries
  set Smallest diameter = 0.2e-3
  set Largest diameter  = 0.3e-3
  set Number per body   = 40
end
subsection Walls
  set Names = bottom, top
  subsection bottom
    set Point = 0, -1.1e-3
  end
  subsection top
    set Point    = 0, 1.1e-3
    set Velocity = 0.2
  end
end
subsection Stop
  set End time = 2e-3
end
"""

# Six such grains in a box whose top comes down.
BONDED_GRAINS = BONDED.split("subsection Bodies")[0] + """
subsection Packing
  set Number            = 6
  set Smallest diameter = 1.8e-3
  set Largest diameter  = 2.2e-3
  set Upper             = 6e-3, 6e-3
end
subsection Primaries
  set Smallest diameter = 0.2e-3
  set Largest diameter  = 0.3e-3
end
subsection Walls
  set Names = bottom, top, left, right
  subsection top
    set Point    = 0, 6e-3
    set Velocity = 2
  end
  subsection right
    set Point = 6e-3, 0
  end
end
subsection Stop
  set End time = 5e-4
end
"""
