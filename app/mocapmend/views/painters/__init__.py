"""What the 3D view shows, one kind of thing per module: functions that paint one frame."""
