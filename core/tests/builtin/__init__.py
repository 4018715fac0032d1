"""Tests: what the built-in prior draws, composes and paints."""
