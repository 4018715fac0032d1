"""Tests: what is understood of a prompt."""
