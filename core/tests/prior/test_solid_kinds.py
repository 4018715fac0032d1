"""The kinds of a noun's solids: by what families choose, by volumes, in a network's order."""

from collections.abc import Iterator
from dataclasses import replace
from unittest import mock

import pytest
import torch
from safetensors.torch import save_file

from core.guidance.builtin.solid_net import KINDS, PARTS, SolidNet, SolidNetConfig
from core.prior import solid_kinds
from core.prior.solid_data import SIDE, SOLIDS, Solids
from core.prior.solid_kinds import Kinds, drawn_kinds, in_order_of, kind_rows, kinds_of

FEW = 3  # nouns, the first ones


@pytest.fixture(scope="module", autouse=True)
def few_nouns() -> Iterator[None]:
    """The tables of all are large."""
    with mock.patch.object(solid_kinds, "NOUNS", solid_kinds.NOUNS[:FEW]):
        yield


def test_kinds_follow_what_a_family_chooses(tmp_path, monkeypatch):
    """Two sorts that differ little, of sizes that differ much."""
    monkeypatch.setattr(solid_kinds, "KINDS", 2)
    size = torch.arange(24) % 8  # cells, of a column
    sort = torch.arange(24) // 12
    grid = torch.full((24, SIDE, SIDE, SIDE), 127, dtype=torch.int8)
    for column, cells, marked in zip(grid, size, sort, strict=True):
        column[:4, :4, : 8 + 2 * cells] = -127
        column[20:24, 20:22, :8] = -127 if marked else 127
    words = torch.zeros(24, 3, dtype=torch.int16)
    nothing = torch.zeros(24, 1, 3, dtype=torch.int16), torch.zeros(24, 1, PARTS).half()
    solids = Solids(grid, *nothing, words, sort + 7)
    save_file(vars(solids), tmp_path / SOLIDS.replace("*", "00000"))
    rows = kind_rows(solids, kinds_of(tmp_path))
    assert [len(rows[sort == one].unique()) for one in (0, 1)] == [1, 1]
    assert len(rows.unique()) == 2


@pytest.mark.parametrize(
    ("sorts", "kinds"),
    [
        ((8, 8, 8), [1, 1, 2]),  # the fourth kind is of the first of the largest
        ((20, 4), [1, 3]),
        ((6, 6, 6, 6), [1, 1, 1, 1]),
    ],
)
def test_what_a_family_chooses_makes_kinds_where_the_volumes_are_alike(tmp_path, sorts, kinds):
    """As of a cube's stickers, whose colours are parts."""
    grid = torch.randint(
        -127, 127, (24, SIDE, SIDE, SIDE), generator=torch.Generator().manual_seed(0)
    ).to(torch.int8)
    choice = torch.arange(len(sorts)).repeat_interleave(torch.tensor(sorts))
    nothing = torch.zeros(24, 1, 3, dtype=torch.int16), torch.zeros(24, 1, PARTS).half()
    solids = Solids(grid, *nothing, torch.zeros(24, 3, dtype=torch.int16), choice + 7)
    save_file(vars(solids), tmp_path / SOLIDS.replace("*", "00000"))
    found = kinds_of(tmp_path)
    rows = kind_rows(solids, found)
    of_sorts = [set(rows[choice == one].tolist()) for one in range(len(sorts))]
    assert sorted(map(len, of_sorts)) == kinds
    assert len(set.union(*of_sorts)) == sum(map(len, of_sorts)), "no kind is of two sorts"
    # Sorts that the kinds were found without get the nearest.
    unseen = replace(solids, choices=choice + 99)
    assert (kind_rows(unseen, found) > 0).all()


def test_kinds_go_on_in_the_order_of_a_network_that_has_learnt_them():
    torch.manual_seed(0)
    config = SolidNetConfig(
        (FEW, 1, 1, KINDS * FEW), latent=4, embedding=16, widths=(16, 16, 8, 8), hidden=16
    )
    net = SolidNet(config)
    torch.nn.init.normal_(net.kind.weight)
    net.mirrored[::2, 0] = True
    mixed = torch.tensor([2, 0, 3, 1])
    middles = torch.stack([drawn_kinds(net, noun) for noun in range(FEW)])
    middles += 0.01 * torch.randn(middles.shape)
    choices = torch.arange(FEW * KINDS).view(FEW, KINDS)
    kinds = Kinds(middles[:, mixed], choices[:, mixed])
    found = in_order_of(net, kinds, torch.tensor([0, 2]))
    assert torch.equal(found.choices[[0, 2]], choices[[0, 2]])
    assert torch.equal(found.middles[2], middles[2])
    assert torch.equal(found.choices[1], choices[1, mixed]), "nobody asked for this noun"
