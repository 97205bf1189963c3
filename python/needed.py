# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What the tools do before anything else: a package that is missing is told in one line, and pictures
need no display.
"""

import os
import sys
from contextlib import contextmanager


@contextmanager
def packages_of(tool):
    """
    Around the imports of a tool: the first that fails ends it with the name of Debian's package.
    """
    os.environ["MPLBACKEND"] = "Agg"  # no display is needed
    try:
        yield
    except ImportError as missing:
        package = f"python3-{(missing.name or 'matplotlib').split('.')[0]}"
        print(
            f"{tool}: Debian's package {package} is needed: apt install {package} ({missing})",
            file=sys.stderr,
        )
        sys.exit(2)
