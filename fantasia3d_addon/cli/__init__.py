"""The command line inside Blender: what run.py carries out with the bpy module."""
