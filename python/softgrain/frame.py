# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of pandas whose columns are found as those of other tables are."""

import pandas

from .errors import MissingName, told_instead
from .units import full_name


class Frame(pandas.DataFrame):
    """
    A pandas.DataFrame in which a name may be without its unit, where it is clear; of one that does
    not exist, near ones are told.
    """

    @property
    def _constructor(self):
        return Frame

    def __getitem__(self, key):
        if not isinstance(key, str) or key in self.columns:
            return super().__getitem__(key)
        full = full_name(key, self.columns)
        if full is not None:
            return super().__getitem__(full)
        raise MissingName(f"there is no '{key}' in this table; {told_instead(key, self.columns)}")
