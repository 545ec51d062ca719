"""Many recordings repaired by one plan: on all cores, or on a Dask cluster. No Qt."""
