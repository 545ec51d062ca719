"""Training of refinement networks. It needs PyTorch, which inference does not."""
