"""Things in closed glass: the vessels, the place of what is in them, and their words."""

from functools import cache

import numpy as np
import pytest
import torch

from core.geometry.mesh import drop_floaters, health, signed_volume
from core.geometry.parts.assembly import assembled
from core.geometry.parts.primitives import Primitive
from core.geometry.union import room_within, union
from core.guidance.builtin.composition.glass.enclosing import enclosed, inside_of
from core.guidance.builtin.composition.glass.vessel import Vessel, vessel_of
from core.guidance.builtin.composition.glass.vessels import shape_for
from core.guidance.builtin.composition.placing.placement import Body
from core.guidance.builtin.palette import painted
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.surfaces import surface_of
from core.guidance.builtin.words.companions.glassware import CLEAR, VESSELS, glazed
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.colors import color_value
from core.guidance.builtin.words.vocabulary import parse, understood
from core.tests.drawn_things import box, shipped_prior


@cache
def undrawn():
    net = shipped_prior().solid
    with torch.no_grad():
        row = torch.tensor([[*parse("a jar").indices(("noun", "shape", "part")), 1]])
        return Solid(net, net.triplane(row, torch.zeros(1, net.config.latent)))


def in_glass(vessel, *bodies):
    """The things, and their placements, of bodies that a vessel has in it."""
    each = [box([-1.0] * 3, [1.0] * 3, vessel), *bodies]
    prior = shipped_prior()
    things = [prior.prompted(f"a {one.words.noun}", "") for one in each]
    things[0] = things[0].with_solid(undrawn())
    relations = ["bears"] * len(bodies)
    inside = inside_of(each, relations)
    assert inside and inside.vessel == 0 and len(inside.contents) == len(bodies)
    things, each, places = enclosed(things, each, relations, inside)
    solid = things[0].solid
    assert isinstance(solid, Vessel)
    return solid, each, places


def outside_room(solid, points, place):
    return place.scale * solid.shape.free(place.into(points))


def test_a_turned_room_is_inside_by_the_wall():
    profile = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0)])
    room = room_within(profile, 0.1)
    assert room.min(0) == pytest.approx([0.0, 0.1]) and room.max(0) == pytest.approx([0.9, 1.9])


@pytest.mark.parametrize(
    "noun", ["jar", "bottle on its side", "snow globe", "light bulb", "aquarium"]
)
def test_the_glass_of_a_vessel_is_a_wall_around_a_room(noun):
    name = noun.split(" on")[0]
    shape = shape_for(name, 1.0, noun != name)
    assert shape.glass == VESSELS[name][0] and shape.glass in shape.parts
    vessel = vessel_of(Words(noun=name), undrawn(), shape)
    of = vessel.names.index(vessel.shape.glass)
    glass = next(one for one in vessel.known.components if one.place.part == of)
    report = health(glass.verts, glass.faces)
    assert report["closed"] and report["manifold"] and report["components"] == 2
    outer = signed_volume(*vessel.shape.parts[vessel.shape.glass][0].mesh(0.05))
    room = signed_volume(*vessel.shape.room.mesh(0.05))
    assert report["volume"] == pytest.approx(outer - room, rel=1e-4) and 0 < room < 0.95 * outer
    middle = torch.tensor([[*vessel.shape.middle, 0.0]])
    middle[0, 2] = vessel.shape.room.mesh(0.1)[0][:, 2].mean()
    assert vessel.shape.free(middle) < 0 < vessel.distances(middle)[0, of]


@pytest.mark.parametrize(
    ("vessel", "sides"),
    [("jar", (0.4, 0.4, 0.9)), ("snow globe", (0.9, 0.5, 0.3)), ("glass dome", (0.4, 0.4, 0.9))],
)
def test_what_stands_in_a_vessel_is_whole_and_touches_its_floor(vessel, sides):
    half = torch.tensor(sides)
    solid, each, places = in_glass(vessel, box((-half).tolist(), half.tolist()))
    (place,), (there,) = places
    away = outside_room(solid, there.out(each[1].verts), place)
    assert 0 < float(away.max()) < 0.03, "in the wall a little, and not through it"
    assert float((away > 0).float().mean()) <= 0.5


def test_what_floats_touches_nothing_and_stays_a_component():
    solid, each, places = in_glass("jar", box([-1.0] * 3, [1.0] * 3, "brain"))
    assert float(outside_room(solid, places[1][0].out(each[1].verts), places[0][0]).max()) < 0

    class Parts(type(solid.known)):
        components = property(lambda self: [*solid.known.components, None])
        enclosed = property(lambda self: [[len(solid.known.components)]])

        def surface_of(self, index, exact=True):
            if index < len(solid.known.components):
                return solid.known.surface_of(index)
            return places[0][0].into(places[1][0].out(each[1].verts)), each[1].faces

    made = assembled(Parts(solid), True, 0.05, lambda _: None)
    report = health(*made)
    assert report["closed"] and report["manifold"] and report["components"] == 3
    closed_in = union([solid.known.surface_of(0)], 0.0)
    assert health(*drop_floaters(*closed_in, 0.05))["components"] == 1
    assert health(*drop_floaters(*closed_in, 0.05, rooms=True))["components"] == 2


def test_a_heap_fills_the_bottom_of_a_jar_without_leaving_it():
    verts, faces = Primitive("box", *np.zeros((2, 3)), np.array([0.5, 0.4, 0.1, 0])).mesh(0.06)
    words, part = Words(noun="cookie", count=9, order="heap"), torch.zeros(len(verts)).long()
    piece = Body(words, verts, faces, part)
    solid, each, places = in_glass("jar", piece)
    assert len(places[1]) == 9
    verts = torch.cat([one.out(each[1].verts) for one in places[1]])
    assert float(outside_room(solid, verts, places[0][0]).max()) < 0.01
    middles = torch.stack([one.out(torch.zeros(1, 3))[0] for one in places[1]])
    apart = torch.cdist(middles, middles) + 9 * torch.eye(9)
    assert float(apart.min()) > 0.15 * places[1][0].scale, "none is in another"


def test_a_ships_bottle_is_on_its_side():
    ship = box([-0.9, -0.3, -0.6], [0.9, 0.3, 0.6], "pirate ship")
    solid, _, _ = in_glass("bottle", ship)
    verts = solid.known.surface_of(0)[0]
    wide, _, high = (verts.amax(0) - verts.amin(0)).tolist()
    assert wide > 1.5 * high


@pytest.mark.parametrize(
    ("prompt", "read"),
    [
        ("a ship in a bottle", "pirate ship in bottle"),
        ("a brain floating in a jar", "brain in jar"),
        ("a ghost trapped in a bottle", "ghost in bottle"),
        ("a message in a bottle", "scroll in bottle"),
        ("a rose under a glass dome", "rose in glass dome"),
        ("a fairy inside of a green jar", "fairy in jar"),
        ("a tiny house in a light bulb", "house in light bulb"),
        ("a snow globe with a castle inside", "snow globe bears castle"),
        ("a potion with an eye floating in it", "potion bears eyeball"),
        ("a jar of cookies", "jar bears cookie"),
        ("a jar of jelly beans", "jar bears egg"),
        ("a cat in a barrel", "cat in barrel"),
    ],
)
def test_what_is_in_glass_is_read(prompt, read):
    words = parse(prompt)
    (one,) = words.companions
    assert f"{words.noun} {one.relation} {one.words.noun}" == read and not words.left_out


@pytest.mark.parametrize(
    "prompt", ["a bottle of apple juice", "a jar of honey", "a bottle with stars", "a snow globe"]
)
def test_a_drink_or_a_print_is_no_content(prompt):
    assert parse(prompt).companions == ()


def test_several_fill_a_vessel_by_what_they_do():
    flies, cookies = parse("fireflies in a jar"), parse("a jar of cookies").companions[0].words
    plants = parse("a terrarium with succulents").companions[0].words
    assert (flies.count, flies.order) == (6, "heap") and (cookies.count, cookies.order) == (
        12,
        "heap",
    )
    assert (plants.count, plants.order) == (3, "row")
    assert parse("two eyeballs in a jar").count == 2


def test_a_vessel_is_as_large_as_ever_whatever_is_in_it():
    assert understood("a ship in a bottle")["size_m"] == understood("a bottle")["size_m"]
    assert understood("a castle")["size_m"] > 10


@pytest.mark.parametrize(("prompt", "green"), [("a jar", False), ("a green jar", True)])
def test_glass_around_something_is_clear_and_keeps_a_stated_colour(prompt, green):
    words = glazed(parse(prompt), ["bears"], False)
    assert glazed(parse(prompt), ["on"], False) == parse(prompt)
    (body,) = (part for part in painted("jar", words) if part.name == "body")
    surface = surface_of(words, body)
    assert body.material_form == CLEAR and surface.clear == 1.0 and surface.glow == 0
    assert surface.factor == (1.0, 1.0, 1.0) or not green
    stated = color_value("green")
    assert (stated[2] + 0.2 < body.color[2] < body.color[1] - 0.1) == green, "pale green"
    assert "label" in words.absent
