"""One set-up, installation or build at a time in a checkout."""

import os
from pathlib import Path

try:
    import fcntl
except ImportError:
    # Windows has no such lock, and no make that would set up by itself.
    fcntl = None  # type: ignore[assignment]

ROOT = Path(__file__).parents[1]
# Tells what the holder starts that it need not wait for its own parent.
HELD = "ROTEDU_CHECKOUT_HELD"


def hold_checkout() -> None:
    """Wait until nothing else sets up or builds here; others wait until this process ends.

    The lock is on the folder itself: it leaves no file, and the system takes it off when the
    process ends, killed or not.
    """
    if fcntl is None or os.environ.get(HELD) == str(ROOT):
        return
    folder = os.open(ROOT, os.O_RDONLY)
    try:
        fcntl.flock(folder, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        print("waiting until another set-up or build in this folder has ended", flush=True)
        fcntl.flock(folder, fcntl.LOCK_EX)
    except OSError:
        # Some network file systems cannot lock a folder.
        os.close(folder)
        return
    os.environ[HELD] = str(ROOT)
