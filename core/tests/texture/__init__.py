"""Tests: charts, baking and detail."""
