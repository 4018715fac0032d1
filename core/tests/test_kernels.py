"""The compiled loops against the torch formulas that they implement."""

import errno
import shutil
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numba
import pytest
import torch
from numba.core.caching import FunctionCache, IndexDataCacheFile
from torch import Tensor

from core import kernels
from core.camera import Cameras
from core.hash_grid import HashGrid
from core.kernels.compiled import compiled
from core.ops import normalize, recomputed
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.render.rasterizer import rasterize, to_clip
from core.render.visibility import visibility
from core.tests.meshes import sphere, torus

CAMERAS = Cameras.orbit([7.0, 53.0, 201.0], [4.0, 31.0, 84.0])
INSIDE = Cameras.orbit([10.0, 130.0], [20.0, -50.0], distance=0.3)
SHAPES = {"ball": sphere(5, bump=0.12, noise=0.0015), "ring": torus(96, 48)}


def soup(count: int) -> tuple[Tensor, Tensor]:
    """Large faces anywhere, to be looked at from among them."""
    generator = torch.Generator().manual_seed(1)
    middle = torch.rand(count, 1, 3, generator=generator) * 2 - 1
    verts = middle + 0.5 * torch.randn(count, 3, 3, generator=generator)
    return verts.view(-1, 3), torch.arange(3 * count).view(-1, 3)


@pytest.fixture
def both(monkeypatch: pytest.MonkeyPatch) -> Callable:
    """Runs a function with the compiled loops and with plain torch."""

    def run(function: Callable) -> tuple:
        compiled = function()
        with monkeypatch.context() as patch:
            patch.setattr(kernels, "supports", lambda *_: False)
            return compiled, function()

    return run


@pytest.mark.parametrize("cull", [True, False])
@pytest.mark.parametrize("name", [*SHAPES, "soup"])
def test_the_same_faces_are_seen(both: Callable, name: str, cull: bool) -> None:
    verts, faces = SHAPES[name] if name in SHAPES else soup(60)
    cameras = CAMERAS if name in SHAPES else INSIDE

    def fragments() -> list[Tensor]:
        found = rasterize(verts, faces, cameras.mvp, 61, 83, cull)
        return [found.face_id, found.pixel, found.view, found.corners, found.bary, found.depth]

    compiled, plain = both(fragments)
    if name == "soup":
        clip = to_clip(verts, cameras.mvp)
        behind = (clip[..., 2] < -clip[..., 3])[:, faces].sum(-1)
        seen = compiled[0].unique()
        cut = ((behind > 0) & (behind < 3)).any(0).nonzero()
        assert set(seen.tolist()) & set(cut.flatten().tolist())  # the near plane cuts what is seen
    for ours, theirs in zip(compiled[:4], plain[:4], strict=True):
        assert torch.equal(ours, theirs)
    for ours, theirs in zip(compiled[4:], plain[4:], strict=True):
        assert torch.allclose(ours, theirs, atol=2e-5)


@pytest.mark.parametrize("cull", [True, False])
@pytest.mark.parametrize("name", SHAPES)
def test_pictures_and_gradients_agree(both: Callable, name: str, cull: bool) -> None:
    verts, faces = SHAPES[name]
    weight = torch.rand(3, 40, 40, 4, generator=torch.Generator().manual_seed(0))

    def drawn() -> tuple[Tensor, Tensor]:
        at = verts.clone().requires_grad_()
        picture = torch.cat(render_normals(at, faces, CAMERAS, 40, cull=cull), -1)
        (picture * weight).sum().backward()
        return picture.detach(), at.grad

    (picture, grad), (plain_picture, plain_grad) = both(drawn)
    assert torch.allclose(picture, plain_picture, atol=2e-5)
    assert float((grad - plain_grad).norm() / plain_grad.norm()) < 1e-4


def test_a_zero_stays_zero_at_unit_length(both: Callable) -> None:
    generator = torch.Generator().manual_seed(0)
    rows = torch.randn(5, 7, 3, generator=generator) * torch.logspace(-9, 3, 7)[:, None]
    rows[0] = 0
    weight = torch.randn(rows.shape, generator=generator)

    def unit() -> tuple[Tensor, Tensor]:
        x = rows.clone().requires_grad_()
        out = normalize(x)
        (out * weight).sum().backward()
        return out.detach(), x.grad

    (out, grad), (plain, plain_grad) = both(unit)
    assert torch.allclose(out, plain, atol=1e-6)
    assert torch.allclose(grad, plain_grad, rtol=1e-4, atol=1e-6)
    assert (out[0] == 0).all()


def test_what_is_recomputed_for_its_gradient_hands_its_tensors_out_once(both: Callable) -> None:
    """As in the shading of many points, whose backward computes it again (``recomputed``)."""
    rows = torch.randn(6, 3, generator=torch.Generator().manual_seed(0))

    def unit() -> Tensor:
        x = rows.clone().requires_grad_()
        recomputed(normalize, x).square()[:, 0].sum().backward()
        return x.grad

    grad, plain = both(unit)
    assert torch.allclose(grad, plain, atol=1e-6)
    assert plain.norm() > 0.1


def test_edges_with_many_faces_agree(both: Callable) -> None:
    """A fan, whose edge with three faces counts as two, and a view from behind."""
    verts = torch.tensor([[0.0, 0, -0.5], [0, 0, 0.5], [0.5, 0, 0], [-0.4, 0.3, 0], [0, -0.5, 0.1]])
    faces = torch.tensor([[0, 1, 2], [0, 1, 3], [1, 0, 4]])
    table = edge_table(faces)

    for cull in (False, True):

        def drawn(cull: bool = cull) -> Tensor:
            return torch.cat(render_normals(verts, faces, CAMERAS, 24, edges=table, cull=cull), -1)

        compiled, plain = both(drawn)
        assert torch.allclose(compiled, plain, atol=1e-5)
        assert float(compiled.abs().sum()) > 10


def test_double_precision_goes_the_plain_way() -> None:
    verts, faces = SHAPES["ring"]
    assert kernels.supports(verts, faces)
    assert not kernels.supports(verts.double(), faces)
    seen = visibility(torch.nn.functional.pad(verts, (0, 1), value=1.0)[None].double(), faces, 9, 9)
    assert int(seen.max()) >= 0


@pytest.mark.parametrize("features", [1, 2])
def test_hash_grids_agree(both: Callable, features: int) -> None:
    """Dense levels and hashed ones, points on the cube's faces and corners among them."""
    generator = torch.Generator().manual_seed(0)
    grid = HashGrid(4, features, log2_size=9, base=4, finest=60, generator=generator)
    torch.nn.init.uniform_(grid.table, -1, 1, generator=generator)
    points = (torch.rand(500, 3, generator=generator) * 2 - 1) * 1.05
    points[:8] = torch.cartesian_prod(*[torch.tensor([-1.05, 1.05])] * 3)
    weight = torch.randn(500, 4 * features, generator=generator)

    def sampled() -> tuple[Tensor, Tensor, Tensor]:
        grid.table.grad, at = None, points.clone().requires_grad_()
        out = grid(at)
        (out * weight).sum().backward()
        return out.detach(), grid.table.grad, at.grad

    for ours, theirs in zip(*both(sampled), strict=True):
        assert torch.allclose(ours, theirs, rtol=1e-4, atol=1e-4 * float(theirs.abs().max()))


def test_of_processes_that_start_together_one_compiles(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The files are between them, and the lock is that of an open file: one process may be both."""
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))

    def loop(x: float) -> float:
        return x + 1

    one, other, types = compiled(loop), compiled(loop), (numba.float64,)
    assert one._cache.load_overload(types, one.targetctx) is None  # now it would compile
    with ThreadPoolExecutor(1) as pool:
        waiting = pool.submit(other._cache.load_overload, types, other.targetctx)
        with pytest.raises(TimeoutError):
            waiting.result(0.2)
        plain = numba.njit(loop)
        plain.compile(types)
        one._cache.save_overload(types, plain.overloads[types])
        assert waiting.result(30) is not None


def _halved(x: float) -> float:
    return x / 2


def test_a_loop_is_compiled_again_after_a_change_of_what_it_calls_in_another_file(
    tmp_path: Path,
) -> None:
    folder = tmp_path / "core" / "kernels"
    folder.mkdir(parents=True)
    for empty in (folder, folder.parent):
        (empty / "__init__.py").touch()
    shutil.copy(kernels.compiled.__file__, folder)
    loop = "from core.kernels.compiled import compiled\n{}@compiled\ndef {}():\n    return {}\n"
    (folder / "outer.py").write_text(
        loop.format("from core.kernels.inner import inner\n", "outer", "inner()")
    )
    # ``-B``: Python's own cache goes by whole seconds.
    call = [sys.executable, "-B", "-c", "from core.kernels.outer import outer; print(outer())"]
    for number in ("1", "2"):
        (folder / "inner.py").write_text(loop.format("", "inner", number))
        output = subprocess.run(call, cwd=tmp_path, capture_output=True, text=True, check=True)
        assert output.stdout.strip() == number


@pytest.mark.parametrize("suffix", [".nbi", ".nbc"])
def test_a_compiled_loop_whose_file_is_damaged_is_compiled_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, suffix: str
) -> None:
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    assert compiled(_halved)(3.0) == 1.5
    (kept,) = tmp_path.rglob(f"*{suffix}")
    whole = kept.read_bytes()
    for damaged in (b"", whole[: len(whole) // 2]):
        kept.write_bytes(damaged)
        assert compiled(_halved)(3.0) == 1.5
        assert len(kept.read_bytes()) == len(whole)


def test_a_loop_runs_where_its_code_can_not_be_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path))
    with monkeypatch.context() as patched:
        patched.setattr(IndexDataCacheFile, "save", full)
        assert compiled(_halved)(3.0) == 1.5
    # Neither next to the sources nor in the user's folder.
    monkeypatch.setattr(FunctionCache._impl_class, "_locator_classes", [])
    assert compiled(_halved)(3.0) == 1.5
