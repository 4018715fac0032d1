"""Likenesses: the thing that a prompt's thing depicts, and their materials. Standard library only.

A statue of a lion is a lion of one material; a stuffed bunny is a small one of plush; a crow is a
black bird.
"""

from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.substances import BURNING, lights, natural_kind
from core.guidance.builtin.words.grammar.accents import StatedPart
from core.guidance.builtin.words.grammar.clauses import NOT_GIVEN, Clauses
from core.guidance.builtin.words.grammar.findings import with_article
from core.guidance.builtin.words.grammar.lexicon import Entry, look_up
from core.guidance.builtin.words.grammar.part_names import looks_of, own_name
from core.guidance.builtin.words.tables.colors import CALLED_SHADES, TASTES, shade
from core.guidance.builtin.words.tables.kinds import TABBY, TABBY_STRIPES, look_of_kind
from core.guidance.builtin.words.tables.living import is_animal, is_creature, is_somebody
from core.guidance.builtin.words.tables.sizes import TOY_SIZE, usual
from core.guidance.builtin.words.tables.words import (
    AGES,
    ALIGHT,
    ALSO_OF_FUR,
    AS_MATERIAL,
    BUSTS,
    CARVED,
    CAST,
    COLORED,
    DEPICTIONS,
    EDIBLE,
    FILMS,
    FOLDABLE,
    FOLDED,
    GEMS,
    LIT,
    MASSES,
    MOULDED,
    OF_ANIMALS,
    ONLY_OF,
    PLUSHIES,
    ROBOTS,
    SEWN,
    SHAPED_OF,
    SMALL_FIGURES,
    STATUES,
)

WOVEN = "wicker"
KINDS = {
    "buildings": lambda thing: thing in GROUPS["Buildings"],
    "creatures": is_creature,
    "animals": is_animal,
}
TASTED = "ice cream"
GROWN = ("Food", "Fruit and Vegetables", "Plants")  # which take more than the colour of a fruit


class Likeness(Clauses):
    """The parsed likeness of a thing."""

    def _is_depicted(self, entry: Entry) -> bool:
        """Whether ``entry`` and the noun before it are a thing and its depiction: "a statue of a
        lion", "a lion statue". The thing is made then."""
        nouns = self.got.found["noun"]
        if len(nouns) != 1 or nouns[0].word == entry.word:
            return False
        before = nouns[0]
        depictions = (
            (*DEPICTIONS, *BUSTS) if is_animal(entry.word) or is_animal(before.word) else DEPICTIONS
        )
        if before.form in depictions and self._accessory is not None and self._ended_by == "of":
            nouns[:] = [entry]
            self._accessory = None
            thing, depiction = entry, before
        elif entry.form in depictions and self._noun_end >= 0:
            thing, depiction = before, entry
        else:
            return False
        self._depict(depiction.form)
        self.got.notes.append(f"{depiction.form}: made as {with_article('noun', thing.word)}.")
        return True

    def _depict(self, form: str) -> bool:
        """Make the thing a statue, a soft toy or similar; whether that states its material."""
        self._depicted = form
        self.got.is_statue = form in (*STATUES, *BUSTS)
        return form in (*STATUES, *PLUSHIES)

    def _depicts_not(self, former: str, noun: str) -> None:
        """Correct the note: the depicted thing is a later noun."""
        said, meant = (
            f"{self._depicted}: made as {with_article('noun', one)}." for one in (former, noun)
        )
        self.got.notes = [meant if note == said else note for note in self.got.notes]

    def _take_block(self, material: Entry, end: int) -> None:
        """Take the stated material of the whole thing, not only of its coat: "a slate blue horse",
        "a copper coloured cat"."""
        behind = next(iter(self._tokens.words[end : end + 1]), "")
        color = look_up(behind, self.known) if end not in self._tokens.breaks else None
        if behind in COLORED or (color is not None and color.slot == "color"):
            return
        said = material.form.split()[0] in ("made", "of", "from")  # "made of ice" is one form
        made_of = said or self._ended_by in ("of", "from", *(["in"] if self._is_shaped() else []))
        if made_of or (self._accessory is None and (self._late or not self.got.found["noun"])):
            self._block = material
        self._made_of |= made_of and bool(self.got.found["noun"])

    def _is_shaped(self) -> bool:
        """Whether it is stated to come from one block."""
        return not set(SHAPED_OF).isdisjoint(self._tokens.words)

    def _set_depicted(self) -> None:
        """Set one material for a statue, stone by default, and for a stone lion. A soft toy is
        small, and of plush."""
        found, thing = self.got.found["material"], self.got.thing
        usual = "stone" if self.got.is_statue else "plush" if self._depicted in PLUSHIES else ""
        of = look_up(usual, self.known)
        if usual and of is not None and not found:
            found.append(of)
            self.got.notes.append(f"No material is named: made of {usual}.")
        person, animal = is_somebody(thing), is_animal(thing)
        toys = [one.form for one in found if one.form in SEWN and (animal or person)]
        toys += [self._depicted] if self._depicted in (*PLUSHIES, *SMALL_FIGURES) else []
        toys += [form for form in self._made_as if form in FOLDED]
        toys += [one.form for one in found if one.form in FOLDED and thing in FOLDABLE]
        if toys and not self.got.is_toy:
            self._take_toy(toys[0])
        block = self._block
        is_mass = block in found and block is not None and block.form in MASSES
        self.got.is_statue |= is_mass and is_creature(thing)
        if animal and "balloon" in self.got.qualifiers:
            self.got.is_statue = True
            if not self.got.found["color"] and "balloon" in self._made_as:
                self.got.found["color"].append(Entry("color", "red", "red"))
        if block not in found or not (animal or person):
            return
        breed = self.got.found["noun"][0].is_narrower
        if animal and breed and block.form in EDIBLE:  # "a chocolate labrador"
            found.remove(block)
            self.got.found["color"].append(Entry("color", "brown", "chocolate brown"))
            return
        shaped = block.word != "fabric" and (self._made_of or self._is_shaped())
        solid = shaped or block.form in MOULDED
        cast = block.word in CAST and block.form not in ALSO_OF_FUR
        self.got.is_statue |= solid or (cast if animal else block.word in CARVED)

    def _take_toy(self, form: str) -> None:
        """Make it as small as a hand can hold."""
        if self._without:
            self.got.leave_aside(["not", form], NOT_GIVEN)
            return
        self.got.is_toy = True
        size, _ = usual(self.got.thing, kind_size=self.got.kind_size())
        if self.got.thing and size <= TOY_SIZE:
            return
        self.got.notes.append(f"{form}: made no longer than {100 * TOY_SIZE:g} cm.")

    def _make_as_qualified(self) -> None:
        """ "A robot dog" is of metal by default."""
        for form in (form for form in AS_MATERIAL if form in self.got.qualifiers):
            of = look_up(AS_MATERIAL[form], self.known)
            if of in self.got.found["material"] and form in ONLY_OF:
                self.got.left_out.remove(form)  # "a molten lava golem"
            if of is not None and not self.got.found["material"] and self._may_be_of(form):
                self.got.left_out.remove(form)
                name = of.form.removeprefix("made ").removeprefix("of ")
                self.got.notes.append(f"{form}: made as {name}.")
                self.got.found["material"].append(of)
                self._made_as.append(form)
                if form not in ROBOTS:
                    self._block = of

    def _leave_its_film(self) -> None:
        """ "An iridescent glass vase" is of glass."""
        found = self.got.found["material"]
        films = [one for one in found if one.form in FILMS]
        for one in films if len(films) < len(found) else ():
            found.remove(one)
            self.got.leave_aside([one.form], "one material is taken")

    def _shade_as_qualified(self) -> None:
        """ "A peach armchair" is peach orange, "a strawberry ice cream" strawberry pink; a lemon
        cake is no yellow one."""
        found, thing = self.got.found, self.got.thing
        tasted = thing == TASTED
        if tasted:
            for one in [one for one in found["material"] if one.form in TASTES]:
                found["material"].remove(one)
                self.got.qualifiers.append(one.form)
        shades = TASTES if tasted else CALLED_SHADES
        grown = any(thing in GROUPS[group] for group in GROWN)
        stated = [form for form in self._tokens.words if form in self.got.qualifiers]
        stated = [form for form in stated if form in shades]
        if not stated or found["color"] or (grown and not tasted):
            return
        self.got.left_out = [form for form in self.got.left_out if form != stated[0]]
        found["color"] += filter(None, [look_up(shades[stated[0]], self.known)])

    def _leave_as_woven(self) -> None:
        """ "A woven basket" is of the usual material of baskets."""
        found, looks = self.got.found, looks_of(self.got.thing)
        mains = [part for part, look in looks.items() if look[0] == "*"]
        if all(natural_kind(self.got.thing, part) == WOVEN for part in mains):
            found["material"] = [one for one in found["material"] if one.form != "woven"]

    def _leave_its_fire(self) -> None:
        """ "A burning candle", "a lit lantern": only its flame or its lamp glows, as always."""
        thing, found = self.got.thing, self.got.found["sheen"]
        kinds = {part: natural_kind(thing, part) for part in looks_of(thing)}
        if any(lights(thing, *one)[0] for one in kinds.items()):
            found[:] = [one for one in found if one.form != LIT]
        if not set(BURNING).isdisjoint(kinds.values()):
            for words in (self.got.left_out, self.got.qualifiers):
                words[:] = [one for one in words if one not in ALIGHT]

    def _may_be_of(self, form: str) -> bool:
        """Whether a word that may be a material is the thing's: "an ice palace", but not an ice
        bucket."""
        if form in OF_ANIMALS:
            return is_animal(self.got.thing)
        if form == "bone" and self.got.thing == "saw":  # which is for bones
            return False
        if form not in ONLY_OF or self.got.is_statue:
            return True
        kinds, things = ONLY_OF[form]
        return self.got.thing in things or any(KINDS[one](self.got.thing) for one in kinds.split())

    def _set_its_gem(self) -> None:
        """ "An emerald ring" has an emerald."""
        colors = self.got.found["color"]
        stones = [one for one in colors if one.form in GEMS]
        if stones and own_name(self.got.thing, "gem"):
            colors.remove(stones[0])
            form = shade(*stones[0][1:])
            self.got.parts.append(StatedPart("gem", True, "gem", stones[0].word, form))

    def _darken_its_stripes(self) -> None:
        """A tabby cat is striped with a darker colour of fur; stripes of no colour are white."""
        found, colors = self.got.found, self.got.found["color"]
        if not any(one.form in TABBY for one in (*found["pattern"], *found["noun"])):
            return
        found["pattern"] = found["pattern"] or [Entry("pattern", "striped", TABBY[0])]
        if len(colors) < 2:
            names = [TABBY_STRIPES.get(one.word, "umber") for one in colors] or ["tan", "umber"]
            colors += filter(None, (look_up(name, self.known) for name in names))

    def _look_like_its_kind(self) -> None:
        """A crow is black, made as a bird that is blue, unless a colour is stated; a tuxedo is of
        cloth, made as a jacket that is of leather, unless a material is."""
        found = self.got.found
        if not found["noun"] or self.got.is_statue:
            return
        is_plain = not found["color"] and not found["pattern"]
        whole, parts = look_of_kind(found["noun"][0].form)
        known = [look_up(phrase, self.known) for phrase in whole]
        for entry in (one for one in known if one is not None):
            is_open = not found["material"] if entry.slot == "material" else is_plain
            if is_open:
                found[entry.slot].append(entry)
                self.got.is_statue |= entry.form in MASSES  # a gummy bear
        for part, name in parts.items() if is_plain else ():
            color = look_up(name, self.known)
            if color is not None and part in looks_of(self.got.thing):
                form = shade(*color[1:])
                self.got.parts.append(StatedPart(part, True, part, color.word, form))

    def _spare_the_living(self) -> None:
        """ "An old wizard" does not look worn; an old doll, a stone lion and the statue of a king
        do."""
        thing = self.got.thing
        alive = is_animal(thing) or is_somebody(thing)
        if not alive or self.got.found["material"] or self._depicted:
            return
        weather = self.got.found["weather"]
        for one in [one for one in weather if one.form in AGES]:
            weather.remove(one)
            self.got.leave_aside([one.form], "living things are not worn")
