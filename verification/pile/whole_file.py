# SPDX-License-Identifier: BSD-3-Clause
"""A result is there whole or not at all, also where two write it at once."""
import contextlib
import os
import pathlib
import tempfile


@contextlib.contextmanager
def whole_file(target):
    """A new file beside target, which takes its name where the block ends well and is gone where it does not. Folders that are not there
    are made."""
    target.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
    os.close(handle)
    path = pathlib.Path(name)
    try:
        yield path
        umask = os.umask(0)
        os.umask(umask)
        path.chmod(0o666 & ~umask)
        path.replace(target)
    finally:
        path.unlink(missing_ok=True)
