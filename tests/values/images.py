# SPDX-License-Identifier: LGPL-2.1-or-later
"""Images of the scene squeezed_between_plates.prm, and how far what becomes of them is from the image of what became of the scene."""
import math

CELL = 1e-4
SCENE = "squeezed_between_plates.prm"
CENTER = (1.3e-5, 2.7e-5)
PLATES = {"first": ((0., -3.73e-4), (0., 1.), 0.), "second": ((0., 4.27e-4), (0., -1.), 1.)}  # point, normal, velocity
ANGLE = 25.
REACH = 4e-4 * math.hypot(math.cos(math.radians(65)), 0.75 * math.sin(math.radians(65)))  # of the ellipse, upwards
SHAPES = {"disk": {"Shape": "disk", "Radius": 4e-4}, "ring": {"Shape": "disk", "Radius": 4e-4, "Inner radius": 1.5e-4},
          "ellipse": {"Shape": "ellipse", "Semi-axes": "4e-4, 3e-4"}}


def pair(values):
    """As --set wants them."""
    return ", ".join(repr(float(value)) for value in values)


class Image:
    """x goes to the matrix times x, plus whole cells."""

    def __init__(self, matrix=((1, 0), (0, 1)), cells=(0, 0)):
        self.matrix, self.cells = matrix, cells

    def way(self, v):
        return tuple(self.matrix[d][0] * v[0] + self.matrix[d][1] * v[1] for d in range(2))

    def place(self, x):
        turned = self.way(x)
        return tuple(turned[d] + CELL * self.cells[d] for d in range(2))

    def settings(self, shape, friction):
        """As --set wants them."""
        axis = self.way((math.cos(math.radians(ANGLE)), math.sin(math.radians(ANGLE))))
        corners = [self.place(corner) for corner in ((-1e-3, -1e-3), (1e-3, 1e-3))]
        settings = [f"Mesh/Lower={pair(map(min, *corners))}", f"Mesh/Upper={pair(map(max, *corners))}",
                    f"Bodies/grain/Center={pair(self.place(CENTER))}", f"Contact/Friction={friction}"]
        settings += [f"Bodies/grain/{key}={value}" for key, value in SHAPES[shape].items()]
        if shape == "ellipse":
            settings.append(f"Bodies/grain/Angle={math.degrees(math.atan2(axis[1], axis[0]))!r}")
        for name, (point, normal, velocity) in PLATES.items():
            point = (0., CENTER[1] - math.copysign(REACH, normal[1])) if shape == "ellipse" else point
            settings += [f"Walls/{name}/Point={pair(self.place(point))}", f"Walls/{name}/Normal={pair(self.way(normal))}",
                         f"Walls/{name}/Velocity={velocity}", f"Walls/{name}/Friction={friction}"]
        return settings


def differences(start, image, shapes=tuple(SHAPES), frictions=(0, 0.5)):
    """Of the centre of the body [cells], and of the force on a plate, relative to it."""
    found = {}
    for shape in shapes:
        for friction in frictions:
            before, after = (start(SCENE, *which.settings(shape, friction)) for which in (Image(), image))
            places = [run.states[-1].bodies.center_m[0] for run in (before, after)]
            forces = [run.history["second_force_N_per_m"][-1] for run in (before, after)]
            apart = max(abs(a - b) for a, b in zip(image.place(places[0]), places[1])) / CELL
            found[f"{shape}, friction {friction}"] = (apart, abs(forces[1] - forces[0]) / abs(forces[0]))
    return found


def are_images(found):
    return all(apart < 1e-9 and force < 1e-7 for apart, force in found.values())
