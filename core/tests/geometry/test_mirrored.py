"""Components that mirror each other get the same surface."""

import pytest
import torch

from core.geometry.mesh import health
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.components import Place, drawn_at, drawn_in, places_of
from core.geometry.parts.forms import Forms
from core.geometry.parts.mirrored import Mirror, mirrored_mesh, mirrored_pairs

FLAT = Forms((1.0,), ((0.0,), (0.0,), (0.0,)))


def box(points, center, half):
    q = (points - torch.tensor(center)).abs() - torch.tensor(half)
    return q.clamp_min(0).norm(dim=1) + q.amax(1).clamp_max(0)


def blocks(*centers, waves=0.004):
    """Blocks of one size with ripples, the same on both sides of x = 0."""

    def distances(points):
        each = [box(points, center, (0.2, 0.15, 0.1)) for center in centers]
        x, y, z = points.unbind(1)
        ripples = waves * ((19 * x.abs()).sin() + (23 * y).sin() + (29 * z).sin())
        return torch.stack([torch.stack(each).amin(0) + ripples], 1)

    return distances


def drawn(distances):
    return [drawn_at(distances, place) for place in places_of(distances, 1)]


def test_the_left_mirrors_the_right_and_nothing_else():
    pairs = blocks((0.4, 0, 0.3), (-0.4, 0, 0.3), (0.0, 0.1, -0.5))
    components = drawn(pairs)
    assert len(components) == 3
    found = mirrored_pairs(pairs, components)
    ((later, mirror),) = found.items()
    assert mirror.axis == 0
    sides = [components[k].verts[:, 0].mean() for k in (later, mirror.of)]
    assert sides[0] == pytest.approx(-float(sides[1]), abs=0.01)
    uneven = blocks((0.4, 0, 0.3), (-0.4, 0, 0.2))  # not as high
    assert mirrored_pairs(uneven, drawn(uneven)) == {}


def test_what_only_has_the_size_of_its_like_is_not_mirrored():
    """A ball in a box's box."""
    both = blocks((0.4, 0, 0.3), (-0.4, 0, 0.3), waves=0.0)

    def distances(points):
        ball = (points - torch.tensor([-0.4, 0.0, 0.3])) / torch.tensor([0.2, 0.15, 0.1])
        ball = (ball.norm(dim=1) - 1) * 0.1
        block = blocks((0.4, 0, 0.3), waves=0.0)(points)[:, 0]
        return torch.stack([torch.minimum(block, ball)], 1)

    components = drawn(distances)
    assert len(components) == 2
    assert mirrored_pairs(both, drawn(both)) == {1: Mirror(0, 0)}
    assert mirrored_pairs(distances, components) == {}


def test_a_twin_is_its_others_mirror_to_the_last_bit():
    plain = blocks((0.4, 0, 0.3), (-0.4, 0, 0.3))

    def knobbed(points):  # no simple solid
        folded = points.clone()
        folded[:, 0] = folded[:, 0].abs()
        knob = (folded - torch.tensor([0.5, 0.05, 0.42])).norm(dim=1) - 0.12
        return torch.minimum(plain(points), knob[:, None])

    parts = KnownParts(knobbed, FLAT)
    assert parts.components[1].primitive is None, "it is the first one's"
    (one, faces), (other, turned) = (parts.surface_of(k) for k in range(2))
    assert torch.equal(other, one * torch.tensor([-1.0, 1.0, 1.0]))
    assert torch.equal(turned, faces.flip(1))
    whole = health(*mirrored_mesh((one, faces), 1))
    assert whole["closed"] and whole["oriented"] and whole["volume"] > 0
    points = torch.randn(50, 3, generator=torch.Generator().manual_seed(0)) * 0.05
    points = points + torch.tensor([0.4, 0.0, 0.4])
    there = points * torch.tensor([-1.0, 1.0, 1.0])
    torch.testing.assert_close(parts.near(points), parts.near(there), atol=1e-6, rtol=0)


def test_a_component_on_both_sides_has_none():
    across = blocks((0.05, 0, 0), waves=0.0)
    assert mirrored_pairs(across, [*drawn(across), *drawn(across)]) == {}


def bridged(thick: float, apart: float):
    """Two blocks, a bridge of so thick between them."""

    def distances(points):
        ends = [
            box(points, (side * (0.25 + apart / 2), 0, 0), (0.25, 0.3, 0.2)) for side in (1, -1)
        ]
        bridge = box(points, (0.0, 0.0, 0.0), (0.2 + apart, 0.25, thick / 2))
        return torch.stack([torch.stack([*ends, bridge]).amin(0)], 1)

    return distances


@pytest.mark.parametrize(
    ("thick", "apart", "count"),
    [(0.016, 0.06, 2), (0.1, 0.06, 1), (0.016, 0.5, 1)],
    ids=["thinner than the errors", "a neck", "a sheet"],
)
def test_a_thin_bridge_parts_two_components(thick, apart, count):
    distances = bridged(thick, apart)
    whole = Place(0, *(torch.full((3,), end).double().numpy() for end in (-0.9, 0.9)), nowhere)
    assert len(list(drawn_in(distances, whole))) == count


def nowhere(points):
    return torch.zeros(len(points), dtype=torch.bool)
