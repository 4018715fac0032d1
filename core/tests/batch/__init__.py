"""Tests: many runs, on many machines."""
