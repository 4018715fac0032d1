"""Solids, outlines and measures that several of the themes use."""
