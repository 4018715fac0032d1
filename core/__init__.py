"""Fantasia3D's method in torch: text in, a textured mesh out. Never imports bpy or the add-on."""

__version__ = "0.1.0"
