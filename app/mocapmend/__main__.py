"""`python -m mocapmend` and the installed command `mocapmend`."""

import sys
from multiprocessing import freeze_support

from mocapmend.cli import main

__all__ = ["main"]

if __name__ == "__main__":
    freeze_support()
    sys.exit(main())
