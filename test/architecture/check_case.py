# SPDX-License-Identifier: BSD-3-Clause
"""A check applied to a small project in a folder of its own."""

import tempfile
from pathlib import Path


def complaints(check, project, changes=()):
    """Messages of a check for a project (path -> text) with some files replaced (None: removed)."""
    with tempfile.TemporaryDirectory() as place:
        root = Path(place).resolve()
        for name, text in {**project, **dict(changes)}.items():
            if text is not None:
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
        return check(root)
