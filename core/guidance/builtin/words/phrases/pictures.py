"""Phrases about a picture or a file of the thing: "a wide angle photo of a chair", "a chair, studio
lighting, 8k". They mean nothing for an asset, and are removed without a note.

Standard library only.
"""

import re

from core.guidance.builtin.words.phrases.emblems import drawn_in
from core.guidance.builtin.words.tables.words import OF_PICTURES

# Words that "of" follows, at the start of a prompt.
_PICTURES = frozenset(
    """photo photograph photography picture image shot snapshot screenshot view render rendering
    closeup headshot model file mesh asset sculpt""".split()
)
_NAMED = {("close", "up"), ("concept", "art"), ("matte", "painting"), ("digital", "painting")}
# Words about a picture and about nothing else.
_SURELY = frozenset(
    """dslr 4k 8k 16k hd uhd hdr bokeh octane cycles eevee vray keyshot redshift zbrush c4d 4d
    sketchfab artstation deviantart cgsociety behance unreal ue5 raytraced raytracing
    photorealistic photoreal hyperrealistic photo photograph photography picture image snapshot
    screenshot render rendering rendered shot view closeup resolution lighting background
    backdrop centered centred isometric orthographic cinematic masterpiece archviz macro
    headshot stl glb gltf fbx zoomed""".split()
)
# Words that are about a picture only beside one of those.
_BESIDE = frozenset(
    """a an the on in of with from at for and wide angle low high ultra very highly extremely
    extreme close up tilt shift overhead aerial top down side front back rear bird birds eye s
    perspective product studio hero full body frame octane unreal engine 5 realistic detailed
    detail details quality best professional stock raw color colour award winning clean sharp
    focus soft natural dramatic volumetric global illumination ambient occlusion ray traced
    tracing depth field trending 3d 2d cg made using blender cinema unity maya plain simple
    neutral solid transparent isolated file model mesh asset sculpt zoomed out dof uhd 100mm
    50mm 35mm 85mm lens shallow softbox rim beautiful stunning shadows textures texture light
    design turntable""".split()
)
_GROUNDS = frozenset(("background", "backdrop"))
_COLORS = frozenset("white black grey gray dark light".split())  # of a background
_KNOWN = _SURELY | _BESIDE | _PICTURES
_WORD = re.compile(r"[\w’']+")
_LEADS = re.compile(r"\s*(?P<said>(?:[\w’'-]+,? ){1,9}?)of (?=\w)", re.IGNORECASE)
_CLAUSE = re.compile(r"[,;.|]+(?=\s|$)")


def of_no_picture(prompt: str) -> str:
    """The prompt without its phrases about a picture."""
    prompt = _without_lead(prompt)
    written = [(start, end) for _, start, end in drawn_in(prompt)]
    ends = [found for found in _CLAUSE.finditer(prompt) if not _is_within(found.start(), written)]
    begins = [0, *(found.end() for found in ends)]
    clauses = [
        prompt[begin:end] for begin, end in zip(begins, [*begins[1:], len(prompt)], strict=True)
    ]
    kept = [clause for clause in clauses if not _is_of_picture(clause)]
    if len(kept) == len(clauses) or not any(map(_WORD.search, kept)):
        return prompt
    return "".join(kept).strip().rstrip(",;|")


def _without_lead(prompt: str) -> str:
    """ "A zoomed out DSLR photo of a hippo" is a hippo."""
    match = _LEADS.match(prompt)
    words = _words(match["said"]) if match else []
    if tuple(words[-2:]) in _NAMED:
        words = [*words[:-2], "picture"]
    is_picture = words[-1:] and words[-1] in _PICTURES and set(words) <= _KNOWN
    return prompt[match.end() :] if match and is_picture else prompt


def _is_of_picture(clause: str) -> bool:
    words = _words(clause)
    colors = _COLORS if _allows_color(words) else frozenset()
    is_sure = not _SURELY.isdisjoint(words) or " ".join(words) in OF_PICTURES
    return is_sure and set(words) <= _KNOWN | colors


def _allows_color(words: list[str]) -> bool:
    """Whether a colour is the background's: "plain white background", "product shot on white"."""
    on = [words[k + 1] for k, word in enumerate(words[:-1]) if word == "on"]
    return not _GROUNDS.isdisjoint(words) or bool(_COLORS.intersection(on))


def _words(text: str) -> list[str]:
    return re.sub(r"[’']s\b", "", text.lower().replace("-", " ")).replace(",", " ").split()


def _is_within(at: int, spans: list[tuple[int, int]]) -> bool:
    return any(start <= at < end for start, end in spans)
