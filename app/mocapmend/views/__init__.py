"""The window and its parts: they show the document and ask actions to change it."""
