"""The network that draws solids: its parts, its data, its training, and what it ships with."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache, partial
from unittest import mock

import pytest
import torch
from safetensors.torch import load_file, save_file

from core.geometry.mesh import NORMAL_RADIUS
from core.geometry.sdf_net import surface
from core.geometry.tet_grid import EXTENT, tet_grid
from core.guidance.builtin import solid
from core.guidance.builtin.nouns.order import ORDER
from core.guidance.builtin.offered import SOLID, WEIGHTS
from core.guidance.builtin.solid import (
    ROWS,
    TABLES,
    Solid,
    drawn_kind,
    load_solid_net,
    save_solid_net,
)
from core.guidance.builtin.solid_net import (
    KINDS,
    PARTS,
    SCALE,
    SolidNet,
    SolidNetConfig,
    folded,
    with_others,
)
from core.guidance.builtin.stretch import known_wider
from core.guidance.builtin.weights import packed, unpacked
from core.io.job import Job
from core.job_config import config_of
from core.prior import solid_kinds, solid_training
from core.prior.data import NOUNS
from core.prior.draw import Draw
from core.prior.families import build, normalised
from core.prior.redrawn import Redrawing
from core.prior.soft_pairs import make_pairs
from core.prior.soften import HALF, SAFETY
from core.prior.solid_data import (
    REACH,
    SIDE,
    Solids,
    make_solids,
    read_solids,
    volume_of,
    write_solid_files,
    write_solids,
)
from core.prior.solid_kinds import compared, kind_rows, kinds_of, nearest_kind
from core.prior.solid_training import (
    INSIDE,
    STEEPNESS,
    Autoencoder,
    SolidSource,
    SolidTraining,
    asked,
    distance_loss,
    inside_loss,
    mirrored,
    parts_mirrored,
    remember,
    solid_loss,
    trained_solid_net,
)
from core.prior.train import TrainConfig, Training
from core.tests.small_solids import knowing, words_of

NOUN = ["mug", "chair"]
GRID = tet_grid(24)
FEW = 12  # nouns of the small networks, the first ones
FEW_WORDS = words_of(FEW)
TINY = SolidNetConfig(FEW_WORDS, latent=4, embedding=16, widths=(16, 16, 8, 8), hidden=16)


def _generator(seed: int = 0) -> torch.Generator:
    return torch.Generator().manual_seed(seed)


def _rows(noun: str, kind: int = 0) -> torch.Tensor:
    row = 1 + list(ORDER).index(noun)
    return torch.tensor([[row, 0, 0, KINDS * (row - 1) + 1 + kind]])


def _tiny() -> SolidNet:
    torch.manual_seed(0)
    net = SolidNet(TINY)
    torch.nn.init.normal_(net.own.weight)
    torch.nn.init.normal_(net.kind.weight)
    net.counts[0, 0, 1:] = 1
    return net.eval().requires_grad_(False)


@pytest.fixture(scope="module", autouse=True)
def coarse() -> Iterator[None]:
    """Solids have their meshes on a lattice of a third as many nodes."""
    with mock.patch.object(solid, "_grid", return_value=tet_grid(44)):
        yield


@pytest.fixture(scope="module", autouse=True)
def few_nouns() -> Iterator[None]:
    """The training knows only its network's nouns; the tables of all nouns are large."""
    with knowing(FEW):
        yield


@pytest.fixture(scope="module")
def shipped() -> SolidNet:
    return load_solid_net(WEIGHTS / f"{SOLID}.safetensors")


def _drawn(net: SolidNet, noun: str, seed: int = 0) -> Solid:
    return Solid.drawn(net, _rows(noun)[:, :3], _generator(seed)).placed()


def test_a_plane_sees_the_others_mean_at_their_common_row():
    xy, xz, yz = torch.randn(3, 1, 2, 4, 4).unbind()
    of_xy, of_xz, of_yz = with_others([xy, xz, yz])
    for i in range(4):
        for j in range(4):
            torch.testing.assert_close(of_xy[0, 2:4, i, j], xz[0, :, i].mean(1))  # the same x
            torch.testing.assert_close(of_xy[0, 4:, i, j], yz[0, :, j].mean(1))  # the same y
            torch.testing.assert_close(of_xz[0, 4:, i, j], yz[0, :, :, j].mean(1))  # the same z
            torch.testing.assert_close(of_yz[0, 2:4, i, j], xy[0, :, :, i].mean(1))
            torch.testing.assert_close(of_yz[0, 4:, i, j], xz[0, :, :, j].mean(1))


def test_an_answer_depends_on_noun_kind_code_and_point():
    net, points = _tiny(), torch.rand(1, 50, 3, generator=_generator()) * 2 - 1
    code = torch.zeros(1, 4)

    def at(words, code=code, points=points):
        distances = net.at(net.triplane(words, code), points)
        assert distances.shape == (1, 50, PARTS)
        return distances

    plain = at(_rows("mug"))
    assert not torch.equal(plain, at(_rows("chair")))
    assert not torch.equal(plain, at(_rows("mug", kind=1)))
    assert not torch.equal(plain, at(_rows("mug"), code=code + 1))
    assert not torch.equal(plain, at(_rows("mug"), points=points.flip(2)))
    assert torch.equal(plain, at(_rows("mug")))


def test_weights_travel_in_halves_and_bytes(tmp_path):
    net = _tiny()
    save_solid_net(tmp_path / "solid.safetensors", net)
    again = load_solid_net(tmp_path / "solid.safetensors")
    assert again.config == net.config
    for (name, old), new in zip(net.state_dict().items(), again.state_dict().values(), strict=True):
        if old.dtype == torch.bool:
            assert torch.equal(old, new)
            continue
        steps = 2 ** ((6 if name in TABLES else 8) - 1) - 1
        step = old.abs().max() / steps if name in (*TABLES, *ROWS) else 1e-2
        assert (old - new).abs().max() <= 0.51 * step + 1e-3, name
    stored = load_file(tmp_path / "solid.safetensors")
    table = net.kind.weight
    assert (stored["kind.weight"].dtype, stored["kind.weight"].numel() * 4) == (
        torch.uint8,
        table.numel() * 3,
    )
    # What is loaded and kept again is the same file: the nouns that a held training leaves alone.
    save_solid_net(tmp_path / "again.safetensors", again)
    files = [(tmp_path / f"{name}.safetensors").read_bytes() for name in ("solid", "again")]
    assert files[0] == files[1]


def test_numbers_of_six_bits_come_back():
    numbers = torch.randint(-31, 32, (5, 24), generator=_generator(0), dtype=torch.int8)
    numbers[0, :4] = torch.tensor([-31, 31, 0, -1])
    assert packed(numbers).shape == (5, 18)
    assert torch.equal(unpacked(packed(numbers)), numbers)


def test_a_kind_is_drawn_as_often_as_the_training_had_it():
    net = _tiny()
    net.counts.zero_()
    first = int(_rows("mug")[0, 3])
    net.counts[0, 0, first + 1] = 30
    net.counts[0, 0, first + 2] = 60
    net.counts[0, 0, first + 3] = 2  # rare: hardly known
    words = _rows("mug")[:, :3]
    drawn = [drawn_kind(net, words, _generator(seed)) - first for seed in range(300)]
    assert set(drawn) == {1, 2}
    assert 0.2 < drawn.count(1) / len(drawn) < 0.46
    # Words that never came with the noun: any kind of the noun's.
    unseen = words + torch.tensor([[0, 3, 0]])
    assert drawn_kind(net, unseen, _generator()) - first in (1, 2)


@pytest.fixture(scope="module")
def mug(shipped) -> Callable[[str], Solid]:
    """One mug with each adjective."""
    return cache(Solid.drawn(shipped, _rows("mug")[:, :3], _generator()).placed)


@pytest.mark.parametrize("adjective", ["", "tall", "flat", "thick", "round"])
def test_a_placed_solid_is_of_the_trainings_size(mug, adjective):
    solid = mug(adjective)
    verts, _ = solid.mesh
    low, high = verts.amin(0), verts.amax(0)
    assert (low + high).abs().max() < 0.04
    radius = (verts - (low + high) / 2).norm(dim=1).max().item()
    assert radius == pytest.approx(NORMAL_RADIUS, abs=0.03)
    assert solid.sdf(verts).abs().mean() < 0.01


def test_tall_is_taller_and_flat_flatter(mug):
    def slender(adjective):
        verts, _ = mug(adjective).mesh
        x, _, z = (verts.amax(0) - verts.amin(0)).tolist()
        return z / x

    assert slender("flat") < 0.75 * slender("") < slender("") < 0.8 * slender("tall")


def test_solids_are_their_familys():
    solids = make_solids(3, of_each=1, nouns=NOUN)
    assert len(solids) == 2 and solids.rows()[0, 0] == 1 + NOUNS.index("mug")
    points = solids.points[1].float() / 32767 * EXTENT
    assert points.abs().max() <= EXTENT
    # A volume's cell and a point near to its middle agree.
    cell = ((points + EXTENT) * (SIDE / (2 * EXTENT))).long().clamp_max(SIDE - 1)
    volume = solids.volumes(slice(1, 2))[0, 0][tuple(cell.T)] * REACH
    distances = solids.distances[1].float()
    whole, part = distances.min(1)
    assert (volume - whole).abs().max() < 1.8 * EXTENT / SIDE + 0.01
    assert (whole.abs() < 0.05).float().mean() > 0.5
    assert part.unique().numel() > 1  # a chair has legs and a seat
    assert (solids.distances[0, :, 2:] == distances.max()).all()  # a mug has no more than two
    again = make_solids(3, of_each=1, nouns=NOUN)
    assert torch.equal(again.points, solids.points)


def test_only_a_round_table_keeps_its_adjective():
    words = make_solids(0, of_each=12, nouns=["table", "mug"]).words
    assert set(words[words[:, 0] == NOUNS.index("mug"), 1].tolist()) == {0}
    assert len(set(words[words[:, 0] == NOUNS.index("table"), 1].tolist())) == 2


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Objects of two nouns; the others' kinds are empty."""
    path = tmp_path_factory.mktemp("solids")
    for number in range(3):
        write_solids(path, number, of_each=4, nouns=NOUN)
    return path


def test_files_are_made_once_and_whole(folder):
    paths = sorted(folder.glob("solids_*.safetensors"))
    before = [path.stat().st_mtime_ns for path in paths]
    assert write_solids(folder, 0) == paths[0]
    assert [path.stat().st_mtime_ns for path in paths] == before
    assert len(read_solids(paths)) == 24
    assert list(write_solid_files(folder, range(0), 1)) == []


def test_kinds_distinguish_objects_that_look_different(folder):
    solids = read_solids(sorted(folder.glob("solids_*.safetensors")))
    chairs = solids.words[:, 0] == NOUNS.index("chair")
    kinds = kinds_of(folder)
    rows = kind_rows(solids, kinds)
    first = 1 + KINDS * NOUNS.index("chair")
    assert ((rows[chairs] >= first) & (rows[chairs] < first + KINDS)).all()
    assert rows[chairs].unique().numel() > 1
    # Within a kind objects are nearer to its middle than to that of all.
    found = compared(solids.grid[chairs])
    away = torch.cdist(found, kinds.middles[NOUNS.index("chair")])
    assert away.gather(1, (rows[chairs] - first)[:, None]).mean() < (
        (found - found.mean(0)).norm(dim=1).mean()
    )
    assert all(map(torch.equal, kinds_of(folder), kinds))  # found once
    assert solid_kinds.NAME in {path.name for path in folder.iterdir()}


def test_what_is_rightly_far_has_no_error():
    found = torch.tensor([[3.0, -3.0, 3.0, 0.2]])
    wanted = torch.tensor([[1.0, -1.0, -1.0, 0.5]])
    assert distance_loss(found, wanted) == pytest.approx((0 + 0 + INSIDE * 4 + 0.3) / 4)


def test_half_of_the_points_are_at_the_parts_at_each_as_many():
    distances = torch.full((2, 1000, 8), 0.2)
    distances[:, :600, 0] = 0.0
    distances[:, 990:995, 1] = -0.02  # a doll's eyes
    points = torch.arange(1000).repeat(2, 1)[..., None].expand(-1, -1, 3).short()
    nothing = torch.zeros(2, 1)
    solids = Solids(nothing, points, distances.half(), nothing, nothing[:, 0].long())
    places, found = asked(solids, torch.tensor([1, 0, 1]), 800, _generator())
    assert places.shape == (3, 800, 3)
    assert found.shape == (3, 800, 8)
    at_eyes = (found[..., 1] < 0).float().mean(1)
    assert (at_eyes > 0.2).all() and (at_eyes < 0.32).all()
    assert (places[..., 0] * 32767).round().unique().numel() > 700, "the rest are anywhere"
    assert torch.equal(found[..., 1] < 0, (places[..., 0] * 32767).round().sub(992).abs() <= 2)


def test_the_sign_alone_decides_what_is_inside():
    wanted = torch.tensor([[-0.5, 0.5, 0.001]])
    right, wrong = torch.tensor([[-9.0, 9.0, -9.0]]), torch.tensor([[9.0, -9.0, 9.0]])
    assert inside_loss(right, wanted) == pytest.approx(0, abs=1e-6)  # the last is on the surface
    assert inside_loss(wrong, wanted) == pytest.approx(STEEPNESS * 9, rel=1e-3)


def test_a_training_learns_ships_and_draws(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(solid_training, "Autoencoder", partial(Autoencoder, TINY))
    config = TrainConfig(batch=4, minutes=60, warm_up=1, learning_rate=2e-3)
    training = Training(partial(Autoencoder, TINY), config, objective=solid_loss)
    source = SolidSource(folder)
    training.advance(source)
    first = training.loss
    for _ in range(20):
        training.advance(source)
    batch = source.batch(8, _generator(1))
    with torch.no_grad():
        assert solid_loss(training, batch) < 0.5 * first
    for path in folder.iterdir():
        (tmp_path / path.name).symlink_to(path)
    training.save(tmp_path / "solid.safetensors")
    net = trained_solid_net(tmp_path, WEIGHTS / "solid.safetensors")
    assert net.counts.sum() == len(source.samples)
    drawn = drawn_kind(net, _rows("chair")[:, :3], _generator())
    assert net.counts[..., drawn].sum() > 0


def test_a_training_goes_on_from_a_shipped_decoder_of_fewer_features(tmp_path):
    old = SolidNet(replace(TINY, fine=2))
    torch.nn.init.normal_(old.own.weight)
    save_solid_net(tmp_path / "old.safetensors", old)
    training = SolidTraining(partial(Autoencoder, TINY), TrainConfig(), objective=solid_loss)
    training.start_from(tmp_path / "old.safetensors")
    new, loaded = training.net.decoder, load_solid_net(tmp_path / "old.safetensors")
    # More inputs of the one, more outputs of the other.
    for name in ("point.weight", "fine.0.weight"):
        wide, narrow = new.get_parameter(name), loaded.get_parameter(name)
        assert torch.equal(wide[tuple(slice(n) for n in narrow.shape)], narrow)
        assert wide.shape != narrow.shape
    assert torch.equal(new.own.weight, loaded.own.weight)
    # What was taken over waits for what is new.
    new.own.weight.sum().backward()
    assert not new.own.weight.grad.any()
    training.step = solid_training.HOLD
    new.own.weight.sum().backward()
    assert new.own.weight.grad.any()


def test_kinds_start_again_and_the_encoder_is_an_older_trainings(folder, tmp_path):
    trainings = [
        SolidTraining(
            partial(Autoencoder, TINY), TrainConfig(batch=4, seed=seed), objective=solid_loss
        )
        for seed in (0, 1)
    ]
    first, second = trainings
    for training in trainings:
        for table in (training.net.decoder.kind, training.net.decoder.words[3]):
            torch.nn.init.normal_(table.weight)
    first.save(tmp_path / "solid.safetensors")
    second.encode_as(tmp_path / "solid.safetensors")
    second.forget_kinds(SolidSource(folder))
    assert torch.equal(
        second.net.encoder.words.weight, first.ema[_place(first, "encoder.words.weight")]
    )
    rows = torch.tensor([NOUNS.index(noun) for noun in NOUN])
    kinds = (KINDS * rows[:, None] + 1 + torch.arange(KINDS)).flatten()
    for table in (second.net.decoder.kind, second.net.decoder.words[3]):
        assert not table.weight[kinds].any() and table.weight.any(1).sum() == len(
            table.weight
        ) - len(kinds)
    # What was taken over learns from the first step on.
    assert torch.equal(second._held(torch.ones(2)), torch.ones(2))
    assert not first._held(torch.ones(2)).any()
    # And does so after a stop.
    second.save(tmp_path / "second.safetensors")
    first.resume(tmp_path / "second.safetensors", SolidSource(folder))
    assert torch.equal(first._held(torch.ones(2)), torch.ones(2))


def _place(training, name):
    return [name for name, _ in training.net.named_parameters()].index(name)


@pytest.mark.parametrize("known", [NOUNS.index("chair"), NOUNS.index("mug") + 1])
def test_a_held_training_leaves_all_other_nouns_to_the_bit(folder, tmp_path, known):
    """Whether the older network knew the nouns or not."""
    small = replace(TINY, words=(known, *FEW_WORDS[1:3], KINDS * known))
    old = SolidNet(small)
    for tensor in (*old.parameters(), old.counts):
        torch.nn.init.normal_(tensor)
    save_solid_net(tmp_path / "old.safetensors", old)
    training = SolidTraining(
        partial(Autoencoder, TINY), TrainConfig(batch=4, warm_up=1), objective=solid_loss
    )
    training.start_from(tmp_path / "old.safetensors")
    source = SolidSource(folder)
    training.hold(source)
    before = {name: p.clone() for name, p in training.weights().items()}
    for _ in range(3):
        training.advance(source)
    assert not torch.equal(training.net.encoder.words.weight, before["encoder.words.weight"])
    for path in folder.iterdir():
        (tmp_path / path.name).symlink_to(path)
    training.save(tmp_path / "solid.safetensors")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(solid_training, "Autoencoder", partial(Autoencoder, TINY))
        net = trained_solid_net(tmp_path, tmp_path / "old.safetensors")
    save_solid_net(tmp_path / "new.safetensors", net)
    shipped, new = (load_solid_net(tmp_path / f"{name}.safetensors") for name in ("old", "new"))
    rows = torch.tensor([1 + NOUNS.index(noun) for noun in NOUN])
    kinds = (KINDS * (rows[:, None] - 1) + 1 + torch.arange(KINDS)).flatten()
    of = dict.fromkeys(("words.0.weight", "own.weight"), rows)
    of |= dict.fromkeys(("words.3.weight", "kind.weight", "mirrored", "counts"), kinds)
    for name, tensor in shipped.state_dict().items():
        along = tensor.ndim - 1 if name == "counts" else 0
        others = torch.arange(tensor.shape[along])
        others = others[~torch.isin(others, of.get(name, torch.tensor([])))]
        kept = (x.index_select(along, others) for x in (new.state_dict()[name], tensor))
        assert torch.equal(*kept), name
    for name in ("own.weight", "kind.weight"):
        learnt = new.state_dict()[name][of[name]]
        assert not torch.equal(learnt, before[f"decoder.{name}"][of[name]]), name
    assert new.counts[..., kinds].sum() == len(SolidSource(folder).samples)


def test_nouns_of_larger_errors_are_drawn_more_often(folder):
    source = SolidSource(folder)
    chair = NOUNS.index("chair")
    evenly = (source.batch(40, _generator()).words[:, 0] == chair + 1).sum()
    batch = source.batch(8, _generator())
    batch.words[:, 0] = chair + 1
    for _ in range(9):
        remember(batch, torch.full((8,), 5.0))
    assert source.errors[chair] > 3
    assert (source.batch(40, _generator()).words[:, 0] == chair + 1).sum() > evenly


# Of things with legs, handles, wheels and spikes.
DRAWN = ("chair", "mug", "car", "robot", "table", "sword", "bookshelf", "dragon", "teapot", "crown")


@pytest.mark.parametrize("noun", DRAWN)
def test_the_shipped_network_draws_the_thing(shipped, noun):
    side = torch.linspace(-1, 1, 40)
    points = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1).view(-1, 3)
    inside = _drawn(shipped, noun).sdf(points) < 0
    draw = Draw(_generator(5))
    wider = known_wider(noun)  # as the network knows it
    family = (build(noun, "", draw, 0.0, wider).sdf(points) < 0 for _ in range(24))
    likeness = (float((inside & o).sum() / (inside | o).sum()) for o in family)
    assert any(found > 0.55 for found in likeness)  # of the volume, with one of them


def test_the_shipped_network_knows_the_parts(shipped):
    solid = _drawn(shipped, "chair")
    verts, _ = solid.mesh
    parts = solid.part(verts)
    low = verts[:, 2] < verts[:, 2].amin() + 0.15
    names = build("chair", "", Draw(_generator())).names
    assert (parts[low] == names.index("legs")).float().mean() > 0.9
    assert (parts[~low] == names.index("legs")).float().mean() < 0.5


def test_a_seed_is_one_object_and_seeds_differ(shipped):
    points = torch.rand(2000, 3, generator=_generator()) * 2 - 1
    one, same, other = (_drawn(shipped, "mug", seed).sdf(points) for seed in (0, 0, 1))
    assert torch.equal(one, same)
    assert not torch.equal(one, other)


def test_what_can_be_drawn_needs_no_growing():
    drawn = config_of(Job(prompt="a chair")).geometry
    assert drawn.start == "learned" and drawn.net.residual > 0
    assert drawn.coarse.steps == drawn.grow.rounds == drawn.refine.rounds == 0


@pytest.mark.parametrize(
    "job",
    [
        Job(prompt="a chair", guidance="models/sd15"),
        Job(prompt="a chair", settings={"geometry.start": "ellipsoid"}),
        Job(prompt="a chair", settings={"geometry.pictures": "shaded"}),
        Job(prompt="a chair", preset="sds"),
    ],
    ids=["Stable Diffusion", "asked for", "ablation", "distillation alone"],
)
def test_what_is_not_drawn_is_distilled(job):
    geometry = config_of(job).geometry
    assert geometry.start == "ellipsoid"
    assert geometry.coarse.steps > 0


def test_steps_that_are_asked_for_are_taken():
    job = Job(prompt="a chair", settings={"geometry.coarse.steps": 7})
    geometry = config_of(job).geometry
    assert (geometry.start, geometry.coarse.steps) == ("learned", 7)
    assert replace(geometry).grow.rounds == 0


def test_scale_is_that_of_the_tenth():
    assert pytest.approx(1.0) == SCALE * 0.1


def _redrawing() -> Redrawing:
    torch.manual_seed(0)
    net = Autoencoder(TINY).eval().requires_grad_(False)
    kinds = torch.randn(FEW, KINDS, SIDE**3, generator=_generator())
    return Redrawing(net, kinds)


@pytest.mark.parametrize("wider", [(1.0, 1.0, 1.0), (2.0, 2.0, 1.0)])
def test_a_redrawn_solid_is_what_the_network_answers_at_the_lattice_nodes(monkeypatch, wider):
    """Of what is known wider than it is, at the nodes as wide as that."""
    monkeypatch.setattr("core.prior.redrawn.known_wider", lambda _: wider)
    noun, cells = NOUNS.index("mug"), 16
    redrawing, shape = _redrawing(), build("mug", "", Draw(_generator()))
    lattice = redrawing.shape(shape, noun, cells)
    known = normalised(shape.parts, wider) if max(wider) > 1 else shape
    by = torch.tensor(known.scale) / torch.tensor(shape.scale)
    volume = volume_of(known)
    kind = nearest_kind(volume, redrawing.kinds[noun])
    words = torch.tensor([[noun + 1, 0, 0, 1 + KINDS * noun + kind]])
    code, _ = redrawing.net.encode(volume[None, None].float() / 127, words)
    triplane = redrawing.net.decoder.triplane(words, code)
    # Nodes by their places along x, y and z: all different, so that swapped axes would show.
    nodes = torch.tensor([[3, 7, 12], [8, 8, 8], [14, 2, 5]])
    points = nodes * (2 * HALF / cells) - HALF
    local = points * by / EXTENT
    true = redrawing.net.decoder.at(triplane, local[None])[0].amin(1) / (SCALE * by.max())
    torch.testing.assert_close(lattice.sdf(points), SAFETY * true, atol=1e-5, rtol=1e-4)


def test_a_folder_without_a_trained_network_redraws_nothing(tmp_path):
    assert Redrawing.of(tmp_path) is None


def test_a_folders_network_comes_back_with_its_encoder(tmp_path, monkeypatch):
    monkeypatch.setattr("core.prior.redrawn.Autoencoder", partial(Autoencoder, TINY))
    there = _redrawing()
    weights = {n: x.half().contiguous() for n, x in there.net.named_parameters()}
    save_file(weights, tmp_path / "solid_ema.safetensors")
    save_file({"middles": there.kinds.half()}, tmp_path / "kinds.safetensors")
    back = Redrawing.of(tmp_path)
    assert back
    shape, noun = build("mug", "", Draw(_generator())), NOUNS.index("mug")
    one, other = (each.shape(shape, noun, 8).values for each in (there, back))
    torch.testing.assert_close(one, other, atol=2e-3, rtol=2e-2)


def test_most_soft_pairs_are_redrawn_once_there_is_a_network(monkeypatch):
    asked = []

    class Spy(Redrawing):
        def shape(self, shape, noun, cells):
            asked.append(noun)
            return super().shape(shape, noun, cells)

    redrawing = _redrawing()
    spy = Spy(redrawing.net, redrawing.kinds)
    with_it = make_pairs(1, 2, ["mug"], redrawing=spy)
    assert 1 <= len(asked) <= 2 and set(asked) == {NOUNS.index("mug")}
    without = make_pairs(1, 2, ["mug"])
    assert not torch.equal(with_it.soft, without.soft)


def test_what_is_mirrored_is_the_same_on_both_sides_and_smooth_between():
    net = _tiny()
    words, code = _rows("mug"), torch.zeros(1, 4)
    points = torch.rand(1, 200, 3, generator=_generator()) * 2 - 1
    flip = torch.tensor([-1.0, 1.0, 1.0])
    there, back = (net.at(net.triplane(words, code), p) for p in (points, points * flip))
    assert not torch.allclose(there, back)
    net.mirrored[words[0, 3], 0] = True
    there, back = (net.at(net.triplane(words, code), p) for p in (points, points * flip))
    assert torch.equal(there, back)
    ahead = net.at(net.triplane(words, code), points * torch.tensor([1.0, -1.0, 1.0]))
    assert not torch.allclose(there, ahead)  # y is not mirrored
    near = torch.linspace(-1e-3, 1e-3, 3)[None, :, None] * torch.tensor([1.0, 0, 0])
    left, middle, right = folded(near, torch.tensor([[True, False]]))[0, :, 0].tolist()
    assert left == right == pytest.approx(3.3e-5, rel=0.02) and middle == 0


def test_a_kind_is_mirrored_where_all_of_its_objects_are(folder):
    source = SolidSource(folder)
    sides = source.mirrored[source.rows[:, 3]]
    mugs = source.samples.words[:, 0] == NOUNS.index("mug")
    assert not sides[mugs, 0].all()  # a handle at one side, or none
    assert sides[mugs, 1].all()
    assert sides[~mugs, 0].all()  # chairs
    assert not sides[~mugs, 1].any()  # a back
    assert not source.mirrored[0].any()  # of no kind


def test_parts_that_differ_from_side_to_side_are_not_mirrored():
    """A cube's stickers: both sides of the whole's volume are the same."""
    nouns = ["puzzle cube", "chair", "sunglasses"]
    solids = make_solids(0, of_each=2, nouns=nouns)
    assert mirrored(solids.grid, 0).all()
    found = {noun: parts_mirrored(solids, 2 * k, 0) for k, noun in enumerate(nouns)}
    assert found == {"puzzle cube": False, "chair": True, "sunglasses": True}


def test_a_torn_drawing_is_drawn_again(monkeypatch):
    """Of three codes the simplest shape is taken; a simple first one is taken at once."""
    for complexities, tried in (([2], 1), ([9, 3], 2), ([9, 12, 7], 3), ([9, 7, 12], 3)):
        waiting, made = list(complexities), {}

        def complexity(solid, waiting=waiting, made=made):
            if id(solid) not in made:
                made[id(solid)] = waiting.pop(0), solid  # kept, or its id would come again
            return made[id(solid)][0]

        monkeypatch.setattr(Solid, "complexity", property(complexity))
        drawn = Solid.drawn(_tiny(), _rows("mug")[:, :3], _generator())
        assert len(made) == tried
        assert made[id(drawn)][0] == min(complexities)


def test_complexity_counts_components_and_handles():
    def of(sdf):
        solid = Solid.__new__(Solid)
        verts, faces, *_ = surface(sdf(GRID.tet_verts), GRID.tet_verts, GRID)
        solid.__dict__["mesh"] = verts, faces
        return solid.complexity

    def ball(at):
        return lambda p: (p - torch.tensor(at)).norm(dim=1) - 0.3

    def ring(p):
        return torch.stack([p[:, :2].norm(dim=1) - 0.6, p[:, 2]]).norm(dim=0) - 0.2

    assert of(ball([0.0, 0, 0])) == 1
    assert of(lambda p: torch.minimum(ball([-0.5, 0, 0])(p), ball([0.5, 0, 0])(p))) == 2
    assert of(ring) == 2


def test_a_guide_shapes_what_is_drawn():
    geometry = config_of(Job(prompt="a chair", guide_mesh="x.obj", guide_strength=0.5)).geometry
    assert geometry.start == "learned"
