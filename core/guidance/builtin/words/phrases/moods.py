"""Moods in words: "an angry bear", "a cactus with a smiling face".

A thing with eyes shows a mood by its lids, its brows and its mouth; on others a face is drawn.
Standard library only.
"""

import re
from typing import Literal, NamedTuple

from core.guidance.builtin.words.grammar.part_names import looks_of
from core.guidance.builtin.words.phrases.emblems import Emblem
from core.guidance.builtin.words.tables.living import is_creature
from core.guidance.builtin.words.tables.sorts import says

Mood = Literal["", "happy", "sad", "angry", "sleepy", "surprised"]

MOODS: tuple[Mood, ...] = ("happy", "sad", "angry", "sleepy", "surprised")
EYES = "eyes"
FACE_ON = {"mushroom": "stem", "tree": "trunk", "oak tree": "trunk"}
CARVED = ("jack-o-lantern",)  # its face is of its own
ALSO_FACED = frozenset(
    "tooth bone starfish jellyfish brain hand".split()
)  # and all lifeless things
NO_FACES = frozenset(("coconut", "rover"))  # with "eyes" of another sort
DULL_EYES = frozenset(
    "butterfly;chess knight;gargoyle;gingerbread man;golem;grim reaper;jack-o-lantern;mask;mimic;"
    "moai;mummy;piggy bank;sarcophagus;scarecrow;skeleton;skull;totem pole".split(";")
)  # carved, hollow, of stone or of buttons: nothing is reflected in them
_WORDS: dict[Mood, str] = {
    "happy": "happy, smiling, smiley, cheerful, joyful, jolly, laughing, grinning, joyous, merry, "
    "delighted, gleeful, beaming",
    "sad": "sad, unhappy, crying, weeping, gloomy, tearful, frowning, depressed, melancholy, "
    "melancholic, sorrowful, disappointed, heartbroken, miserable",
    "angry": "angry, furious, grumpy, mad, enraged, raging, scowling, cranky, cross looking, "
    "glaring",
    "sleepy": "sleepy, tired, drowsy, bored, exhausted, weary, sleepy looking",
    "surprised": "surprised, shocked, amazed, astonished, startled, stunned",
}
# What is shown by a mood that is not its own; on a thing without eyes these change nothing.
_SHOWN: dict[Mood, str] = {
    "happy": "friendly, playful, excited",
    "sad": "worried, lonely, ashamed, sorry",
    "angry": "evil, fierce, menacing, sinister, vicious, ferocious, aggressive, wicked, mean, "
    "villainous, threatening, scary, determined, mischievous, devilish",
    "sleepy": "lazy, stoned, relaxed, calm",
    "surprised": "scared, frightened, terrified, confused",
}
_FACE = r"(?:face|expression|smile|grin|frown|look|eyes)"
_ON = r"(?: on (?:it\b|(?:its|his|her|their|the) face))?"
_LOOKS = r"(?:(?:cute|little|big|simple|kawaii|adorable|tiny|lovely|sweet|funny|cartoon) )*"
# "With a cute face", "with eyes and a smile"
_ANY_FACE = re.compile(
    rf"\b(?:with|has|having) (?:an? )?{_LOOKS}(?:face|eyes and an? {_LOOKS}(?:smile|mouth))\b"
    rf"{_ON}",
    re.IGNORECASE,
)
_WITH = re.compile(
    rf"(?:,? (?:with|and|has|having|wearing) (?:an? |the )?{_LOOKS})?"
    rf"\b(?P<word>[a-z]+(?: looking)?) {_FACE}\b{_ON}",
    re.IGNORECASE,
)
_SMILE = re.compile(
    rf",? \b(?:with|has|having) (?:an? )?(?:[a-z]+ ){{0,2}}?(?P<word>smile|grin|frown)\b"
    rf"{_ON}",
    re.IGNORECASE,
)
_NOT_MOODS = re.compile(
    r"\b(?:happy (?:birthday|new year|halloween|christmas|holidays?|easter|meal|hour)|"
    r"cross looking glass|mad (?:scientist|hatter|max)|laughing gas|sad sack|merry christmas|"
    r"jolly roger|merry[- ]go[- ]round|crying shame|evil eye|mean time|smiley faces?|smileys?)\b",
    re.IGNORECASE,
)


class Mooded(NamedTuple):
    """The mood of a prompt's thing."""

    mood: Mood = ""
    notes: tuple[str, ...] = ()
    is_drawn: bool = False  # as a face on a thing without eyes
    on: str = ""  # a part, where it would be lost among spots elsewhere

    def face(self) -> tuple[Emblem, ...]:
        """The drawn face."""
        return (Emblem(shape=f"{self.mood} face", on=self.on),) if self.is_drawn else ()


def has_face(noun: str) -> bool:
    """Whether the thing has eyes that show a mood."""
    return EYES in looks_of(noun) and noun not in NO_FACES


def is_lively(noun: str) -> bool:
    """Whether light is reflected in its eyes."""
    return has_face(noun) and noun not in DULL_EYES


def mood_in(noun: str, prompt: str) -> tuple[Mooded, str]:
    """The mood of the thing in a prompt about it alone, and the prompt without its words."""
    faced = has_face(noun)
    if not noun or noun in CARVED or (not faced and is_creature(noun) and noun not in ALSO_FACED):
        return Mooded(), prompt
    rest = _as_words(prompt)
    states_face = rest != prompt
    rest = rest if faced else _ANY_FACE.sub(" smiling", rest)
    text = re.sub(r"[\W_]+", " ", _NOT_MOODS.sub(" ", rest.lower()))
    own = _WORDS if faced else _WORDS | {"happy": f"{_WORDS['happy']}, kawaii"}
    for table in (own, _SHOWN) if faced or states_face else (own,):
        for mood in MOODS:
            if stated := [word for word in table[mood].split(", ") if says(text, word)]:
                said = ", ".join(stated)
                notes = (f"{said}: shown as {mood}.",) if table is _SHOWN else ()
                words = rf",?\s*(?<![\w-])(?:{'|'.join(stated)})(?![\w-])"
                rest = re.sub(words, "", rest, flags=re.IGNORECASE)
                found = Mooded(mood, notes, not faced, FACE_ON.get(noun, ""))
                return found, re.sub(r"\s+", " ", rest).strip()
    return Mooded(), prompt


def _as_words(prompt: str) -> str:
    """The prompt with "smiling" in place of "with a smiling face"."""
    prompt = _WITH.sub(lambda found: f" {found['word']}" if _is_mood(found) else found[0], prompt)
    return _SMILE.sub(
        lambda found: " frowning" if found["word"].lower() == "frown" else " smiling", prompt
    )


def _is_mood(found: re.Match[str]) -> bool:
    forms = ", ".join((*_WORDS.values(), *_SHOWN.values())).split(", ")
    return found["word"].lower() in forms
