"""Background tasks: in a thread, or in a Blender process without a window."""
