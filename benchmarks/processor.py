# SPDX-License-Identifier: LGPL-2.1-or-later
"""Processor time of a program."""
import os
import resource
import subprocess
import sys


def seconds_of(command):
    """Processor seconds of a command on one thread, its start included; where it fails, its last lines end the script."""
    words = [str(word) for word in command]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, capture_output=True, text=True, check=False, env={**os.environ, "OMP_NUM_THREADS": "1"})
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        sys.exit(f"{' '.join(words)}: {(done.stdout + done.stderr)[-1500:]}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
