# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Two smooth disks that hit each other beside their centres are pressed out of round, so contact turns them: one gets 5 % of all
angular momentum then. The sum of the angular momenta of their ways and of their spins stays, within 2e-4 (a torque that kept them from turning took 10 %).
Friction of 1e-9 does what none does.
"""
FRICTIONS = (0, 1e-9)


def total(state):
    bodies = state.bodies
    (x, y), (u, v) = bodies.center_m.T[:2], bodies.velocity_m_per_s.T[:2]
    return (bodies.mass_kg_per_m * (x * v - y * u)).sum() + bodies.angular_momentum_kg_m_per_s.sum()


def measure(start):
    found = []
    for friction in FRICTIONS:
        run = start("oblique_hit.prm", f"Contact/Friction={friction}")
        first, last = run.states[0], run.states[-1]
        found.append({"code": run.code, "says": run.error, "changed": abs(total(last) / total(first) - 1),
                      "spin": abs(last.bodies.angular_momentum_kg_m_per_s).max() / abs(total(first)), "place_m": last.bodies.center_m.tolist()})
    return found


def is_right(found):
    smooth, rough = found
    apart = max(abs(a - b) for one, other in zip(smooth["place_m"], rough["place_m"]) for a, b in zip(one, other))
    return all(run["code"] == 0 and run["changed"] < 2e-4 and run["spin"] > 0.03 for run in found) and apart < 1e-7
