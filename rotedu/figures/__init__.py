"""From a pyvista scene to a figure of a page or a notebook; knows nothing of rotations."""
