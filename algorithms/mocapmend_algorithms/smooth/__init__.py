"""Smoothing: makes measured and filled samples less jittery, never silently."""
