"""Food; fruit and vegetables are among it."""

from core.guidance.builtin.nouns.fruits import FRUITS

FOOD = {**FRUITS}
