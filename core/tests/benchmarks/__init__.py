"""Tests: benchmarks and the paper's rows."""
