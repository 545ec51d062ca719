"""mocapmend: inspect and repair optical motion-capture recordings."""

import os

__version__ = "0.1.0"

# Before numpy is loaded, and for the worker processes too. The matrices are small: several threads
# are slower, and the last bits of a repair would depend on how many processors there are.
for _library in ("OPENBLAS", "MKL", "OMP"):
    os.environ.setdefault(f"{_library}_NUM_THREADS", "1")
os.environ.setdefault("VECLIB_MAXIMUM_THREADS", "1")
