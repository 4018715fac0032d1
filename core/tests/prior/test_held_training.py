"""Trainings in which nothing learns but the data's nouns."""

from collections.abc import Iterator
from functools import partial

import pytest
import torch
from torch import nn

from core.errors import UserError
from core.guidance.builtin.network import UNet, UNetConfig
from core.guidance.builtin.solid import save_solid_net
from core.guidance.builtin.solid_net import KINDS, SolidNet, SolidNetConfig
from core.prior import solid_training
from core.prior.data import ADJECTIVES, NOUNS, PART_STATES, write_shard
from core.prior.learnt_rows import LearntRows
from core.prior.solid_data import write_solids
from core.prior.solid_kinds import Kinds, kind_rows, kinds_of
from core.prior.solid_training import Autoencoder, SolidSource, SolidTraining, solid_loss
from core.prior.sources import Geometry
from core.prior.train import TrainConfig, Training
from core.tests.small_solids import knowing, words_of

FEW = 8  # nouns of the small networks of solids, the first ones
FEW_WORDS = words_of(FEW)
SOLID = SolidNetConfig(FEW_WORDS, latent=4, embedding=16, widths=(16, 16, 8, 8), hidden=16)
PICTURES = UNetConfig(
    words=(len(NOUNS), len(ADJECTIVES) - 1, len(PART_STATES) - 1), widths=(8, 8, 16, 16), code=16
)
CONFIG = TrainConfig(batch=2, minutes=60, warm_up=1)


@pytest.fixture(scope="module", autouse=True)
def few_nouns() -> Iterator[None]:
    """The tables of all nouns are large."""
    with knowing(FEW):
        yield


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    """Of mugs."""
    path = tmp_path_factory.mktemp("pictures")
    write_shard(path, 0, 2, ["mug"])
    return path


@pytest.fixture(scope="module")
def solids(tmp_path_factory):
    """Of chairs."""
    path = tmp_path_factory.mktemp("solids")
    write_solids(path, 0, of_each=4, nouns=["chair"])
    return path


def of_solids() -> SolidTraining:
    return SolidTraining(partial(Autoencoder, SOLID), CONFIG, objective=solid_loss)


@pytest.fixture
def shipped(tmp_path):
    """Weights to begin with."""
    torch.manual_seed(0)
    net = SolidNet(SOLID)
    for p in (net.own.weight, net.kind.weight):
        nn.init.normal_(p)
    net.mirrored[3, 0] = True
    save_solid_net(tmp_path / "shipped.safetensors", net)
    return tmp_path / "shipped.safetensors"


def test_some_rows_of_a_table_learn_and_no_other_is_asked_for():
    table = nn.Embedding(6, 3)
    rows = LearntRows(table, torch.tensor([2, 4]))
    index = torch.tensor([0, 4, 2])
    found = rows(index)
    assert torch.equal(found, table.weight[index])
    found.sum().backward()
    assert [name for name, p in rows.named_parameters() if p.grad is not None] == ["learnt"]
    changed = rows.whole(rows.learnt + 1) - table.weight
    assert changed.any(1).nonzero()[:, 0].tolist() == [2, 4]
    with pytest.raises(UserError, match="did not start with"):
        rows(torch.tensor([3]))


def test_what_is_held_of_a_training_that_has_learnt_is_its_average(pictures):
    training, source = Training(partial(UNet, PICTURES), CONFIG), Geometry(pictures)
    for _ in range(3):
        training.advance(source)
    average = {name: mean.clone() for name, mean in training.averaged().items()}
    name = "words.0.weight"
    assert not torch.equal(training.weights()[name], average[name])
    training.hold(source)
    for found in (training.weights(), training.averaged()):
        assert found.keys() == average.keys()
        assert all(torch.equal(found[name], average[name]) for name in average)


def test_a_held_training_goes_on_with_the_nouns_that_it_began_with(pictures, tmp_path):
    training, source = Training(partial(UNet, PICTURES), CONFIG), Geometry(pictures)
    training.hold(source)
    training.advance(source)
    training.save(tmp_path / "geometry.safetensors")
    write_shard(tmp_path, 0, 2, ["mug", "vase"])
    again = Training(partial(UNet, PICTURES), CONFIG)
    with pytest.raises(UserError, match="on other nouns"):
        again.resume(tmp_path / "geometry.safetensors", Geometry(tmp_path))


def test_rows_that_were_taken_over_wait_for_the_encoder(solids, shipped):
    training = of_solids()
    training.start_from(shipped)
    training.hold(SolidSource(solids))
    learnt = training.net.decoder.own.learnt
    learnt.sum().backward()
    assert not learnt.grad.any()
    training.step = solid_training.HOLD
    learnt.sum().backward()
    assert learnt.grad.any()


def test_a_held_training_of_solids_goes_on_where_it_was_stopped(solids, shipped, tmp_path):
    training, source = of_solids(), SolidSource(solids)
    training.start_from(shipped)
    training.held_until = 0
    training.hold(source)
    for _ in range(2):
        training.advance(source)
    training.save(tmp_path / "solid.safetensors")
    again = of_solids()
    again.resume(tmp_path / "solid.safetensors", source)
    assert again.held and again.names == training.names
    for a, b in zip(training.params + training.ema, again.params + again.ema, strict=True):
        assert torch.equal(a, b)
    for a, b in zip(training.params, again.params, strict=True):
        if a in training.optimizer.state:
            moments = (t.optimizer.state[p]["exp_avg"] for t, p in ((training, a), (again, b)))
            assert torch.equal(*moments)
    again.advance(source)
    assert again.step == 3


def test_what_mirrors_a_kind_is_taken_over(shipped):
    training = of_solids()
    training.start_from(shipped)
    assert training.net.decoder.mirrored.nonzero().tolist() == [[3, 0]]


def test_kinds_that_are_put_in_order_are_the_folders(solids, monkeypatch):
    source = SolidSource(solids)
    before, rows = kinds_of(solids), source.rows.clone()

    def reversed_kinds(_net, kinds, _nouns):
        return Kinds(kinds.middles.flip(1), kinds.choices.flip(1))

    monkeypatch.setattr(solid_training, "in_order_of", reversed_kinds)
    source.order_kinds(SolidNet(SOLID))
    assert torch.equal(kinds_of(solids).middles, before.middles.flip(1))
    assert torch.equal(source.rows[:, 3], kind_rows(source.samples, source.kinds))
    first = KINDS * NOUNS.index("chair") + 1
    assert torch.equal(source.rows[:, 3] - first, KINDS - 1 - (rows[:, 3] - first))
