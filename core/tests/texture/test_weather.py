"""Wear, dirt, dust, moss and snow over any material."""

import numpy as np
import pytest
import torch

from core.geometry.mesh import Mesh
from core.guidance.builtin.palette import painted
from core.guidance.builtin.surfaces import surface_of, surfaces_of
from core.guidance.builtin.words.tables.words import WEATHERS as WORDS
from core.guidance.builtin.words.vocabulary import parse
from core.guidance.guidance import Surface
from core.texture.detail.detail import Coat, Detail, Spots
from core.texture.detail.grain import convexity
from core.texture.detail.noise import Noise
from core.texture.detail.parts import ByColor
from core.texture.detail.place import Layer, Place
from core.texture.detail.weather import WEATHERS, covering, laid

NOISE = Noise(3, 0.001)


def somewhere(up: float, edge: float = 0.0, count: int = 4000) -> Place:
    """Points all over a unit cube, of a surface whose normal's z is ``up``."""
    points = np.random.default_rng(0).random((count, 3), np.float32)
    normal = np.tile(np.array([(1 - up * up) ** 0.5, 0, up], np.float32), (count, 1))
    edges = np.full(count, edge, np.float32)
    return Place(points, normal, np.zeros(count, np.int64), NOISE, edges)


def cover(name: str, up: float, edge: float = 0.0) -> float:
    return float(WEATHERS[name](somewhere(up, edge)).cover.mean())


def test_the_words_are_those_that_there_is_a_look_of():
    assert WORDS.keys() == WEATHERS.keys()


@pytest.mark.parametrize(("name", "least"), [("mossy", 0.3), ("snowy", 0.8), ("dusty", 0.3)])
def test_what_falls_or_grows_is_on_what_looks_up(name, least):
    above, side, below = (cover(name, up) for up in (1.0, 0.0, -1.0))
    assert above - side > least and side - below >= -1e-6


def test_dirt_and_moss_gather_in_corners_and_edges_are_rubbed():
    for name in ("dirty", "mossy"):
        assert cover(name, 0.0, -0.4) > cover(name, 0.0) + 0.15
    tone = [WEATHERS["worn"](somewhere(0.0, edge)).ratio.mean() for edge in (0.0, 0.4)]
    assert tone[1] > 1.2 * tone[0]
    assert WEATHERS["worn"](somewhere(0.0)).cover.max() == 0


def test_what_burnt_is_black_but_for_spared_places_and_ash():
    burnt = WEATHERS["charred"](somewhere(0.0))
    black = burnt.over.max(1) < 0.03
    assert black.mean() > 0.5 and burnt.over.max() < 0.12
    assert (burnt.cover > 0.95).mean() > 0.5 and 0.02 < (burnt.cover < 0.8).mean() < 0.4


def test_what_covers_hides_the_material_and_is_no_part_of_its_mean():
    place = somewhere(1.0, count=2)
    base = Layer.of(np.zeros(2, np.float32), (1.0, 1.0, 1.0), metallic=np.float32([0.2, 0.2]))
    base = base._replace(over=np.float32([[0.1] * 3] * 2), cover=np.float32([0.5, 0.5]))
    top = covering(np.float32([1.0, 0.0]), (0.3, 0.6, 0.9), 0.4, np.float32([0.01, 0.0]))
    both = laid(top, base)
    np.testing.assert_allclose(both.cover, [1.0, 0.5])
    np.testing.assert_allclose(both.over, [[0.3, 0.6, 0.9], [0.1, 0.1, 0.1]], rtol=1e-5)
    np.testing.assert_allclose(both.metallic, [-1.0, 0.2], rtol=1e-5)  # moss on steel is no metal
    np.testing.assert_allclose(both.roughness, [0.4, 0.0])
    np.testing.assert_allclose(both.apart, [1.0, 0.0])
    assert len(place.point) == 2


def test_an_edge_stands_out_a_corner_is_hollow_and_a_plane_is_neither():
    import trimesh

    box = trimesh.creation.box((1.0, 1.0, 1.0))
    for _ in range(4):
        box = box.subdivide()
    verts, faces = torch.tensor(box.vertices).float(), torch.tensor(box.faces)
    height = convexity(verts, faces)[:, 0]
    on_edge = (verts.abs() > 0.499).sum(1) >= 2
    assert height[on_edge].min() > 0.15 and height[~on_edge].abs().max() < 1e-4
    # Of a cube of twelve triangles the faces would be all edge.
    few = trimesh.creation.box((1.0, 1.0, 1.0))
    assert convexity(torch.tensor(few.vertices).float(), torch.tensor(few.faces)).max() < 0.1
    inside_out = convexity(verts, faces.flip(1))[:, 0]
    assert inside_out[on_edge].max() < -0.15


def test_words_of_age_are_seen_and_what_lives_is_not_worn():
    words = parse("a worn and dusty leather armchair")
    assert words.weather == ("worn", "dusty") and not words.notes
    assert {surface.weather for surface in surfaces_of(words)} == {("worn", "dusty")}
    assert parse("an old wooden chair").weather == ("worn",)
    assert parse("a moss covered stone well").weather == ("mossy",)
    assert parse("a burnt down house").weather == ("charred",)
    assert parse("a charred, snow covered log").weather == ("charred", "snowy")
    assert parse("a burnt orange car").weather == ()
    person = parse("a shabby muddy man")
    kinds = {part.name: surface_of(person, part) for part in painted("person", person)}
    assert kinds["skin"].weather == ("dirty",) and kinds["eyes"].weather == ()
    assert kinds["shirt"].weather == ("worn", "dirty")


def test_the_mesh_of_a_torus_has_no_edges():
    from core.tests.texture_shapes import torus

    mesh = Mesh(*torus(96, 48))
    assert convexity(mesh.verts, mesh.faces).abs().max() < 0.12


@pytest.mark.parametrize("name", WEATHERS)
def test_a_place_is_the_same_whatever_it_is_looked_at_with(name):
    """Texels come in chunks, and both sides of a seam in others."""
    place = somewhere(0.5, 0.1)
    few = Place(
        *(x[1000:1100] for x in (place.point, place.normal, place.along)),
        NOISE,
        place.edge[1000:1100],
    )
    whole, part = WEATHERS[name](place), WEATHERS[name](few)
    for of_all, of_few in zip(whole, part, strict=True):
        np.testing.assert_allclose(of_all[1000:1100], of_few, atol=1e-6)


@pytest.mark.parametrize(
    ("name", "dark"), [("snowy", 0.02), ("snowy", 0.2), ("mossy", 0.8), ("dirty", 0.8)]
)
def test_what_the_weather_leaves_bare_keeps_its_colour(name, dark):
    points = torch.from_numpy(somewhere(0.0).point)
    normal = torch.nn.functional.normalize(points - 0.5, dim=1)
    zero, one = torch.zeros(len(points), 1), torch.ones(len(points), 1)
    spots = Spots(points, normal, torch.ones_like(points), zero)
    coat = Coat(dark * torch.ones(len(points), 3), 0.3 * one, zero)
    paint = Surface("paint", (0.5, 0.5, 0.5))
    gains = [
        Detail.of(ByColor.of((surface,), coat.kd), NOISE, 1.0, spots, coat).gains
        for surface in (paint, paint._replace(weather=(name,)))
    ]
    torch.testing.assert_close(*gains)
    new, old = (
        Detail.of(ByColor.of((surface,), coat.kd), NOISE, 1.0, spots, coat)(spots, coat)[0]
        for surface in (paint, paint._replace(weather=(name,)))
    )
    assert (new.kd - old.kd).abs().max() > 0.1  # it is seen


def test_no_snow_is_on_flames():
    words = parse("a snow covered campfire")
    found = {part.name: surface_of(words, part) for part in painted("campfire", words)}
    assert found["flame"].weather == () and found["logs"].weather == ("snowy",)
