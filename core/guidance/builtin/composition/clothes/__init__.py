"""Clothes, cut to the surface of their wearer."""
