"""Words for a part of a known thing: "red velvet" on a chair is seen as a red velvet chair.

Standard library only.
"""

from core.errors import UserError
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse, words_report


def of_whole(words: str, whole: str) -> str:
    """A prompt that the built-in prior knows, for the thing that ``whole`` names, made of
    ``words``.

    ``words`` themselves where they name a thing, or where none of them is known: the error of such
    a prompt is more useful than that of another text.
    """
    if words_report(words)[1] == 0:
        return words
    try:
        stated = parse(words, noun_needed=False, ignore_unknown=True)
        thing = parse(whole, ignore_unknown=True)
    except UserError:
        return words
    look = _look(stated) or ""
    # A colour alone is paint: the material below stays.
    paint = look and not stated.material and thing.material_form
    prompt = " ".join(filter(None, ("a", look, paint, thing.noun)))
    return prompt if look and words_report(prompt)[1] == 0 else words


def _look(words: Words) -> str:
    """Pattern, colour and material, the material as written."""
    return " ".join(filter(None, (words.pattern, words.color, words.material_form)))
