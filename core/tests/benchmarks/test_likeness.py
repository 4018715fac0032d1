"""The measures that see what retrieval does not: rounded edges, missing parts, melted legs."""

from collections.abc import Iterator
from dataclasses import replace
from unittest import mock

import numpy as np
import pytest
import torch

from core.benchmarks import likeness as measures
from core.benchmarks.likeness import Surface, likeness
from core.geometry.marching_tets import marching_tets
from core.geometry.tet_grid import tet_grid
from core.prior.draw import Draw
from core.prior.families import Shape, build

GRID = tet_grid(56)


def fresh(noun: str) -> Shape:
    return build(noun, "", Draw(torch.Generator().manual_seed(11)), jitter=0.0)


def meshed(shape: Shape) -> Surface:
    sdf = torch.cat([shape.sdf(part) for part in GRID.tet_verts.split(1 << 16)])
    return Surface.of_mesh(*marching_tets(GRID.tet_verts, sdf, GRID))


@pytest.fixture(scope="module", autouse=True)
def fewer() -> Iterator[None]:
    """Three held-out objects of a noun, and half of the points."""
    with (
        mock.patch.object(measures, "REFERENCES", 3),
        mock.patch.object(measures, "POINTS", 4000),
    ):
        measures.objects.cache_clear()
        yield
        measures.objects.cache_clear()


@pytest.fixture(scope="module")
def car() -> Shape:
    return fresh("car")


def test_the_bend_is_the_ninth_in_ten_of_the_angles_to_the_normals_within_reach():
    dice = np.random.default_rng(0)
    points, normals = 0.3 * dice.random((600, 3)), dice.normal(size=(600, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    found = Surface(points, normals, np.zeros(1, int)).bends
    for point, normal, bend in zip(points, normals, found, strict=True):
        near = np.linalg.norm(points - point, axis=1) < measures.REACH  # itself too
        cosine = np.quantile(normals[near] @ normal, 0.1)
        assert np.degrees(np.arccos(cosine)) == pytest.approx(bend, abs=1e-5)


def test_another_object_of_the_noun_is_like_it(car):
    found = likeness(Surface.of_solid(car), "car")
    assert found["crease"] == pytest.approx(1, abs=0.1)
    assert found["flat"] == pytest.approx(1, abs=0.15)
    assert found["missing"] <= found["usual_missing"] + 0.03
    assert found["pieces"] == 1


def test_a_swollen_car_has_round_edges(car):
    # Moving a surface outwards rounds its edges, as melting does.
    sharp = likeness(meshed(car), "car")
    round_ = likeness(meshed(replace(car, swell=0.12)), "car")
    assert round_["crease"] < 0.85 * sharp["crease"]


def test_a_race_car_without_wheels_lacks_them_and_has_other_slices():
    """Its wheels are in the open, and not in wells."""
    car = fresh("race car")
    parts = {name: solid for name, solid in car.parts.items() if name not in ("wheels", "hubs")}
    found = likeness(Surface.of_solid(replace(car, parts=parts)), "race car")
    assert found["missing"] > found["usual_missing"] + 0.05
    assert found["pieces"] < 0.85


def test_it_does_not_matter_how_a_thing_is_turned():
    surface = Surface.of_solid(fresh("chair"))
    a = torch.tensor(2.0)
    turn = torch.tensor([[a.cos(), -a.sin(), 0], [a.sin(), a.cos(), 0], [0, 0, 1]]).numpy()
    turned = replace(surface, points=surface.points @ turn.T, normals=surface.normals @ turn.T)
    one, other = likeness(surface, "chair"), likeness(turned, "chair")
    assert other["crease"] == pytest.approx(one["crease"], abs=0.01)
    # Turns are tried in steps of 5 degrees.
    assert other["missing"] == pytest.approx(one["missing"], abs=0.03)
