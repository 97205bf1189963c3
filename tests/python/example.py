# SPDX-License-Identifier: LGPL-2.1-or-later
"""The run of example.prm that the other tests of this folder read. Arguments: see common.py."""

import common
import softgrain

softgrain.run(common.SCENE, output=common.EXAMPLE, threads=1, overwrite=True)
