#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the grains of a finished or running output: bodies or a field in colour, outlines, walls, forces."""

import argparse
import os
import sys

from reading import (InputError, Parser, axial_strain, describe, need, read_grid, read_series, run_tool, scaled_unit,
                     split_unit, with_unit)

try:
    import matplotlib
    matplotlib.use("Agg")  # no display is needed
    import matplotlib.pyplot as plt
    import numpy as np
    import drawing
    import primaries
except ImportError as missing:
    print(f"render: {need('python3-matplotlib', missing)}", file=sys.stderr)
    sys.exit(2)


LEGEND_WIDTH = 3.2  # inches that legend and scale bar need side by side


def parse_arguments():
    parser = Parser(
        prog="render", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="examples:\n"
               "  render.py out                              the last frame: von Mises stress, or primaries\n"
               "  render.py out --frame all --field pressure_Pa\n"
               "  render.py out --field body --contacts inner --attraction\n"
               "  render.py out --contacts chains --output poster.pdf --dpi 300\n"
               "  render.py out --list                       frames and fields there are\n")
    parser.add_argument("directory", metavar="DIR", help="output folder of a run")
    parser.add_argument("--field",
                        help="field of the points in colour; a vector by its length or, with :x or :y at the end, a "
                             "component; 'body' gives neighbours different colours, 'none' leaves the grains plain "
                             "(default: von_mises_Pa; body for primaries)")
    parser.add_argument("--frame", default="last", help="number of the frame, from 0; last; all (default: last)")
    parser.add_argument("--output", metavar="FILE",
                        help="picture to write: .png, .svg, .pdf; for several frames the number is put before the "
                             "ending (default: DIR/pictures/FIELD-NNNNNN.png)")
    parser.add_argument("--range", nargs=2, type=float, metavar=("MIN", "MAX"),
                        help="ends of the colour scale, in the field's SI unit (default: from the values)")
    parser.add_argument("--colours", metavar="NAME", help="colour map of matplotlib (default: viridis; for fields "
                                                          "of both signs a diverging one; for bodies pale ones)")
    parser.add_argument("--contacts", choices=("auto", "chains", "arrows", "inner", "none"), default="auto",
                        help="forces: chains from centre to centre of the bodies, arrows at the contact places, or "
                             "lines from centre to centre of the primaries (default: inner with --field body or none "
                             "when the run has 'Inner forces', else arrows up to 3 bodies, chains above)")
    parser.add_argument("--attraction", action=argparse.BooleanOptionalAction,
                        help="attraction between primaries, with --contacts inner (default: up to 3 bodies)")
    parser.add_argument("--style", choices=("smooth", "disks"),
                        help="the field made smooth in every grain, or every point as a disk of its area (default: "
                             "smooth for material points, disks for primaries)")
    parser.add_argument("--title", help="text above the picture (default: time and strain)")
    parser.add_argument("--width", type=float, default=7.0, help="of the picture, in inches (default: %(default)s)")
    parser.add_argument("--dpi", type=int, default=220, help="dots per inch (default: %(default)s)")
    parser.add_argument("--list", action="store_true", help="print frames and fields, draw nothing")
    arguments = parser.parse_args()
    if not (1 <= arguments.width <= 60 and 10 <= arguments.dpi <= 2400):
        raise InputError("--width must be 1 to 60 inches and --dpi 10 to 2400")
    if arguments.range and arguments.field in ("body", "none"):
        raise InputError(f"--range has no meaning with --field {arguments.field}")
    return arguments


def choose_frames(series, text):
    if text == "all":
        return series
    if text == "last":
        return series[-1:]
    try:
        return [series[int(text)]]
    except ValueError:
        raise InputError(f"--frame {text}: a number, 'last' or 'all' is meant") from None
    except IndexError:
        raise InputError(f"--frame {text}: the frames go from 0 to {len(series) - 1}") from None


def field_values(points, name, path):
    """The values of a field by its name on the command line."""
    base, _, component = name.partition(":")
    if base not in points.point_data:
        raise InputError(f"there is no field '{base}' in {path}; there are " + ", ".join(sorted(points.point_data)))
    values = points.point_data[base]
    if values.ndim == 1:
        if component:
            raise InputError(f"the field '{base}' has no components")
        return values
    if not component:
        return np.linalg.norm(values, axis=1)
    names = ("xx", "xy", "yx", "yy") if values.shape[1] == 4 else ("x", "y")
    if component not in names:
        raise InputError(f"'{component}' is no component of '{base}': it has {', '.join(names)}")
    return values[:, names.index(component)]


class Picture:
    """What all frames share: options, colours of bodies or the colour scale, the force of the widest lines."""

    def __init__(self, arguments, frames):
        self.arguments = arguments
        first = self.part(frames[0], "points")
        self.primaries = primaries.of_primaries(first)
        if arguments.field is None:
            arguments.field = "body" if self.primaries and not arguments.range else "von_mises_Pa"
        self.field = None if arguments.field in ("body", "none") else arguments.field
        self.limits = tuple(arguments.range) if arguments.range else None
        self.signed = False
        self.numbers = self.colours = None  # of bodies
        if self.field:
            self.choose_scale(frames)
        elif arguments.field == "body":
            self.choose_colours(frames, first)
        self.contacts = arguments.contacts
        self.full_force = self.strongest_attraction = 0.
        if self.primaries and (arguments.contacts == "inner" or (arguments.contacts == "auto" and not self.field)):
            self.choose_forces(frames, len(np.unique(first.point_data["body"])))
        elif arguments.contacts == "inner":
            raise InputError("--contacts inner is for primaries: " +
                             f"{frames[0].files.get('points', 'a frame without points')} has no radius_m")
        if arguments.attraction and self.contacts != "inner":
            raise InputError("--attraction needs --contacts inner and a run with 'Inner forces'")

    def choose_colours(self, frames, points):
        """Colours of bodies that stay the same in all frames."""
        outlines = [grid for grid in (self.part(frame, "outlines") for frame in frames) if grid is not None]
        bodies = [grid.cell_data["body"] for grid in outlines if len(grid.cells)]
        bodies += [points.point_data["body"]] if points is not None else []
        if not bodies:
            raise InputError(f"frame {frames[0].number} has neither outlines nor points")
        self.colours = primaries.PALETTE
        if self.arguments.colours:
            cmap = self.colour_map(self.arguments.colours)
            listed = getattr(cmap, "colors", ())
            self.colours = listed if 2 < len(listed) <= 32 else cmap(np.linspace(0.05, 0.95, 8))
        self.numbers = primaries.colour_numbers(int(max(body.max() for body in bodies)) + 1,
                                                primaries.neighbours_of(outlines), len(self.colours))

    def choose_forces(self, frames, n_bodies):
        """One scale of widths for all frames; without forces inside the bodies 'auto' stays what it is."""
        attraction = n_bodies <= 3 if self.arguments.attraction is None else self.arguments.attraction
        for frame in frames:
            contacts = self.part(frame, "contacts")
            if contacts is None or len(contacts.points) == 0:
                continue
            if (contacts.point_data["body_a"] == contacts.point_data["body_b"]).any():
                self.contacts = "inner"
            forces = contacts.point_data["normal_force_N_per_m"]
            self.full_force = max(self.full_force, primaries.full_force(forces))
            if attraction:
                self.strongest_attraction = max(self.strongest_attraction, -forces.min())

    @staticmethod
    def colour_map(name):
        try:
            return plt.get_cmap(name)
        except ValueError:
            raise InputError(f"--colours {name}: matplotlib has no such colour map") from None

    def choose_scale(self, frames):
        """One colour scale for all frames, so that they can be compared and make a film."""
        sample = []
        for frame in frames:
            points = self.part(frame, "points")
            if points is None:
                raise InputError(f"frame {frame.number} has no points to colour: run with points in its pictures, "
                                 "or use --field none")
            sample.append(field_values(points, self.field, frame.files["points"]))
        values = np.concatenate(sample)
        values = values[np.isfinite(values)]
        if len(values) == 0:
            raise InputError(f"the field '{self.field}' has no finite values")
        self.signed = drawing.is_signed(values)
        if self.limits is None:
            self.limits = drawing.colour_range(values, self.signed)
        if not self.limits[1] > self.limits[0]:
            raise InputError(f"--range {self.limits[0]:g} {self.limits[1]:g}: the second must be above the first")

    @staticmethod
    def part(frame, name):
        return read_grid(frame.files[name]) if name in frame.files else None

    def draw(self, frame, path):
        points, outlines, contacts, walls = (self.part(frame, name)
                                             for name in ("points", "outlines", "contacts", "walls"))
        rings = drawing.rings_of(outlines) if outlines is not None else {}
        places = [grid.points for grid in (outlines, walls) if grid is not None and len(grid.points)]
        if outlines is None and points is not None:
            places.append(points.points)
        if not places:
            raise InputError(f"frame {frame.number} has neither outlines nor points")
        low, high = np.min([p.min(axis=0) for p in places], axis=0), np.max([p.max(axis=0) for p in places], axis=0)
        extent = max(high - low)
        thickness = 0.03 * extent
        low, high = low - thickness, high + thickness

        figure, axes, bar_axes = self.make_axes(low, high)
        points_per_metre = 72 * figure.get_figwidth() * axes.get_position().width / (high[0] - low[0])
        if walls is not None:
            drawing.draw_walls(axes, walls, thickness)
        if self.field:
            self.fill(axes, bar_axes, rings, points, frame)
        elif self.numbers is not None:
            style = self.arguments.style or ("disks" if self.primaries else "smooth")
            if style == "disks" and points is not None or not rings:
                primaries.draw_points_of_bodies(axes, points, self.numbers, self.colours, points_per_metre)
            else:
                primaries.draw_bodies(axes, rings, self.numbers, self.colours)
        else:
            for body_rings in rings.values():
                axes.add_patch(drawing.PathPatch(drawing.outline_path(body_rings), facecolor="#dfe6ee", linewidth=0,
                                                 zorder=2))
        n_across = np.sqrt(max(1, len(rings)))
        drawing.draw_outlines(axes, rings, float(np.clip(9 / n_across, 0.6, 1.5)))
        if self.contacts == "inner":
            self.draw_inner_forces(figure, axes, points, contacts, points_per_metre)
        else:
            self.draw_forces(figure, axes, rings, outlines, contacts, extent)
        drawing.draw_scale_bar(axes, high[0] - thickness, low[1] - 0.03 * extent, extent)
        self.put_title(axes, frame)
        folder = os.path.dirname(path)
        if folder:
            os.makedirs(folder, exist_ok=True)
        temporary = os.path.join(folder, ".part-" + os.path.basename(path))
        try:
            figure.savefig(temporary, dpi=self.arguments.dpi, facecolor="white")
        except ValueError as error:  # an ending that matplotlib does not know
            raise InputError(f"cannot write {path}: {str(error).splitlines()[0]}") from error
        finally:
            plt.close(figure)
        os.replace(temporary, path)

    def make_axes(self, low, high):
        """A figure as high as the scene needs, with room for title, scale bar and colour bar."""
        width = self.arguments.width
        margin, bar_room, top, bottom = 0.15, 1.25 if self.field else 0.0, 0.45, 0.55
        drawn = width - 2 * margin - bar_room
        height = drawn * (high[1] - low[1]) / (high[0] - low[0])
        if height > 1.6 * width:  # a tall scene: the height is the limit
            drawn, height = drawn * 1.6 * width / height, 1.6 * width
        total_height = height + top + bottom
        total_width = drawn + 2 * margin + bar_room
        margin += max(0., LEGEND_WIDTH - total_width) / 2 if self.primaries else 0.
        total_width = drawn + 2 * margin + bar_room
        figure = plt.figure(figsize=(total_width, total_height))
        axes = figure.add_axes([margin / total_width, bottom / total_height, drawn / total_width,
                                height / total_height])
        axes.set_axis_off()
        axes.set_aspect("equal")
        axes.set_autoscale_on(False)
        axes.set_xlim(low[0], high[0])
        axes.set_ylim(low[1], high[1])
        bar_axes = None
        if self.field:
            bar_height = max(min(height, 4.5) * 0.86, 1.2)
            bar_axes = figure.add_axes([(margin + drawn + 0.2) / total_width,
                                        (bottom + 0.5 * (height - bar_height)) / total_height, 0.17 / total_width,
                                        bar_height / total_height])
        return figure, axes, bar_axes

    def fill(self, axes, bar_axes, rings, points, frame):
        values = field_values(points, self.field, frame.files["points"])
        base, _, component = self.field.partition(":")
        name, unit = split_unit(base)
        scale, unit = scaled_unit(unit, max(abs(limit) for limit in self.limits))
        norm = drawing.Normalize(self.limits[0] / scale, self.limits[1] / scale)
        cmap = self.colour_map(self.arguments.colours or ("coolwarm" if self.signed else "viridis"))
        areas = points.point_data.get("area_m2", np.ones(len(points.points)))
        style = self.arguments.style or ("disks" if self.primaries else "smooth" if "deformation_gradient"
                                         in points.point_data or "stress_zz_Pa" in points.point_data else "disks")
        if style == "smooth" and rings:
            drawing.draw_smooth(axes, rings, points.points, points.point_data["body"], values / scale, areas, norm,
                                cmap)
        else:
            drawing.draw_disks(axes, points.points, values / scale, areas, norm, cmap)
        axes.set_xlim(axes.get_xlim())
        beyond = "both" if values.min() / scale < norm.vmin and values.max() / scale > norm.vmax else \
            "max" if values.max() / scale > norm.vmax else "min" if values.min() / scale < norm.vmin else "neither"
        bar = plt.colorbar(plt.cm.ScalarMappable(norm, cmap), cax=bar_axes, extend=beyond, extendfrac=0.03)
        label = describe(base) if not component else f"{name.replace('_', ' ')}, {component}"
        bar.set_label(with_unit(label, unit), labelpad=8)
        bar.outline.set_linewidth(0.8)

    def draw_forces(self, figure, axes, rings, outlines, contacts, extent):
        kind = self.contacts
        if kind == "auto":
            kind = "arrows" if len(rings) <= 3 else "chains"
        contacts = primaries.between_bodies(contacts) if contacts is not None else None
        if kind == "none" or contacts is None or len(contacts.points) == 0:
            return
        if kind == "arrows":
            drawing.draw_arrows(axes, contacts, 0.11 * extent, 0.0035 * extent)
            return
        if outlines is None:
            raise InputError("force chains need the outlines: use --contacts arrows")
        centers = {int(body): center[:2] for body, center in zip(outlines.cell_data["body"],
                                                                outlines.cell_data["center_m"])}
        width = 42.0 * self.arguments.width / 7 / np.sqrt(len(rings))
        if not self.primaries:
            drawing.draw_chains(axes, contacts, centers, width)
            return
        width *= 0.5  # the primaries are to be seen
        fill, colour = ("white", drawing.INK) if self.field else (primaries.REPULSION, primaries.REPULSION)
        if full_force := drawing.draw_chains(axes, contacts, centers, width, fill):
            primaries.draw_width_legend(figure, axes, width / full_force, full_force, colour=colour)

    def draw_inner_forces(self, figure, axes, points, contacts, points_per_metre):
        if contacts is None or not self.full_force:
            return
        diameter = 2 * np.median(points.point_data["radius_m"]) if points is not None else 0.
        width_per_force = max(0.75 * diameter * points_per_metre, 1.) / self.full_force
        if len(contacts.points):
            primaries.draw_force_lines(axes, *primaries.force_lines(contacts, points), width_per_force,
                                       2 * width_per_force * self.full_force, self.strongest_attraction > 0)
        primaries.draw_width_legend(figure, axes, width_per_force, self.full_force, self.strongest_attraction)

    def put_title(self, axes, frame):
        title = self.arguments.title
        if title is None:
            scale, unit = scaled_unit("s", abs(frame.time))
            title = f"$t$ = {frame.time / scale:.4g} {unit}"
            strain = axial_strain(self.arguments.directory, frame.time)
            if strain is not None:
                title += rf"      $\varepsilon$ = {strain:.3f}"
        axes.set_title(title, pad=10, fontsize=12)


def output_path(arguments, frame, several):
    if arguments.output is None:
        name = arguments.field.replace(":", "_")
        return os.path.join(arguments.directory, "pictures", f"{name}-{frame.number:06d}.png")
    if not several:
        return arguments.output
    root, ending = os.path.splitext(arguments.output)
    return f"{root}-{frame.number:06d}{ending or '.png'}"


def print_list(series):
    for frame in series:
        print(f"{frame.number:6d}  t = {frame.time:g} s  {', '.join(frame.files)}")
    if "points" in series[-1].files:
        print("fields: " + ", ".join(sorted(read_grid(series[-1].files["points"]).point_data)))


def main():
    arguments = parse_arguments()
    series = read_series(arguments.directory)
    if arguments.list:
        print_list(series)
        return 0
    frames = choose_frames(series, arguments.frame)
    plt.rcParams.update(drawing.STYLE)
    picture = Picture(arguments, frames)
    for frame in frames:
        path = output_path(arguments, frame, len(frames) > 1)
        picture.draw(frame, path)
        print(path, flush=True)
    return 0


if __name__ == "__main__":
    run_tool(main)
