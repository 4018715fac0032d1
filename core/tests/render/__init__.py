"""Tests: rasterizing and gradients."""
