"""The experiment of W18: joints of a skeleton, neighbouring points missing for long.

W18 = Wang, Lu, Han 2018, "Distorted human motion capture data recovery based on skeleton
constraint", Computer Systems & Applications 27(5):17-25.
"""

from mocapmend.bench.paper.command import add_arguments, run

__all__ = ["add_arguments", "run"]
