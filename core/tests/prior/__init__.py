"""Tests: the training of the built-in prior."""
