"""Helpers for bpy: version differences, mesh arrays, names, PNG files."""
