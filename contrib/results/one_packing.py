#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What one packing shows of the error of a study, against what several show: by leaving out one place after the other in each run of a
study whose knob of packings has 'Average = true', and by the scatter of its runs. The table of doc/studies.md.

    PYTHONPATH=python python3 contrib/results/one_packing.py STUDY.prm...      # run before with softgrain study
"""
import sys

import numpy as np
from softgrain.study import Session
from softgrain.study_quantities import norm_of
from softgrain.study_results import evaluate
from softgrain.study_verdict import spread_over_places


def rows_of(path):
    """(point, mean error, scatter of errors of single packings, median of what leaving out places shows of one)"""
    session = Session(path)
    for one in evaluate(session.study, session.points, session.output).results:
        for quantity in session.study.quantities:
            runs = one.differences[quantity.name].of_runs
            if runs is None or len(runs) < 3:
                continue
            errors = [norm_of(quantity.norm, run) for run in runs]
            alone = np.median([spread_over_places(quantity, run) for run in runs])
            yield one.point.label, one.differences[quantity.name].error, np.std(errors, ddof=1), alone


if __name__ == "__main__":
    print("| study | point | error of the mean | scatter of packings | leaving out places of one | ratio |\n|---|---|---|---|---|---|")
    for study in sys.argv[1:]:
        for label, error, scatter, alone in rows_of(study):
            print(f"| {study} | {label} | {100 * error:.2g} % | {100 * scatter:.2g} % | {100 * alone:.2g} % | {scatter / alone:.2g} |")
