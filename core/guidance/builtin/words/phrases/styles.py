"""Styles of a shape in a prompt: "a low poly fox", "a castle in voxel style".

Standard library only.
"""

import re
from typing import Literal

from core.guidance.builtin.words.phrases.written import without_texts

Style = Literal["", "low_poly", "voxels"]
OFFERED = "low poly", "voxel"  # in a menu

_AS = r"(?:[- ](?:style|styled|art|look|aesthetic|graphics))*"
_IN = r"(?:,? ?\b(?:in|as|with)(?: an?| the)? (?=[\w -]*(?:style|art|look|aesthetic|graphics)))?"
_NAMES: dict[Style, str] = {
    "low_poly": r"low[- ]?poly(?:gon(?:al|s)?|s)?|polygonal|lowpolygon",
    "voxels": r"voxels?|voxeli[sz]ed|voxel[- ]based|minecraft|pixel(?=[- ]art)|pixelated|8[- ]?bit",
}
_PHRASES = {
    style: re.compile(rf"{_IN}\b(?:made (?:out )?of )?(?:{names})\b{_AS}", re.IGNORECASE)
    for style, names in _NAMES.items()
}
# Materials that are a style too: their word stays.
_OF_MATERIALS: dict[Style, re.Pattern[str]] = {
    "low_poly": re.compile(
        r"\b(?:origami|papercraft|paper[- ]craft|folded paper)\b", re.IGNORECASE
    ),
    "voxels": re.compile(
        r"\blegos?\b(?! (?:brick|block|piece|set|man|men|woman|figure|minifig)|\W*$)",
        re.IGNORECASE,
    ),
}
# Else the bricks would be another thing.
_OF_BRICKS = re.compile(
    r",? (?:made|built) (?:(?:out )?of|from|with) legos?(?: bricks| blocks| pieces)?\b",
    re.IGNORECASE,
)
_ARTICLE = re.compile(r"\s*((?:an?|the) )?", re.IGNORECASE)


def style_of(prompt: str) -> tuple[str, Style]:
    """The prompt without the words of a style, and the style; the first one of two.

    What is between quotes is written on the thing, and no style.
    """
    bare = without_texts(prompt)
    found: list[tuple[int, int, Style]] = []
    for style, phrase in _PHRASES.items():
        for match in phrase.finditer(bare):
            found.append((*match.span(), style))
    if not found:
        of_material = (style for style, word in _OF_MATERIALS.items() if word.search(bare))
        if bricks := _OF_BRICKS.search(bare):  # "a castle made of lego": a lego castle
            prompt = prompt[: bricks.start()] + prompt[bricks.end() :]
            prompt = _ARTICLE.sub(r"\1lego ", prompt, count=1)
        return prompt, "voxels" if bricks else next(of_material, "")
    rest = prompt
    for start, end, _ in sorted(found, reverse=True):
        rest = f"{rest[:start]} {rest[end:]}"
    rest = re.sub(r"\s+", " ", re.sub(r"\s*,(?:\s*,)+", ",", rest)).strip(" ,")
    if not re.search(r"[^\W\d_]{2}", re.sub(r"\b(?:an?|the|in|of|style)\b", "", rest)):
        return prompt, ""  # nothing is left to be made
    return rest, min(found)[2]
