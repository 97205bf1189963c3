#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the figures of a publication from runs; softgrain.figures has them."""

from needed import packages_of

with packages_of("figures"):
    from softgrain.command import run_tool
    from softgrain.figures import main

    if __name__ == "__main__":
        run_tool(main)
