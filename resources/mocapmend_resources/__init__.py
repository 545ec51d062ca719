"""Data that ships with the program: skeleton templates, sample recordings, icons, credits."""
