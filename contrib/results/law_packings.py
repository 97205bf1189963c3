#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thirty grains with every law of finite strain, gallery/thirty_grains_quasi_static_mpm.prm to a packing fraction of 0.95,
with and without F-bar: the table of doc/results/laws.md."""
import re
import resource

from running import PARAMETERS, RunFailed, parser_of, run

SCENE = "gallery/thirty_grains_quasi_static_mpm.prm"
# The wall is at 0.95 after 2.5 ms, which is the clock of the laws that know time.
LAWS = {
    "neo_hookean": ("Neo-Hookean", {}),
    "hencky": ("Hencky", {}),
    "mooney_rivlin": ("Mooney-Rivlin", {"Share of the second invariant": 0.2}),
    "yeoh": ("Yeoh", {"Second coefficient": -0.01, "Third coefficient": 2e-4}),
    "gent": ("Gent", {"Locking": 1}),
    "ogden": ("Ogden", {"Exponents": "1.3, 5", "Weights": "0.99, 0.01"}),
    "j2_plastic": ("J2 plastic", {"Yield stress": 5e5, "Hardening modulus": 1e6}),
    "viscoplastic": ("Viscoplastic", {"Yield stress": 5e5, "Drag stress": 5e5, "Exponent": 2, "Reference rate": 100}),
    "maxwell": ("Maxwell", {"Shares": "0.5, 0.3", "Relaxation times": "1e-3, 1e-4"}),
    "drucker_prager": ("Drucker-Prager", {"Cohesion": 2e5, "Friction": 0.5, "Cap start": 1e6, "Cap pressure": 2e6}),
    "growth": ("Growth", {"Rate": 60}),
    "energy_only": ("Energy only", {}),
}
COLUMNS = ("law", "F-bar", "to", "steps", "cut", "held steps", "Newton iterations a step", "CPU [s]",
           "unbalanced force, at most", "energy balance", "stress on the walls at the end [MPa]")


def scene_of(law, folder, scene=SCENE):
    """The @scene with the section of @law in place of the one of neo_hookean, below @folder."""
    title, constants = LAWS[law]
    text = (PARAMETERS / scene).read_text(encoding="utf-8")
    lines = "".join(f"      set {name} = {value}\n" for name, value in constants.items())
    text = text.replace("Law     = neo_hookean", f"Law     = {law}").replace("subsection Neo-Hookean", f"subsection {title}")
    text = re.sub(r"(      set Poisson's ratio = [^\n]*\n)", lambda found: found.group(1) + lines, text)
    path = folder / f"{law}.prm"
    path.write_text(text, encoding="utf-8")
    return path


def line(law, f_bar, summary, rows, seconds):
    full = max(row["dt_s"] for row in rows)
    steps = len(rows) - 1
    newton = sum(row["newton_iterations"] for row in rows[1:])
    stress = (rows[-1]["top_force_N_per_m"] + rows[-1]["bottom_force_N_per_m"]) / 2 / 10e-3 / 1e6
    return (law, f_bar, f"{rows[-1]['packing_fraction']:.4f}", steps, sum(row["dt_s"] < 0.9 * full for row in rows[1:-1]),
            f"{rows[-1]['held_steps']:.0f}", f"{newton / steps:.1f}", f"{seconds:.0f}",
            f"{max(row['unbalanced_force'] for row in rows):.1e}", f"{summary['energy_balance_error']:.4f}", f"{stress:.3f}")


def main():
    parser = parser_of(__doc__, "law_packings")
    parser.add_argument("--library", dest="plug_in", help="with the law energy_only: test_constitutive_module_energy_only of the build")
    parser.add_argument("--laws", nargs="+", choices=LAWS, default=[law for law in LAWS if law != "energy_only"])
    parser.add_argument("--f-bar", nargs="+", choices=("off", "on"), default=("off", "on"))
    parser.add_argument("--limit", type=float, default=1800, help="wall seconds of one run (default: %(default)s)")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="for all runs")
    arguments = parser.parse_args()
    more = dict(item.split("=", 1) for item in arguments.set)
    laws = list(arguments.laws)
    if arguments.plug_in:
        more["Additional shared libraries"] = arguments.plug_in
        laws += ["energy_only"] * ("energy_only" not in laws)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    print("| " + " | ".join(COLUMNS) + " |\n" + "|---" * len(COLUMNS) + "|", flush=True)
    failed = 0
    for law in laws:
        for f_bar in arguments.f_bar:
            changes = {"Output/Fields every": 0, "Output/Snapshots every": 0, "Material points/F-bar": f_bar, **more}
            before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
            try:
                summary, rows = run(arguments.program, scene_of(law, arguments.folder).resolve(),
                                    arguments.folder / f"{law}-{f_bar}", changes, threads=1, limit=arguments.limit)
                seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                cells = line(law, f_bar, summary, rows, seconds)
            except RunFailed as error:
                failed += 1
                cells = (law, f_bar, f"failed: {str(error).strip().splitlines()[-1]}")
            print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)
    return failed


if __name__ == "__main__":
    raise SystemExit(main())
