"""Refinement of cheap skeletons, as of the Kinect, by stacked autoencoders (Y23)."""
