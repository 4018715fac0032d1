"""Placements of the things of a composition."""

from collections.abc import Callable, Sequence
from dataclasses import replace

import torch

from core.guidance.builtin.composition.placing.attaching import SPREAD, at_front, behind, in_coils
from core.guidance.builtin.composition.placing.bunches import bunched
from core.guidance.builtin.composition.placing.copies import copies_of, mixed_heap
from core.guidance.builtin.composition.placing.holding import held
from core.guidance.builtin.composition.placing.placement import (
    Body,
    Placement,
    joined,
)
from core.guidance.builtin.composition.placing.resting import (
    POINT_DOWN,
    beside,
    is_heap,
    is_stuck,
    lying_on,
    under,
    upon,
    within,
)
from core.guidance.builtin.composition.placing.sheltering import sheltered
from core.guidance.builtin.composition.placing.wearing import worn
from core.guidance.builtin.stretch import training_size
from core.guidance.builtin.words.companions.known_as import CONTAINERS, EDIBLE, FITTED, FLOWERS
from core.guidance.builtin.words.companions.search import Relation

EACH = ("wears", "holds", "fills")  # relations of each copy by itself
APART = (*SPREAD, "below")  # of each companion by itself


def arranged(first: Body, others: Sequence[tuple[Relation, Body]]) -> list[list[Placement]]:
    """The placements of each copy of the first thing, and of each copy of the others, all at the
    training's size."""
    count = first.words.count
    if count > 1 and any(how == "in" for how, _ in others):  # eggs in a basket are a heap
        first = replace(first, words=replace(first.words, order="heap"))
    things = [first, *(other for _, other in others)]
    flowers = _in_bunch(first, others)
    each = len(flowers) < 2 and all(
        how in EACH or (other.words.count == count and how not in APART) for how, other in others
    )
    if count > 1 and others and each:  # "two penguins wearing hats": a penguin and a hat, twice
        places = _placed(first, others)
        pairs = zip(things, places, strict=True)
        copies = copies_of(joined([thing.placed(place) for thing, place in pairs]))
        found = [[copy.of_copy(place) for copy in copies] for place in places]
    else:
        copies = [copies_of(thing) for thing in things]
        whole = first.group(copies[0])
        below = whole  # and what is under it
        for k, (how, other) in enumerate(others, 1):
            if how == "below":
                copies[k] = sheltered(other, whole, below, other.words.count)
                below = joined([below, other.group(copies[k])])
            elif how in SPREAD:
                copies[k] = SPREAD[how](other, whole, other.words.count)
        groups = [thing.group(own) for thing, own in zip(things, copies, strict=True)]
        mixed = _mixed(first, others)
        if len(mixed) > 1 or len(flowers) > 1:  # "a bowl of apples and bananas"
            piling, mixed = (bunched, flowers) if len(flowers) > 1 else (mixed_heap, mixed)
            piled = piling([things[k] for k in mixed])
            whole = joined([things[k].group(own) for k, own in zip(mixed, piled, strict=True)])
            whole = replace(whole, words=replace(whole.words, count=sum(map(len, piled))))
            for k, own in zip(mixed, piled, strict=True):
                copies[k], groups[k] = own, whole
        pairs = [(how, group) for (how, _), group in zip(others, groups[1:], strict=True)]
        places = _placed(groups[0], pairs)
        found = [[at.of_copy(one) for one in own] for at, own in zip(places, copies, strict=True)]
    bodies = zip(things, found, strict=True)
    verts = torch.cat([place.out(thing.verts) for thing, own in bodies for place in own])
    fit = training_size(verts)
    return [[place.then(*fit) for place in own] for own in found]


def _mixed(first: Body, others: Sequence[tuple[Relation, Body]]) -> list[int]:
    """Indices of the things that fill the first one together."""
    return [
        k
        for k, (how, other) in enumerate(others, 1)
        if how == "bears"
        and first.words.noun in CONTAINERS
        and (is_heap(other) or other.words.noun in EDIBLE)
    ]


def _in_bunch(first: Body, others: Sequence[tuple[Relation, Body]]) -> list[int]:
    """Indices of the flowers that are in one bunch: "a vase with roses and tulips"."""
    own = [0] if first.words.noun in FLOWERS else []
    return own + [
        k
        for k, (how, other) in enumerate(others, 1)
        if how == "bears" and other.words.noun in FLOWERS
    ]


def _placed(first: Body, others: Sequence[tuple[Relation, Body]]) -> list[Placement]:
    """The placement of each thing; the first one's is its own."""
    stuck = any(how == "in" and is_stuck(first, other) for how, other in others)
    below = next((other for how, other in others if how == "on"), None)
    laid = lying_on(first, below) if below else None
    found = [Placement.of(1.0, POINT_DOWN if stuck else laid)]
    there = first.placed(found[0])
    row = [there]  # things next to each other
    held_already = False
    # Things that fill it together count as one; the tallest first, which are at the back.
    borne = list({id(other): other for how, other in others if how == "bears"}.values())
    borne.sort(key=lambda other: -other.metres * float(other.sides[2]))
    for how, other in others:
        if other is first:  # in the bunch with it
            found.append(found[0])
        elif how == "holds":
            place = held(other, there.standing or there, held_already)
            found.append(_carried(place, there))
            held_already = True
        elif how == "wears" and other.words.noun not in FITTED:
            wearer = there.standing if there.standing and there.carried else there
            found.append(_carried(worn(other, wearer), there))
        elif how in APART:  # each of them by itself
            found.append(Placement.of())
        elif how in ("on", "in") and first.rests is not None:
            found.append(first.rests)
        elif how == "fills" and other.rests is not None:
            found.append(other.rests)
        elif how == "bears" and len(borne) > 1:  # "a skull and a candle on top"
            place = next(k for k, one in enumerate(borne) if one is other)
            found.append(upon(other, there.cell(place, len(borne)), len(borne)))
        elif how == "beside":  # on the right, on the left, and so on
            found.append(beside(other, there, joined(row), on_left=len(row) % 2 == 0))
            row.append(other.placed(found[-1]))
        else:
            found.append(_PLACED[how](other, there))
    return found


def _carried(place: Placement, wearer: Body) -> Placement:
    """A place at who stands, where it is now."""
    return place if wearer.carried is None else wearer.carried.of_copy(place)


_PLACED: dict[Relation, Callable[[Body, Body], Placement]] = {
    "on": lambda other, first: under(first, other),
    "in": lambda other, first: within(first, other),
    "wears": worn,
    "bears": upon,
    "behind": behind,
    "front": at_front,
    "around": in_coils,
}
