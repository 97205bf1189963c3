#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs shipped scenes, draws the pictures of doc/gallery.md and prints what each run took."""
import argparse
import pathlib
import subprocess
import sys

from running import PARAMETERS, RunFailed, run

# How a scene is drawn, where `softgrain render` does not choose it well by itself.
DRAWING = {
    "bar_period": ["--field", "velocity_m_per_s:x", "--frame", "0"],
    "eight_polyhedra": ["--field", "body", "--view", "-60", "20"],
    "eight_spheres": ["--cut", "y=6e-3"],
    "diametral_compression_mpm_thesis_method": ["--contacts", "none"],
    "generalized_vortex": ["--field", "velocity_m_per_s", "--frame", "2"],
    "drum_of_spheres": ["--field", "body", "--view", "-60", "20"],
    "hopper_of_spheres": ["--field", "body", "--frame", "6", "--view", "-60", "15"],
    "sheared_cell_of_spheres": ["--field", "body", "--view", "-60", "20"],
    "sheared_spheres": ["--contacts", "chains", "--view", "-60", "20"],
    "sphere_between_plates": ["--cut", "y=0"],
    "sphere_in_a_die": ["--cut", "y=0"],
    "spinning_disk": ["--field", "velocity_m_per_s"],
    "patch_test": ["--range", "0", "3e5"],
    "plastic_block": ["--range", "0", "3e8"],
    "pull_off": ["--frame", "5"],
    "swelling_gels_mpm": ["--field", "volume_ratio"],
    "triaxial_spheres": ["--cut", "y=5e-3"],
    "twelve_plastic_spheres": ["--field", "equivalent_plastic_strain", "--view", "-60", "20"],
    "two_disks": ["--frame", "3"],
}


def draw(program, folder, picture):
    """The picture of one run, small enough for a page."""
    picture.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([program, "render", folder, "--output", picture, "--width", "4.5", "--dpi", "110",
                    *DRAWING.get(picture.stem, [])], check=True, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("scenes", nargs="*", metavar="SCENE",
                        help="below parameters/, such as gallery/two_disks.prm (default: all; some take hours)")
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("output/gallery"),
                        help="for the output folders of the runs; runs that are there are not repeated "
                             "(default: %(default)s)")
    parser.add_argument("--pictures", type=pathlib.Path, default=PARAMETERS.parent / "doc/pictures/gallery",
                        help="where the pictures go (default: doc/pictures/gallery)")
    parser.add_argument("--threads", type=int, default=0, help="0: one per core")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="changes of every scene")
    arguments = parser.parse_intermixed_args()
    scenes = arguments.scenes or sorted(str(path.relative_to(PARAMETERS)) for path in PARAMETERS.rglob("*.prm")
                                        if path.parent.name != "studies")
    changes = dict(text.split("=", 1) for text in arguments.set)
    failed = False
    print("| scene | steps | bodies | seconds | threads |\n|---|---|---|---|---|", flush=True)
    for scene in scenes:
        name = pathlib.Path(scene).stem
        try:
            summary, _ = run(arguments.program, scene, arguments.folder / name, changes, arguments.threads, again=False)
            draw(arguments.program, arguments.folder / name, arguments.pictures / f"{name}.png")
        except (RunFailed, subprocess.CalledProcessError) as error:
            print(f"{scene}: {error}", file=sys.stderr)
            failed = True
            continue
        print(f"| `{scene}` | {summary['steps']} | {summary['bodies']} | {summary['wall_seconds']:.1f} | "
              f"{summary['threads']} |", flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
