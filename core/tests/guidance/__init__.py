"""Tests: distillation and Stable Diffusion."""
