"""Tests: runs, their files and faults."""
