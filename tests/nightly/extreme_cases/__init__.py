# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cases of extremes.py: small scenes, each with one thing at its limit."""
from . import bonded, matter, motion, places

CASES = [case for kind in (matter, motion, places, bonded) for case in kind.cases()]
