#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What rows alone do to the force at which an adhering disk parts from a plane: the same rows on a half-plane whose response is known exactly
(Johnson, Contact Mechanics, section 2.5), each an even pressure over its length, in balance at every approach. For doc/results/laws.md."""
import argparse
import math

import numpy as np

from sticking import RADIUS, maugis

MODULUS = 2e6 / 0.91  # E* [Pa]


class Rows:
    """Rows of one length on a parabola; gaps of their middles and ends under the forces on them."""

    def __init__(self, length, strength, reach, as_a_whole):
        number = round(1.6e-3 / length)
        self.x, self.reach, self.as_a_whole = np.arange(-number, number + 1) * length, reach, as_a_whole
        self.hold = strength * length  # of a row that pulls with all of its length [N/m]
        self.middle, self.ends = self.response(self.x, length), [self.response(self.x + side * length / 2, length) for side in (-1, 1)]
        self.end_gap = [(self.x + side * length / 2) ** 2 / (2 * RADIUS) for side in (-1, 1)]
        self.share, self.force = np.zeros_like(self.x), np.zeros_like(self.x)

    def response(self, places, length):
        def part(t):
            return t * np.log(np.abs(t) + 1e-300)
        way = places[:, None] - self.x[None, :]
        return -2 / (math.pi * MODULUS * length) * (part(way + length / 2) - part(way - length / 2) - length)

    def solve(self, approach):
        """Signorini's condition for force + share of the pull, closed rows found by pivoting; gaps of middles."""
        start = self.x**2 / (2 * RADIUS) - approach
        pull = self.hold * self.share
        closed = self.force + pull > 0 if self.force.any() else start <= 0
        for _ in range(200):
            self.force = -pull
            open_rows, shut = np.where(~closed)[0], np.where(closed)[0]
            if shut.size:
                rest = start[shut] + self.middle[np.ix_(shut, open_rows)] @ self.force[open_rows]
                self.force[shut] = -np.linalg.solve(self.middle[np.ix_(shut, shut)], rest)
            gap = start + self.middle @ self.force
            now = np.where(closed, self.force + pull > 0, gap < -1e-15)
            if (now == closed).all():
                return gap
            closed = now
        return gap

    def within(self, gap, approach):
        """The share of every row within reach."""
        if self.as_a_whole:
            return (gap <= self.reach).astype(float)
        share = np.zeros_like(gap)
        for response, height in zip(self.ends, self.end_gap):
            end = height - approach + response @ self.force
            near, far = np.minimum(end, gap), np.maximum(end, gap)
            part = (self.reach - near) / np.maximum(far - near, 1e-30)
            share += 0.5 * np.where(far <= self.reach, 1, np.where(near >= self.reach, 0, part))
        return share

    def balance(self, approach):
        """Net pull [N/m] once adhesion is that of the gaps there are."""
        for step in range(60):
            now = self.within(self.solve(approach), approach)
            if np.abs(now - self.share).max() < 1e-9:
                break
            self.share = now if step <= 10 else (now + self.share) / 2
        return -self.force.sum()


def parting_force(length, strength, reach, as_a_whole):
    rows = Rows(length, strength, reach, as_a_whole)
    scale = (2 * strength * reach * RADIUS**2 / (math.pi * MODULUS)) ** (2 / 3) / (2 * RADIUS)
    largest, below = 0.0, 0
    for approach in np.arange(8 * scale, -400 * scale, -scale / 60):
        pull = rows.balance(approach)
        largest = max(largest, pull)
        below += largest > 0 and pull < 0.8 * largest
        if below > 5:
            break
    return largest


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--lengths", type=float, nargs="+", default=[62.5e-6, 31.25e-6, 15.6e-6], help="of rows [m]")
    words = parser.parse_args()
    print("| strength [Pa] | rows | " + " | ".join(f"{1e6 * length:.0f} µm" for length in words.lengths) + " |")
    for strength, reach in ((1.15e5, 3.24e-5), (2.3e5, 1.62e-5)):
        exact = maugis(MODULUS, strength, reach)
        for as_a_whole in (True, False):
            errors = [100 * (parting_force(length, strength, reach, as_a_whole) / exact - 1) for length in words.lengths]
            print(f"| {strength:g} | {'as a whole' if as_a_whole else 'with their part'} | " + " | ".join(f"{error:+.2f} %" for error in errors) + " |",
                  flush=True)


if __name__ == "__main__":
    main()
