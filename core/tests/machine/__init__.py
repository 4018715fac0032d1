"""Tests: the command line, the environment and the tree."""
