"""Real models in the training set: read from a furniture catalogue, drawn as the families are."""

import zipfile

import pytest
import torch

from core.camera import Cameras
from core.errors import UserError
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import NORMAL_RADIUS
from core.geometry.tet_grid import tet_grid
from core.prior.__main__ import main
from core.prior.data import MODEL_VIEWS, NOUNS, SIZE, read_shards, write_shard
from core.prior.draw import Draw
from core.prior.families import build
from core.prior.models import CATALOGUE, FACTS, MODELS, VIEWS, catalogue_models, render_mesh
from core.prior.sources import Appearance, Geometry
from core.prior.tracer import render

# A wedge, +Y up: a floor, and a back wall at z = -1 that is 4 high. Its front is open.
WEDGE = """v -1 0 1
v 1 0 1
v 1 0 -1
v -1 0 -1
v -1 4 -1
v 1 4 -1
f 1 2 3 4
f 3 4 5 6
"""
FACTS_TEXT = r"""# a comment
id=Somebody#Models
name=Some caf\u00e9 models
id#2=Somebody#stool2
name#2=Stool
model#2=/folder/stool 2/stool2.obj
id#1=Somebody#oakChair
name#1=Oak chair
model#1=/folder/oakChair.obj
id#3=Somebody#footballTable
name#3=Football table
model#3=/folder/missing.obj
"""


@pytest.fixture
def catalogue(tmp_path):
    path = tmp_path / "Some models.sh3f"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr(FACTS, FACTS_TEXT.encode("latin-1"))
        archive.writestr("folder/stool 2/stool2.obj", WEDGE)
        archive.writestr("folder/oakChair.obj", WEDGE)
    return path


def test_the_models_of_known_nouns_are_upright_and_face_the_front(catalogue):
    (chair, verts, faces), (stool, _, _) = catalogue_models(catalogue)
    assert (chair, stool) == ("chair", "stool")
    assert verts.norm(dim=1).max().item() == pytest.approx(NORMAL_RADIUS, rel=1e-5)
    torch.testing.assert_close(verts.amin(0) + verts.amax(0), torch.zeros(3))
    assert len(faces) == 4
    upper = verts[verts[:, 2] > 0]
    assert len(upper) == 2
    assert (upper[:, 1] > 0).all()  # the wall is behind: the front looks to -Y


def test_every_noun_of_the_models_is_known():
    assert set(MODELS) <= set(NOUNS)
    models = [model for models in MODELS.values() for model in models.split(", ")]
    assert len(set(models)) == len(models)


@pytest.mark.parametrize("content", [b"", b"no zip", None])
def test_what_is_no_catalogue_is_refused_with_the_way_to_get_one(tmp_path, content):
    path = tmp_path / "broken.sh3f"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(UserError, match="not a furniture catalogue") as error:
        list(catalogue_models(path))
    assert "apt install" in str(error.value)


def test_a_zip_without_the_facts_is_refused(tmp_path):
    with zipfile.ZipFile(tmp_path / "other.sh3f", "w") as archive:
        archive.writestr("readme.txt", "nothing")
    with pytest.raises(UserError, match="not a furniture catalogue"):
        list(catalogue_models(tmp_path / "other.sh3f"))


def test_a_mesh_is_drawn_as_its_family_is_traced_however_its_faces_are_wound():
    shape = build("mug", "", Draw(torch.Generator().manual_seed(0)))
    cameras = Cameras.orbit([25.0, 130.0, 260.0], [20.0, -50.0, 60.0], 2.95)
    grid = tet_grid(48)
    verts, faces = marching_tets(grid.tet_verts, shape.sdf(grid.tet_verts), grid)
    faces[::2] = faces[::2].flip(1)
    drawn, traced = render_mesh(verts, faces, cameras), render(shape, cameras, SIZE)
    both = torch.minimum(drawn.coverage, traced.coverage).sum()
    assert both / torch.maximum(drawn.coverage, traced.coverage).sum() > 0.95
    inside = ((drawn.coverage > 0.99) & (traced.coverage > 0.99))[:, 0]
    assert (drawn.normal * traced.normal).sum(1)[inside].mean() > 0.93  # flat faces
    far = (drawn.point - traced.point).permute(0, 2, 3, 1)[inside].norm(dim=1)
    assert far.median() < 0.02
    assert ((drawn.part == 0) == (drawn.coverage[:, 0] > 0)).all()


def test_an_open_face_is_seen_from_both_sides():
    verts = torch.tensor([[-0.5, 0.0, -0.5], [0.5, 0.0, -0.5], [0.0, 0.0, 0.5]])
    seen = render_mesh(verts, torch.tensor([[0, 1, 2]]), Cameras.orbit([0.0, 180.0], [0.0]))
    assert (seen.coverage.flatten(1).sum(1) > 50).all()
    y = seen.normal[:, 1].flatten(1)
    assert y[0].min().item() == pytest.approx(-1)
    assert y[1].max().item() == pytest.approx(1)


def test_the_data_command_draws_the_models_for_the_geometry_alone(catalogue, tmp_path, capsys):
    folder = tmp_path / "data"
    main(["data", "--shards", "0", "--out", str(folder), "--catalogue", str(catalogue)])
    samples = read_shards([folder / MODEL_VIEWS])
    assert len(samples) == 2 * VIEWS
    assert samples.noun.unique().tolist() == sorted([NOUNS.index("chair"), NOUNS.index("stool")])
    assert (samples.pictures()[:, 3].amax((1, 2)) == 1).all()
    write_shard(folder, 7, objects=1)
    assert len(Geometry(folder).samples) == len(samples) + 4
    assert len(Appearance(folder).samples) == 4
    capsys.readouterr()
    main(["data", "--shards", "0", "--out", str(folder), "--catalogue", str(tmp_path / "none")])
    assert MODEL_VIEWS in capsys.readouterr().out  # made before, so it is not asked for again


def test_the_data_of_some_nouns_has_their_models_alone(catalogue, tmp_path):
    made = ["data", "--shards", "0", "--catalogue", str(catalogue), "--nouns"]
    main([*made, "stool", "--out", str(tmp_path / "stool")])
    assert set(read_shards([tmp_path / "stool" / MODEL_VIEWS]).noun.tolist()) == {
        NOUNS.index("stool")
    }
    main([*made, "penguin", "--out", str(tmp_path / "penguin")])
    assert not (tmp_path / "penguin" / MODEL_VIEWS).exists()


def test_without_the_catalogue_the_data_command_reports_how_to_get_it(tmp_path, capsys):
    missing = str(tmp_path / "none.sh3f")
    main(["data", "--shards", "0", "--out", str(tmp_path), "--catalogue", missing])
    assert "apt install sweethome3d-furniture" in capsys.readouterr().err


@pytest.mark.skipif(not CATALOGUE.exists(), reason="Debian's sweethome3d-furniture is not there")
def test_the_packaged_catalogue_has_every_model_of_the_table():
    assert sorted(noun for noun, _, _ in catalogue_models(CATALOGUE)) == sorted(
        noun for noun, models in MODELS.items() for _ in models.split(", ")
    )
