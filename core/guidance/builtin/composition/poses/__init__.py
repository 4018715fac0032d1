"""Poses: sitting, riding, running, lying."""
