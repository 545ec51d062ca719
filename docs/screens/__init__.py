"""Pictures of every screen of the program."""
