"""How large and how heavy the thing of a prompt usually is. Standard library only."""

from core.errors import UserError
from core.guidance.builtin.sizes import usual
from core.guidance.builtin.vocabulary import Words, parse


def usual_of(prompt: str) -> tuple[float, float]:
    """The usual size in metres and density in kg/m³ of what ``prompt`` names; of an unknown thing
    1 m and that of light wood. For any guidance: its prompt may be beyond the built-in words."""
    try:
        words = parse(prompt, noun_needed=False, ignore_unknown=True)
    except UserError:  # such as two nouns
        words = Words()
    return usual(words.noun, words.material, words.is_toy)
