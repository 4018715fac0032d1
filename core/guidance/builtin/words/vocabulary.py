"""The parser of the built-in prior's prompts, which refuses unknown words by name.

A prompt is parsed into slots (``Words``). Order is free; articles, plurals, case and filler are
skipped. A note reports every deviation: a close misspelling that is read as a known word, a
narrower word that is made as a wider one, an adjective that is left out, an unknown word before a
known noun ("office chair"), also left out. Any other unknown word is an error that names it, or, on
the user's request, is left out too.

Standard library only, so that ``run.py words`` and the panel need not load a network.
"""

import re
from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import cache
from typing import Any

from core.errors import UserError
from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.offered import offered_words
from core.guidance.builtin.words.asking import asked_for
from core.guidance.builtin.words.companions.bouquets import as_bouquet, in_bunches
from core.guidance.builtin.words.companions.fillings import in_a_vessel
from core.guidance.builtin.words.companions.fit import Found, Read, Reader
from core.guidance.builtin.words.companions.gathering import in_a_row
from core.guidance.builtin.words.companions.glassware import usual_of_whole
from core.guidance.builtin.words.companions.joined import with_companions, without_look
from core.guidance.builtin.words.companions.known_as import FLOWERS, ON_BODIES, is_dressed
from core.guidance.builtin.words.companions.offspring import parents_named
from core.guidance.builtin.words.companions.passives import as_phrase, made_active
from core.guidance.builtin.words.companions.rephrasing import (
    grown_last,
    roof_first,
    snake_first,
    tree_first,
    turned_around,
)
from core.guidance.builtin.words.companions.roles import first_names, undisguised
from core.guidance.builtin.words.companions.search import MOST, companions_in, one_more
from core.guidance.builtin.words.companions.toppings import (
    in_toppings,
    with_its_liquid,
    without_replaced,
)
from core.guidance.builtin.words.grammar.counts import is_plain_plural
from core.guidance.builtin.words.grammar.findings import Findings
from core.guidance.builtin.words.grammar.lexicon import LEXICON, MEANT, SLOTS, Vocabulary
from core.guidance.builtin.words.grammar.made_of import as_made_of
from core.guidance.builtin.words.grammar.openers import ends_in_name, is_doing
from core.guidance.builtin.words.grammar.part_names import looks_of, own_name
from core.guidance.builtin.words.grammar.prompt_errors import (
    ELSEWHERE,
    PromptError,
    TwoWordsError,
    UnknownWordsError,
    known_things,
    unknown_error,
)
from core.guidance.builtin.words.grammar.reading import Reading
from core.guidance.builtin.words.idioms import in_known_words
from core.guidance.builtin.words.phrases.cuts import SLICE_SIZE, cut_of, in_cut_words
from core.guidance.builtin.words.phrases.emblems import emblems_in, plural
from core.guidance.builtin.words.phrases.moods import mood_in
from core.guidance.builtin.words.phrases.pictures import of_no_picture
from core.guidance.builtin.words.phrases.poses import in_a_word, pose_of
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.phrases.styles import style_of
from core.guidance.builtin.words.phrases.written import apart_from_texts
from core.guidance.builtin.words.tables.count_words import FEW
from core.guidance.builtin.words.tables.sorts import sort_of
from core.guidance.builtin.words.tables.words import ARTICLES, GLASSWARE, PLAIN, WEATHERS

W_SLASH = re.compile(r"(?<!\w)w/ ?(?!o\b)", re.IGNORECASE)
DENIM_BLUE = "denim blue"
OWN_EMBLEM = "emblem"  # a part by that name
# "My dog is a brown dachshund".
MINE = re.compile(r"^\s*(?:my|our) (?:\w+ ){1,2}?is (?=(?:an?|the) )", re.IGNORECASE)
_ANOTHER = r" (?=(?:an?|two|three|the|its|his|her) )"
AND = re.compile(rf",? (?:and|with){_ANOTHER}", re.IGNORECASE)
COMES_FROM = ("from", "for", "at", "by")
ARTICLE = re.compile(r"\s*(?:an?|the|my|one) ", re.IGNORECASE)
NATURAL = ("Food", "Fruit and Vegetables", "Plants", "Animals", "Wild Animals")  # of own colours
BARE_AND = re.compile(r" and ", re.IGNORECASE)  # "bacon and eggs"
# "A phone stand shaped like an octopus"
LOOKS_LIKE = re.compile(
    r"^\s*(?:an? |the )?(?P<what>[^,;:.]+?) (?:(?:that |which )?looks like|shaped (?:like|as)|"
    r"in the (?:shape|form) of) (?=(?:an?|the) )",
    re.IGNORECASE,
)
NEXT_TO = re.compile(
    r" (?:(?:standing|sitting|lying|resting|placed|parked) )?"
    rf"(?:(?:right )?(?:next to|beside)|(?:leaning|propped)(?: up)? (?:against|on)){_ANOTHER}",
    re.IGNORECASE,
)


def understood(
    prompt: str, known: Vocabulary | None = None, ignore_unknown: bool = False
) -> dict[str, Any]:
    """The built-in prior's reading of ``prompt``, as plain data.

    Args:
        known: the offered words; None: those of the shipped weights.
        ignore_unknown: leave out unknown words.

    Raises:
        UserError: as ``parse``; ``UnknownWordsError`` has the nearest known words.
    """
    known = offered_words() if known is None else known
    words = parse(prompt, known=known, ignore_unknown=ignore_unknown)
    usual_m, density = usual_of_whole(words)
    size_m, side = words.size or (usual_m, "length")
    return {
        "prompt": prompt,
        **_looks(words),
        "style": words.style or None,
        "shape": words.shape or None,
        "parts": words.stated_parts(),
        "part_sheens": words.of_parts("sheen"),
        "part_patterns": words.part_patterns(),
        "weather": list(words.weather),
        "sheen": list(words.sheen),
        "companions": [{"relation": one.relation, **_looks(one.words)} for one in words.companions],
        "size_m": size_m,
        "side": side,
        "density": density,
        "left_out": list(words.left_out),
        "notes": list(words.notes),
    }


def _looks(words: Words) -> dict[str, Any]:
    """A thing, and its look."""
    second = "" if words.target else words.second_form or words.second
    return {
        "thing": words.noun,
        "pose": words.pose or None,
        "mood": words.mood or None,
        "cut": words.cut or None,
        "count": words.count,
        "order": words.order,
        "colours": [color for color in (words.color_form or words.color, second) if color],
        "part_sizes": dict(words.part_sizes),
        "part_counts": dict(words.part_counts),
        "part_colours": words.part_shades(),
        "materials": [words.named_material()] if words.material else [],
        "part_materials": words.part_materials(),
        "pattern": words.pattern or None,
        "emblems": [str(emblem) for emblem in words.emblems],
    }


def words_report(prompt: str, ignore_unknown: bool = False) -> tuple[dict[str, Any], int]:
    """``understood`` and exit code 0; or the reason why the prompt is refused, with the nearest
    known words of each unknown one, and the error's exit code."""
    try:
        return understood(prompt, ignore_unknown=ignore_unknown), 0
    except UserError as error:
        nearest = error.nearest if isinstance(error, UnknownWordsError) else {}
        report = {"prompt": prompt, "error": error.text, "fix": error.fix, "nearest": nearest}
        return report, error.status


def parse(
    prompt: str,
    *,
    noun_needed: bool = True,
    known: Vocabulary = SLOTS,
    ignore_unknown: bool = False,
) -> Words:
    """Parse a prompt into slots; ``known``: the offered words.

    Raises ``UserError`` that names every unknown word with the nearest known ones (unless
    ``ignore_unknown``), two things, a part that the thing cannot lack or have, and a missing noun
    unless ``noun_needed`` is false (a negative prompt).
    """
    if not noun_needed:
        return _parsed(prompt, False, known, ignore_unknown)
    prompt, style = style_of(W_SLASH.sub("with ", prompt))
    prompt = apart_from_texts(prompt, lambda text: as_made_of(in_known_words(in_toppings(text))))
    prompt = apart_from_texts(prompt, in_cut_words)
    prompt = of_no_picture(asked_for(prompt))
    prompt = apart_from_texts(grown_last(prompt), turned_around)
    prompt = roof_first(tree_first(snake_first(prompt)))
    prompt = made_active(as_phrase(parents_named(MINE.sub("", prompt))))
    bunched = apart_from_texts(prompt, in_bunches)
    words = as_bouquet(_of_thing(bunched, known, ignore_unknown), prompt)
    return replace(without_replaced(words), style=style)


def _of_thing(prompt: str, known: Vocabulary, ignore_unknown: bool) -> Words:
    """``parse`` of a prompt that says nothing of a picture or a style."""
    if row := _row(prompt, known, ignore_unknown):
        return row
    if pair := _side_by_side(NEXT_TO, prompt, known, ignore_unknown):
        return pair
    try:
        return _parsed(prompt, True, known, ignore_unknown)
    except TwoWordsError:
        for joins in (AND, BARE_AND):
            if pair := _side_by_side(joins, prompt, known, ignore_unknown):
                return pair
        raise
    except UnknownWordsError:
        if match := LOOKS_LIKE.match(prompt):
            words = parse(prompt[match.end() :], known=known, ignore_unknown=ignore_unknown)
            note = f"{match['what']}: left out, as only what it looks like is known."
            left_out = (*match["what"].split(), *words.left_out)
            return replace(words, notes=(note, *words.notes), left_out=left_out)
        raise


def _side_by_side(
    joins: re.Pattern[str], prompt: str, known: Vocabulary, ignore_unknown: bool
) -> Words | None:
    """ "A table and a chair": the second next to the first, where one of ``joins`` is between."""
    for joined in joins.finditer(prompt):
        phrase = prompt[joined.end() :]
        try:
            first = _parsed(prompt[: joined.start()], True, known, ignore_unknown, MOST - 1)
            other = _parsed(phrase, True, known, ignore_unknown)
        except UserError:
            continue
        if other.companions and not first.companions:  # "a chair next to a table with a lamp"
            phrase, first, other = prompt[: joined.start()], other, first
        whole = len(first.companions) < MOST and not other.companions
        whole &= joins is not BARE_AND or _is_one_name(phrase)
        if whole and first.noun != other.noun:
            if joins is BARE_AND:
                other = _with_shared_look(first, prompt[: joined.start()], phrase, other)
            pair = with_companions(first, [Found("beside", phrase, other)])
            return replace(pair, companions=(*first.companions, *pair.companions))
    return None


def _row(prompt: str, known: Vocabulary, ignore_unknown: bool) -> Words | None:
    """ "A fork, a knife and a spoon": each next to the first."""
    phrases = in_a_row(prompt)
    if not 0 < len(phrases) <= MOST + 1:
        return None
    try:
        first, *others = (_parsed(phrase, True, known, ignore_unknown) for phrase in phrases)
    except UserError:
        return None
    if len({one.noun for one in (first, *others)}) < len(phrases):
        return None
    pairs = zip(phrases[1:], others, strict=True)
    return with_companions(first, [Found("beside", phrase, other) for phrase, other in pairs])


def _is_one_name(phrase: str) -> bool:
    """Whether it ends with one thing's name, or with what that does: no "cheese sandwich"."""
    names = list(first_names(phrase))
    behind = phrase[names[0].end :].split() if names else []
    return len(names) == 1 and (not behind or behind[0] in COMES_FROM or is_doing(behind[0]))


def _with_shared_look(first: Words, before: str, phrase: str, other: Words) -> Words:
    """The second of two with the material and the colour before both: "a wooden desk and chair"."""
    said = without_look(before) != before and ends_in_name(before, first.noun)
    both = ARTICLE.match(before) and other.material + other.color + other.pattern == ""
    colored = any(other.noun in GROUPS[group] for group in NATURAL)
    if not (said and both) or phrase.split()[0].lower() in ARTICLES:
        return other
    looks = ("material", "material_form") + (() if colored else ("color", "color_form"))
    return replace(other, **{look: getattr(first, look) for look in looks})


def _parsed(
    prompt: str, noun_needed: bool, known: Vocabulary, ignore_unknown: bool, room: int = MOST
) -> Words:
    """``room``: the number of companions that a costume may add."""
    if not noun_needed:
        return _parse_alone(prompt, False, known, ignore_unknown)
    prompt, costume = undisguised(prompt)
    readers = _readers(known, ignore_unknown)
    companions, rest = _companions(prompt, readers, costume, room)
    try:
        words = _parse_alone(rest, True, known, ignore_unknown)
    except UserError:  # the rest is not a prompt by itself
        if not companions:
            raise
        return _parse_alone(prompt, True, known, ignore_unknown)
    while len(companions) < min(room, MOST):
        more, shorter = one_more(rest, *readers, companions, words.left_out)
        try:
            shorter_words = _parse_alone(shorter, True, known, ignore_unknown) if more else words
        except UserError:
            break
        if not more or shorter_words.noun != words.noun:
            break
        companions, rest, words = [*companions, *more], shorter, shorter_words
    others = [(one.relation, one.words.noun) for one in companions]
    words = in_a_vessel(words, rest, others) if companions else words
    bunched = companions and words.noun in FLOWERS  # ``as_bouquet`` counts these
    one = words.count == 1 and words.order == "row" and not words.is_statue
    if one and not bunched and is_plain_plural(rest):
        words = replace(words, count=FEW)
    return with_companions(words, companions) if companions else words


def _readers(known: Vocabulary, ignore_unknown: bool) -> tuple[Reader, Callable[[str], str]]:
    """Functions that parse a phrase by itself, and that find the thing that a text names first."""

    @cache
    def read(phrase: str) -> Read | None:
        try:
            words = _parse_alone(phrase, True, known, ignore_unknown)
        except UserError:
            return None
        got = _read(emblems_in(phrase)[1], known, True)
        entries = got.found["noun"]
        return Read(entries[0], words, got.counted.stated) if entries else None

    @cache
    def first_of(text: str) -> str:
        return _read(text, known, True).thing

    return read, first_of


def _companions(
    prompt: str,
    readers: tuple[Reader, Callable[[str], str]],
    costume: Iterable[str],
    room: int,
) -> tuple[list[Found], str]:
    """The companions that the prompt requests, and the prompt without them; those of a costume come
    last."""
    read, first_of = readers
    found, rest = companions_in(prompt, read, first_of)
    thing = first_of(rest)
    for one in costume if is_dressed(thing) else ():
        worn, _ = companions_in(f"{thing} {one}", read, first_of, found)
        for more in worn[len(found) : room]:
            if not any(_are_equivalent(more, other) for other in found):
                # The prompt states neither it nor a look, which would not be a statue's.
                quiet = replace(more.words, notes=(), left_out=())
                found.append(more._replace(words=quiet, phrase=without_look(more.phrase)))
    return found, rest


def _are_equivalent(one: Found, other: Found) -> bool:
    """Whether both are in a hand, on a body, or the same."""
    both = {one.words.noun, other.words.noun}
    held = one.relation == other.relation == "holds"
    return held or len(both) == 1 or both <= ON_BODIES


def _parse_alone(prompt: str, noun_needed: bool, known: Vocabulary, ignore_unknown: bool) -> Words:
    """As ``parse``, for a prompt about one thing."""
    emblems, rest = emblems_in(prompt) if noun_needed else ((), prompt)
    got = _read(rest, known, noun_needed)
    shapes = {emblem.shape for emblem in emblems if emblem.shape}
    called = {one: (one, one.split()[0], plural(one)) for one in shapes}
    own = {one for one in shapes if any(own_name(got.thing, w) for w in called[one])}
    if own:  # a medal's star is a part of it
        emblems, rest = emblems_in(prompt, own)
        got = _read(rest, known, noun_needed)
    mooded, shorter = mood_in(got.thing, in_a_word(got.thing, rest))
    if shorter != rest:
        rest, got = shorter, _read(shorter, known, noun_needed)
    if emblems and noun_needed and not got.found["noun"]:  # the quoted words may be the thing
        emblems, got = (), _read(prompt, known, noun_needed)
    # Before the missing noun: an error with the nearest known words is more useful.
    if got.refused and not ignore_unknown:
        raise unknown_error(got.refused, got.qualifiers, known)
    if noun_needed and not got.found["noun"]:
        # A face is known, but only as a part of a clock.
        things = [part for part, *_ in got.parts if part in MEANT]
        if things:
            raise unknown_error(things, [], known)
        raise PromptError(
            f"The prompt {prompt.strip()!r} does not name a thing the built-in model knows.",
            f"{known_things(known)} {ELSEWHERE}",
        )
    sort = sort_of(got.thing, prompt) or got.sort
    got.take_as_sort(sort.stated)
    pose, stated = pose_of(got.thing, rest)
    got.take_as_sort(stated)
    cut, stated = cut_of(got.thing, rest, got.is_statue)
    got.take_as_sort(stated)
    # The part last: its possible words depend on the noun.
    words = {slot: got.only(slot) for slot in ("noun", "shape", "material", "pattern")}
    words |= got.colors() | {"part": got.part(words["noun"])}
    words["absent"] = got.absent(words["noun"])
    if emblems and OWN_EMBLEM in looks_of(words["noun"]):  # a coin's eagle makes room
        words["absent"] = tuple(dict.fromkeys((*words["absent"], OWN_EMBLEM)))
    words |= {"pose": pose, "mood": "" if mooded.is_drawn else mooded.mood, "cut": cut}
    words["part_sizes"] = got.part_sizes(words["noun"])
    words["part_counts"] = got.part_counts(words["noun"])
    # In the table's order: snow is on dirt.
    words["weather"] = tuple(w for w in WEATHERS if w in got.words("weather"))
    words["sheen"] = tuple(got.words("sheen"))
    words |= {"is_statue": got.is_statue, "is_toy": got.is_toy, "kinds": sort.kinds}
    words |= {"kind_size": got.kind_size() or sort.size_m, "size": got.size()}
    words["scale"] = got.scale * (SLICE_SIZE if cut == "slice" else 1.0)
    # "Upholstered in velvet": "upholstered" only states fabric.
    forms = [one.form for one in got.found["material"] if one.word == words["material"]]
    words["material_form"] = next(
        (form for form in forms if form not in PLAIN), forms[0] if forms else ""
    )
    if not words["material"] and {entry.form for entry in got.found["noun"]} & GLASSWARE:
        words["material"] = words["material_form"] = "glass"
    words["emblems"] = (*emblems, *mooded.face())
    words["count"], words["order"], _ = got.counted
    words |= _of_denim(words, {entry.form for entry in got.found["noun"]})
    notes = dict.fromkeys([*got.notes, *mooded.notes, *got.narrower(), *got.omissions()])
    left_out = tuple(dict.fromkeys([*got.left_out, *got.aside]))
    names = [entry.form for entry in got.found["noun"]]
    return with_its_liquid(Words(**words, notes=tuple(notes), left_out=left_out), names)


def _of_denim(words: dict[str, Any], names: set[str]) -> dict[str, str]:
    """The blue of blue jeans, and of blue denim things."""
    denim = words["material_form"] == "denim" or names & {"jeans", "jean"}
    if not denim or (words["color_form"] or words["color"]) != "blue":
        return {}
    _, color = LEXICON[DENIM_BLUE]
    return {"color": color, "color_form": DENIM_BLUE}


def _read(prompt: str, known: Vocabulary, noun_needed: bool) -> Findings:
    """The findings of the words; without a thing, a word that may be one by itself."""
    got = Reading(prompt, known).got
    if noun_needed and not got.found["noun"]:
        got = Reading(prompt, known, alone=True).got
    return got
