#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Draws the grains of a finished or running output: bodies or a field in colour, outlines, walls,
forces.
"""

import argparse
import os
from dataclasses import fields

from needed import packages_of

with packages_of("render"):
    from softgrain import InputError, Run
    from softgrain.command import Parser, run_tool
    from softgrain import film
    from softgrain.colouring import ALONG_CONTACTS, columns_of
    from softgrain.options import add_shared, between
    from softgrain.picture import Options, picture_of


def parse_arguments():
    parser = Parser(
        prog="softgrain render",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog=(
            "examples:\n  softgrain render out                              the last frame: von"
            " Mises stress, or primaries\n  softgrain render out --frame all --field pressure_Pa\n "
            " softgrain render out --film --field velocity      a film, out/pictures/velocity.mp4\n"
            "  softgrain render out --film --output out.gif      the same for a page or a talk\n "
            " softgrain render out --field pressure,strain      both, one beside the other\n "
            " softgrain render out --field strain --zoom 3      the middle, three times as large\n "
            " softgrain render out --field coordination         number of contacts of every body\n "
            " softgrain render out --field body --contacts inner --attraction\n  softgrain render"
            " out --contacts chains --output poster.pdf --dpi 300\n  softgrain render out --cut"
            " y=0.01 --view -70 30      the inside of grains in space\n  softgrain render out"
            " --list                       frames and fields there are\n"
        ),
    )
    parser.add_argument("directory", metavar="DIR", nargs="?", help="output folder of a run")
    add_shared(parser, "field")
    parser.add_argument(
        "--frame", help="number of the frame, from 0; last; all (default: last; all for a film)"
    )
    parser.add_argument(
        "--film",
        metavar="FILE",
        nargs="?",
        const="",
        help=(
            "makes a film of all frames: .mp4 (needs ffmpeg) or .gif (ffmpeg or Pillow) (default: "
            "DIR/pictures/FIELD.mp4)"
        ),
    )
    add_shared(parser, "fps", default=12)
    parser.add_argument(
        "--output",
        metavar="FILE",
        help=(
            "picture to write: .png, .svg, .pdf, or with --film .mp4, .gif; for several frames the"
            " number is put before the ending (default: DIR/pictures/FIELD-NNNNNN.png)"
        ),
    )
    parser.add_argument(
        "--range",
        nargs=2,
        type=float,
        metavar=("MIN", "MAX"),
        help="ends of the colour scale, in the field's SI unit (default: from the values)",
    )
    parser.add_argument(
        "--zoom",
        nargs="+",
        type=float,
        metavar="NUMBER",
        help="shows a part: N enlarges the middle N times; X0 Y0 X1 Y1 are two corners in metres",
    )
    parser.add_argument(
        "--view",
        nargs=2,
        type=float,
        metavar=("AZIMUTH", "ELEVATION"),
        help=(
            "of runs in space: where the viewer stands, in degrees about z and above the plane of"
            " x and y (default: -60 20)"
        ),
    )
    parser.add_argument(
        "--cut",
        metavar="AXIS=PLACE",
        help=(
            "of runs in space: shows the inside in a plane across x, y or z at a place in metres,"
            " as y=0.01; what lies before it is left out"
        ),
    )
    parser.add_argument(
        "--colours",
        metavar="NAME",
        help=(
            "colour map of matplotlib (default: viridis; for fields "
            "of both signs a diverging one; for bodies pale ones)"
        ),
    )
    parser.add_argument(
        "--contacts",
        choices=("auto", "chains", "arrows", "inner", "none"),
        default="auto",
        help=(
            "forces: chains from centre to centre of the bodies, arrows at the contact places, or"
            " lines from centre to centre of the primaries (default: inner with --field body or"
            " none when the run has 'Inner forces', else arrows up to 3 bodies, chains above)"
        ),
    )
    parser.add_argument(
        "--attraction",
        action=argparse.BooleanOptionalAction,
        help="attraction between primaries, with --contacts inner (default: up to 3 bodies)",
    )
    parser.add_argument(
        "--style",
        choices=("smooth", "disks"),
        help=(
            "the field made smooth in every grain, or every point as a disk of its area (default: "
            "smooth for material points, disks for primaries)"
        ),
    )
    add_shared(
        parser,
        "title",
        help=(
            "text above the picture (default: time, and packing fraction or strain where the scene"
            " goes by it)"
        ),
    )
    parser.add_argument(
        "--width",
        type=between(1, 60, float, "inches"),
        help="of the picture, in inches (default: 7; 4.2 for each of several fields)",
    )
    add_shared(parser, "dpi", help="dots per inch (default: 220; 150 for a film)")
    parser.add_argument("--list", action="store_true", help="print frames and fields, draw nothing")
    arguments = parser.parse_args()
    if (
        arguments.directory is None and arguments.film and os.path.isdir(arguments.film)
    ):  # --film DIR
        arguments.directory, arguments.film = arguments.film, ""
    if arguments.directory is None:
        parser.error("the following arguments are required: DIR")
    arguments.dpi = (
        arguments.dpi if arguments.dpi is not None else 220 if arguments.film is None else 150
    )
    if arguments.range and arguments.field in ("body", "none"):
        raise InputError(f"--range has no meaning with --field {arguments.field}")
    if arguments.zoom and (
        len(arguments.zoom) not in (1, 4)
        or (len(arguments.zoom) == 1 and not arguments.zoom[0] > 0)
    ):
        raise InputError(
            "--zoom takes one number above 0, or the two corners X0 Y0 X1 Y1 in metres"
        )
    if arguments.film and arguments.output:
        raise InputError(
            f"--film {arguments.film} and --output {arguments.output} both name the film: leave"
            " one out"
        )
    if arguments.film is not None and arguments.output:
        arguments.film = arguments.output
    if arguments.film is not None and arguments.frame not in (None, "all"):
        raise InputError("--film shows all frames: leave --frame out")
    return arguments


def choose_frames(run, text):
    if text == "all":
        return list(run)
    if text in (None, "last"):
        return [run[-1]]
    try:
        return [run[int(text)]]
    except ValueError:
        raise InputError(f"--frame {text}: a number, 'last' or 'all' is meant") from None
    except IndexError:
        raise InputError(f"--frame {text}: the frames go from 0 to {len(run) - 1}") from None


def output_path(arguments, options, state, several):
    if arguments.output is None:
        return os.path.join(
            arguments.directory, "pictures", f"{file_name(options)}-{state.number:06d}.png"
        )
    if not several:
        return arguments.output
    root, ending = os.path.splitext(arguments.output)
    return f"{root}-{state.number:06d}{ending or '.png'}"


def file_name(options):
    return options.field.replace(":", "_").replace("/", "_").replace(",", "-")


def make_film(arguments, states):
    path = arguments.film
    film.require_maker(path or "film.mp4")  # before any picture is drawn
    options, picture = prepare(arguments, states)
    path = path or os.path.join(arguments.directory, "pictures", file_name(options) + ".mp4")
    film.make(
        path,
        arguments.fps,
        lambda number, file: picture.save(states[number], file, arguments.dpi),
        len(states),
    )
    print(path)


def prepare(arguments, states):
    options = Options(**{item.name: getattr(arguments, item.name) for item in fields(Options)})
    return options, picture_of(options, states)


def print_list(run):
    for state in run:
        of_bodies = "outlines" if run.dimension == 2 else "surfaces"
        parts = [part for part in ("points", of_bodies, "contacts", "walls") if state.has(part)]
        print(f"{state.number:6d}  t = {state.time:g} s  {', '.join(parts)}")
    last = run[-1]
    for part, text in (("points", "fields"), ("bodies", "fields of whole bodies")):
        if names := columns_of(last, part):
            print(f"{text}: " + ", ".join(sorted(names)))
    if last.has("contacts") and run.dimension == 2:
        print("fields along contacts: " + ", ".join(ALONG_CONTACTS))


def main():
    arguments = parse_arguments()
    run = Run(arguments.directory).for_pictures()
    if arguments.list:
        print_list(run)
        return 0
    states = choose_frames(run, "all" if arguments.film is not None else arguments.frame)
    if arguments.film is not None:
        make_film(arguments, states)
        return 0
    options, picture = prepare(arguments, states)
    for state in states:
        path = output_path(arguments, options, state, len(states) > 1)
        picture.save(state, path, arguments.dpi)
        print(path, flush=True)
    return 0


if __name__ == "__main__":
    run_tool(main)
