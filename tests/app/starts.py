# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many short calls of softgrain, without linking it with its libraries each time."""

import os
import subprocess
import tempfile


class Starts:
    """Call it with the words of a command; returns exit code, what was printed, what was said of errors."""

    def __init__(self, program):
        """`program` is tests/app/test_app_many_starts. Calls run in the folder that is the current one now."""
        self.folder = tempfile.TemporaryDirectory()
        self.files = [os.path.join(self.folder.name, name) for name in ("out", "err")]
        self.process = subprocess.Popen([program, *self.files], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def __call__(self, *words):
        self.process.stdin.write("\x1f".join(words) + "\n")
        self.process.stdin.flush()
        status = self.process.stdout.readline()
        assert status, "test_app_many_starts has ended"
        texts = []
        for name in self.files:
            with open(name, encoding="utf-8") as file:
                texts.append(file.read())
        return int(status), *texts

    def end(self):
        self.process.stdin.close()
        assert self.process.wait(timeout=100) == 0
        self.process.stdout.close()
        self.folder.cleanup()
