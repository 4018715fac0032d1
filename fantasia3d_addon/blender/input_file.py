"""Files that somebody else may have put there: regular ones, before they are opened."""

from __future__ import annotations

import errno
import os
from pathlib import Path


def require_file(path: Path) -> None:
    """Raise OSError for what is no regular file; to open a pipe would wait for its writer forever.

    What is not there at all, or not permitted, is for who opens it.
    """
    is_other = os.path.exists(path) and not os.path.isfile(path)  # noqa: PTH110, PTH113
    if is_other:
        number = errno.EISDIR if os.path.isdir(path) else errno.EINVAL  # noqa: PTH112
        text = os.strerror(number) if number == errno.EISDIR else "it is a pipe or a device"
        raise OSError(number, text, str(path))
