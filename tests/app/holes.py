"""Gaps that the tests make in the bundled walk, 343 frames of 41 markers."""

from mocapmend_algorithms import Gap

HOLES = {"leading": Gap(4, 0, 12), "interior": Gap(9, 120, 150), "trailing": Gap(17, 330, 343)}
