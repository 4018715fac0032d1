"""Mesh tools: health check, texture maps, levels of detail, quad remesh, export, Asset Browser."""
