"""Tests: materials and light."""
