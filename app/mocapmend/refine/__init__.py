"""Refining recordings of cheap sensors with trained networks, and training them. No Qt."""
