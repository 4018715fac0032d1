"""The prior's network, its camera map, its diffusion, its data and its training loop."""

import math
import shutil
from dataclasses import replace
from functools import partial

import pytest
import torch
from safetensors.torch import load_file

from core.camera import Cameras
from core.errors import UserError
from core.guidance.builtin.diffusion import alpha_bar_schedule
from core.guidance.builtin.network import MAP_CHANNELS, UNet, UNetConfig, camera_map
from core.guidance.builtin.nouns.order import ORDER
from core.guidance.builtin.offered import WEIGHTS, read_metadata
from core.guidance.builtin.solid import load_solid_net
from core.guidance.builtin.weights import (
    BULK,
    load_weights,
    load_words,
    save_weights,
    ship_weights,
)
from core.guidance.sds import add_noise, eps_from_v
from core.prior.__main__ import main
from core.prior.data import ADJECTIVES, NOUNS, PART_STATES, make, read_shards, write_shard
from core.prior.evaluate import turn_normals
from core.prior.sources import Geometry
from core.prior.train import (
    TrainConfig,
    Training,
    draw_times,
    drop_conditions,
    learning_rate,
)
from core.prior.velocity import v_target, x_from_v

WORDS = (len(NOUNS), len(ADJECTIVES) - 1, len(PART_STATES) - 1)
TINY = UNetConfig(words=WORDS, widths=(8, 8, 16, 16), code=16)


def _generator(seed: int = 0) -> torch.Generator:
    return torch.Generator().manual_seed(seed)


def test_the_camera_maps_points_project_to_their_pixels():
    cameras = Cameras.orbit([10.0, 200.0], [-30.0, 65.0], 2.4, 55.0)
    size = 8
    plane = camera_map(cameras, size)[:, :3].permute(0, 2, 3, 1)
    ones = torch.ones(2, size, size, 1)
    clip = torch.einsum("bij,bhwj->bhwi", cameras.mvp, torch.cat([plane, ones], -1))
    ndc = clip[..., :2] / clip[..., 3:]
    column = (ndc[..., 0] * 0.5 + 0.5) * size
    row = (0.5 - 0.5 * ndc[..., 1]) * size
    centre = torch.arange(size) + 0.5
    torch.testing.assert_close(column, centre.expand(2, size, size), atol=1e-4, rtol=0)
    torch.testing.assert_close(row, centre[:, None].expand(2, size, size), atol=1e-4, rtol=0)


def test_the_camera_map_ends_with_the_way_to_the_camera():
    cameras = Cameras.orbit([90.0], [0.0])
    back = camera_map(cameras, 4)[0, 3:]
    torch.testing.assert_close(back, torch.tensor([1.0, 0, 0])[:, None, None].expand(3, 4, 4))
    assert camera_map(cameras, 4).shape == (1, MAP_CHANNELS, 4, 4)


def test_v_gives_back_noise_and_picture():
    x, eps = torch.randn(2, 3, 4, 8, 8, generator=_generator())
    alpha_bar = torch.tensor([0.999, 0.4, 1e-4])
    z_t, v = add_noise(x, eps, alpha_bar), v_target(x, eps, alpha_bar)
    torch.testing.assert_close(eps_from_v(v, z_t, alpha_bar), eps, atol=1e-5, rtol=0)
    torch.testing.assert_close(x_from_v(v, z_t, alpha_bar), x, atol=1e-5, rtol=0)


def test_the_schedule_falls_from_the_picture_to_nearly_pure_noise():
    alpha_bar = alpha_bar_schedule()
    assert len(alpha_bar) == 1000
    assert (alpha_bar.diff() <= 0).all()
    assert alpha_bar[0] > 0.999
    assert 0 < alpha_bar[-1] < 2e-4
    # The cosine schedule's middle is SNR 1; a factor of 1/2 on sqrt(SNR) makes it 1/4.
    middle = alpha_bar[499:501].mean().item()
    assert middle / (1 - middle) == pytest.approx(0.25, rel=0.01)


def test_the_network_starts_blind_to_words_but_takes_all_inputs():
    torch.manual_seed(0)
    config = UNetConfig(words=(3, 2), widths=(8, 8, 16, 16), code=16, hint=4)
    net = UNet(config)
    z = torch.randn(2, 4, 64, 64)
    words = torch.tensor([[3, 2], [0, 0]])
    camera = camera_map(Cameras.orbit([0.0, 90.0], [0.0, 0.0]), 32)
    t = torch.tensor([0, 999])
    out = net(z, t, words, camera, torch.zeros_like(z))
    assert out.shape == z.shape
    assert out.isfinite().all()
    hinted = net(z, t, words, camera, torch.ones_like(z))
    assert (hinted - out).abs().mean() > 1e-3
    turned = net(z, t, words, camera.flip(0), torch.zeros_like(z))
    assert (turned - out).abs().mean() > 1e-3


def test_unstated_words_and_cameras_are_zeros_at_the_configured_rates():
    config = TrainConfig(drop_both=0.1, drop_words=0.2, drop_camera=0.3)
    words, camera = torch.ones(20000, 2, dtype=torch.long), torch.ones(20000, 6, 1, 1)
    words, camera = drop_conditions(words, camera, config, _generator())
    no_words, no_camera = words.sum(1) == 0, camera.sum((1, 2, 3)) == 0
    error = 3 * math.sqrt(0.25 / 20000)
    assert (no_words & no_camera).float().mean().item() == pytest.approx(0.1, abs=error)
    assert no_words.float().mean().item() == pytest.approx(0.3, abs=error)
    assert no_camera.float().mean().item() == pytest.approx(0.4, abs=error)


def test_half_of_the_times_come_from_the_noisy_end():
    t = draw_times(20000, TrainConfig(late_fraction=0.5, late_from=600), _generator())
    assert t.min() >= 0
    assert t.max() < 1000
    error = 3 * math.sqrt(0.25 / 20000)
    assert (t >= 600).float().mean().item() == pytest.approx(0.7, abs=error)


def test_the_learning_rate_warms_up_and_ends_at_its_last_fraction():
    config = TrainConfig(learning_rate=1.0, last_fraction=0.1, warm_up=10)
    assert learning_rate(0, 0.0, config) == pytest.approx(0.1)
    assert learning_rate(10, 0.0, config) == 1.0
    assert learning_rate(10, 0.5, config) == pytest.approx(0.55)
    assert learning_rate(10, 1.5, config) == pytest.approx(0.1)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A data folder with one tiny shard."""
    path = tmp_path_factory.mktemp("prior")
    write_shard(path, 7, objects=3)
    return path


def test_a_shard_is_its_seed_and_reads_back(folder):
    (path,) = folder.glob("*.safetensors")
    read, made = read_shards([path]), make(7, 3)
    for name, tensor in vars(made).items():
        assert torch.equal(getattr(read, name), tensor), name
    assert len(read) == 12
    pictures = read.pictures()
    assert pictures.shape == (12, 4, 64, 64)
    assert pictures[:, 3].amin() == -1
    assert pictures[:, :3].norm(dim=1).max() < 1.02


def test_a_noun_is_drawn_by_its_weight(folder, monkeypatch):
    noun = int(read_shards(list(folder.glob("*.safetensors"))).noun[0])
    monkeypatch.setattr(Geometry, "noun_weights", {NOUNS[noun]: 0.0})
    source = Geometry(folder)
    index, _, _ = source.draw(64, _generator())
    assert not (source.samples.noun[index] == noun).any()


def test_a_training_goes_on_where_it_was_stopped(folder, tmp_path):
    source = Geometry(folder)
    training = Training(partial(UNet, TINY), TrainConfig(batch=2, minutes=1))
    for _ in range(2):
        training.advance(source)
    training.save(tmp_path / "geometry.safetensors")
    again = Training(partial(UNet, TINY), TrainConfig(batch=2, minutes=1, seed=5))
    again.resume(tmp_path / "geometry.safetensors", source)
    assert (again.step, again.seconds) == (2, training.seconds)
    for a, b in zip(training.params + training.ema, again.params + again.ema, strict=True):
        assert torch.equal(a, b)
    for a, b in zip(training.params, again.params, strict=True):
        for name in ("exp_avg", "exp_avg_sq"):
            assert torch.equal(training.optimizer.state[a][name], again.optimizer.state[b][name])
    again.advance(source)
    assert again.step == 3


def test_a_training_starts_from_weights_that_know_fewer_words(tmp_path):
    torch.manual_seed(1)
    small = UNetConfig(words=(WORDS[0] - 5, WORDS[1] - 2), widths=(8, 8, 16, 16), code=16)
    old = UNet(small)
    save_weights(tmp_path / "old.safetensors", small, dict(old.named_parameters()))
    training = Training(partial(UNet, TINY), TrainConfig())
    training.start_from(tmp_path / "old.safetensors")
    camera, z = camera_map(Cameras.orbit([30.0], [0.0]), 32), torch.randn(1, 4, 64, 64)
    t = torch.tensor([500])
    with torch.no_grad():
        expected = old(z, t, torch.tensor([[3, 1]]), camera)
        same = training.net(z, t, torch.tensor([[3, 1, 0]]), camera)
        silent = training.net(z, t, torch.tensor([[3, 1, 2]]), camera)
    torch.testing.assert_close(same, expected, atol=2e-3, rtol=2e-2)  # through half precision
    torch.testing.assert_close(same, silent)
    rows = training.net.words[0].weight
    mean = old.words[0].weight[1:].mean(0)
    torch.testing.assert_close(rows[-1], mean, atol=1e-3, rtol=1e-2)


@pytest.mark.parametrize("known", [NOUNS.index("mug"), NOUNS.index("vase")])
def test_what_is_held_stays_to_the_bit_and_the_datas_nouns_learn(known, tmp_path):
    """Whether the older network knew the noun or not."""
    torch.manual_seed(1)
    small = UNetConfig(words=(known, *WORDS[1:]), widths=(8, 8, 16, 16), code=16)
    old = UNet(small)
    for p in old.parameters():
        torch.nn.init.normal_(p, std=0.1)
    save_weights(tmp_path / "old.safetensors", small, dict(old.named_parameters()))
    write_shard(tmp_path, 0, 2, ["mug"])
    mug = 1 + NOUNS.index("mug")
    config = TrainConfig(batch=4, minutes=60, warm_up=1)
    for again in (False, True):
        training, source = Training(partial(UNet, TINY), config), Geometry(tmp_path)
        if again:  # it holds by itself
            training.resume(tmp_path / "net.safetensors", source)
        else:
            training.start_from(tmp_path / "old.safetensors")
            training.hold(source)
        before = training.weights()["words.0.weight"].clone()
        for _ in range(3):
            training.advance(source)
        training.save(tmp_path / "net.safetensors")
        assert not torch.equal(training.weights()["words.0.weight"][mug], before[mug])
    shipped = load_file(tmp_path / "old.safetensors")
    # In full too: what half precision rounds off would be seen after more steps.
    found = load_file(tmp_path / "net_ema.safetensors"), training.weights()
    for name, tensor in (item for tensors in found for item in tensors.items()):
        others = torch.arange(len(shipped[name]))
        if name == "words.0.weight":
            others = others[others != mug]
        assert torch.equal(tensor[others], shipped[name][others].to(tensor)), name


def test_a_training_learns_its_few_pictures(folder):
    source = Geometry(folder)
    training = Training(
        partial(UNet, TINY), TrainConfig(batch=4, minutes=60, warm_up=1, learning_rate=3e-3)
    )
    training.advance(source)
    first = training.loss
    for _ in range(25):
        training.advance(source)
    x, words, camera, _ = source.batch(8, _generator())
    t = torch.full((8,), 600)
    alpha_bar = alpha_bar_schedule()[t]
    eps = torch.randn(x.shape, generator=_generator(1))
    with torch.no_grad():
        v = training.net(add_noise(x, eps, alpha_bar), t, words, camera)
    assert (v - v_target(x, eps, alpha_bar)).square().mean() < 0.9 * first


def test_weights_travel_in_half_precision(tmp_path):
    torch.manual_seed(0)
    net = UNet(TINY)
    save_weights(tmp_path / "net.safetensors", TINY, dict(net.named_parameters()))
    again = load_weights(tmp_path / "net.safetensors")
    assert again.config == TINY
    for a, b in zip(net.parameters(), again.parameters(), strict=True):
        torch.testing.assert_close(a, b, atol=1e-4, rtol=1e-3)
        assert not b.requires_grad


def _large(seed: int) -> UNet:
    """A network some of whose layers are shipped in bytes."""
    torch.manual_seed(seed)
    return UNet(replace(TINY, widths=(16, 16, 32, 32), code=48))


def test_shipped_layers_are_within_half_a_step_of_a_byte(tmp_path):
    net, known = _large(0), {"noun": ["ball", "cube"]}
    path = tmp_path / "net.safetensors"
    ship_weights(path, net, known)
    again = load_weights(path)
    assert load_words(path) == known
    stored = load_file(path)
    in_bytes = [name for name in stored if stored[name].dtype == torch.int8]
    assert in_bytes and not any(name.startswith("words.") for name in in_bytes)
    for (name, a), b in zip(net.named_parameters(), again.parameters(), strict=True):
        error = (a - b).abs() - a.abs() * 2e-3  # of the rounding to halves
        half_step = a.abs().flatten(1).amax(1) / 254 if name in in_bytes else torch.zeros(len(a))
        assert (error.reshape(len(a), -1).amax(1) <= half_step + 1e-6).all()


def test_what_a_training_left_alone_is_shipped_to_the_bit(tmp_path):
    """Through a checkpoint's half precision; what has learnt is another."""
    path, net = tmp_path / "net.safetensors", _large(0)
    layer = next(n for n, p in net.named_parameters() if p.numel() >= BULK and n[:6] != "words.")
    step = 0.00103759765625  # 127 of these, rounded to a half, are 127 of another step
    with torch.no_grad():
        row = net.get_parameter(layer)[0]
        row.clamp_(-step, step)[(0,) * row.ndim] = 127 * step
    ship_weights(path, net, {})
    first = load_file(path)
    assert first[f"{layer}.step"][0] == step
    net = load_weights(path)
    net.load_state_dict({name: p.half().float() for name, p in net.named_parameters()})
    with torch.no_grad():
        net.words[0].weight[1] += 1
    ship_weights(path, net, {})
    second = load_file(path)
    changed = [name for name in first if not torch.equal(first[name], second[name])]
    assert changed == ["words.0.weight"]
    with torch.no_grad():
        net.get_parameter(layer).mul_(1.5)
    ship_weights(path, net, {})
    assert not torch.equal(load_file(path)[f"{layer}.step"], first[f"{layer}.step"])


@pytest.mark.parametrize(("load", "name"), [(load_weights, "parts"), (load_solid_net, "solid")])
def test_loading_draws_no_weights_that_it_overwrites(load, name):
    before = torch.get_rng_state()
    load(WEIGHTS / f"{name}.safetensors")
    assert torch.equal(torch.get_rng_state(), before)


def test_turning_a_pictures_normals_turns_them_with_the_camera():
    x = torch.tensor([0.0, -1.0, 0.0, 1.0])[None, :, None, None].expand(1, 4, 2, 2)
    angle = torch.tensor([math.pi / 2])  # az 0 at -Y goes to 90 at +X
    expected = Cameras.orbit([90.0], [0.0]).back[0]
    torch.testing.assert_close(turn_normals(x, angle)[0, :3, 0, 0], expected, atol=1e-6, rtol=0)


@pytest.mark.parametrize(
    ("argv", "part"),
    [
        ("data --solids -1", "'-1' is not a whole number"),
        ("data --shards 1e3", "'1e3' is not a whole number"),
        ("data --pairs 99999999999", "is not a whole number"),
        ("data --solids 1 --workers 0", "use 1 or more"),
        ("data --out FILE --solids 1", "cannot be written"),
        ("train solid --minutes nan", "is not a number between"),
        ("train solid --minutes -3", "is not a number between"),
        ("train solid --learning-rate 0", "is not a number between"),
        ("train solid --batch 0", "use 1 or more"),
        ("train solid --device abacus", "invalid choice"),
        ("train solid --out FOLDER", "There are no files"),
        ("train parts --new-kinds --out FOLDER", "are for solids"),
        ("train solid --encoder nowhere.safetensors --out FOLDER", "There is no checkpoint"),
        ("data --nouns blorb", "invalid choice"),
        ("evaluate geometry --views 0", "use 1 or more"),
        ("evaluate geometry --weights nowhere.safetensors", "There is no weights"),
        ("ship --without blorb", "There is no word"),
    ],
)
def test_a_wrong_option_is_refused_before_anything_is_made(argv, part, tmp_path, capfd):
    (tmp_path / "file").touch()
    words = argv.replace("FILE", str(tmp_path / "file")).replace("FOLDER", str(tmp_path))
    with pytest.raises((SystemExit, UserError)) as refused:
        main(words.split())
    assert part in f"{refused.value} {capfd.readouterr().err}"
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


def test_a_shipped_network_knows_no_borrowed_things(tmp_path, monkeypatch):
    """They would be offered twice: by the network, and as another thing's solid."""
    monkeypatch.setattr("core.prior.__main__.WEIGHTS", tmp_path)
    shutil.copy(WEIGHTS / "parts.safetensors", tmp_path / "parts_ema.safetensors")
    main(["ship", "--out", str(tmp_path)])
    found = read_metadata(tmp_path / "parts.safetensors")["words"]["noun"]
    assert found == list(ORDER)
