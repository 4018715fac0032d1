"""Dishes and what is bought packed; with fruit and vegetables all the new food."""

from core.prior.things.fruits import FRUITS

FOOD = {**FRUITS}
