# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Balls that fall into a box ('Dimension' = '3', 'Scheme' = 'moreau_jean'), on coarse cells: energy and momentum balance, and what falls is dissipated.
A run that is interrupted and goes on, and one with two threads, give the same bits. What at rest knows and inertia does not is refused, and the other
way round.
"""
SCENE = "../../../parameters/gallery/poured_spheres.prm"
COARSE = ("Packing/Number=3", "Packing/Packing fraction=0.12", "Packing/Upper=22e-3, 22e-3, 26e-3", "Mesh/Cell size=2.6e-3", "Output/Number of field outputs=0",
          "Output/Fields every=0.03", "Output/Field parts=outlines")
REFUSED = {
    "Quasi-static/Regularisation=1e-3": "'Quasi-static/Regularisation' = '1e-3'",
    "Walls/bottom/Drive=mean_pressure": "'Walls/bottom/Drive' = 'mean_pressure'",
    "Time/Scheme=explicit": "'Time/Scheme' = 'explicit'",
}


def measure(start):
    run = start(SCENE, *COARSE, "Stop/End time=0.06", codes=(0,))
    history = run.history
    found = {"energy": run.summary["energy_balance_error"], "momentum": run.summary["momentum_error"],
             "fell": history["gravity_work_J"][-1] > 0, "lost": history["dissipated_energy_J"][-1] / history["gravity_work_J"][-1]}
    threads = start(SCENE, *COARSE, "Stop/End time=0.06", codes=(0,), words=("--threads", "2"))
    found["threads"] = (threads.folder / "history.csv").read_text() == (run.folder / "history.csv").read_text()
    begun = start(SCENE, *COARSE, "Stop/End time=0.03", codes=(0,))
    going = start(SCENE, *COARSE, "Stop/End time=0.06", codes=(0,), words=("--restart", next(begun.folder.glob("state-*.h5"))))
    found["restart"] = all(going.history[name][-20:] == history[name][-20:] for name in ("kinetic_energy_J", "bottom_force_N", "contact_loss_J"))
    found["refused"] = [words for change, words in REFUSED.items() if words not in start(SCENE, change, codes=(2,)).error]
    return found


def is_right(found):
    return (found["energy"] < 0.01 and found["momentum"] < 1e-11 and found["fell"] and 0 < found["lost"] < 1 and found["threads"] and found["restart"]
            and not found["refused"])
