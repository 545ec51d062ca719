"""Gap filling: one method per file, listed in `registry`."""
