"""Make what methods learn from."""
