# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The command `softgrain` of a wheel, or `python3 -m softgrain`: the program, and the tools by this
Python.
"""

import os
import sys

from .errors import InputError
from .programs import HERE, find_program


def main():
    words = sys.argv[1:]
    tool = HERE / "program/share/softgrain/python" / f"{words[0] if words else ''}.py"
    try:
        if words and words[0].isidentifier() and tool.is_file():
            sys.stdout.flush()
            os.execv(sys.executable, [sys.executable, str(tool), *words[1:]])
        program = find_program()
        # Its figures are drawn by scripts that look for this package.
        places = [str(HERE.parent), *filter(None, [os.environ.get("PYTHONPATH")])]
        os.execve(program, [program, *words], {**os.environ, "PYTHONPATH": os.pathsep.join(places)})
    except (InputError, OSError) as error:
        print(f"softgrain: error: {error}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
