"""Sparse codes of poses and motion: solvers, dictionaries and what they are made of."""
