"""Real models in the training set: the furniture catalogue that Debian packages.

``apt install sweethome3d-furniture`` puts ``CATALOGUE`` in place: 175 models under CC0 1.0, of
which ``MODELS`` lists the ones that show a noun of the prior. The package's other catalogues are
under CC-BY and are not read. Nothing of it is copied into the project.

A catalogue of Sweet Home 3D (``.sh3f``) is a zip of OBJ files, +Y up and looking along +Z, and a
Java properties file with an entry ``key#number=value`` for each model's facts.
"""

import re
import tempfile
import zipfile
from collections.abc import Iterator, Sequence
from pathlib import Path

import torch
from jaxtyping import Float, Int
from torch import Tensor
from torch.nn.functional import avg_pool2d

from core.camera import Cameras, sample_cameras
from core.errors import UserError
from core.geometry.mesh import normalise
from core.io.mesh_file import load_mesh
from core.ops import dot, normalize
from core.prior.data import CAMERAS, NOUNS, SIZE, Samples, joined
from core.prior.draw import Draw
from core.prior.tracer import Pictures
from core.render.normals import face_normals
from core.render.rasterizer import interpolate, rasterize, scatter

CATALOGUE = Path("/usr/share/sweethome3d/furniture/BlendSwap-CC-0.sh3f")
INSTALL = "Install it with: apt install sweethome3d-furniture"
FACTS = "PluginFurnitureCatalog.properties"
VIEWS = 12  # views of one model: few, because their legs are finer than 64² can show
SEED = 100_000  # beyond the shards' seeds
JITTER = 0.06  # of the size, as in the families

# The catalogue's models by their names in its ids, without models that have a noun's name but not
# its look: a desk that is a whole workplace, stools with backs, a folded chair, a chandelier.
MODELS = {
    "armchair": "armchair, armchair2, modernArmchair, winchesterArmchair",
    "bed": "bed1, bed2, bed3, bedWithTexture",
    "bench": "bench, pianoBench",
    "bookshelf": "shelves, verticalShelves",
    "bottle": "mamadeira, yogurtBottle",
    "cactus": "cactus",
    "chair": "antiqueChair, chair, chair2, chairWithCushion, designChair, oakChair, osakaChair, "
    "plasticChair, sillaBlanca, thonet",
    "cupcake": "cupcake",
    "electric guitar": "electricGuitar",
    "lamp": "desklamp",
    "mug": "caffe_final",
    "sofa": "couch, sofa2, winchesterSofa",
    "stool": "stool2",
    "table": "lbDesk, oakTable, table, tableWithTablecloth, technicalTable1, technicalTable2",
    "teddy bear": "teddyBear",
    "truck": "peterbilt",
}
NOUN_OF = {model: noun for noun, models in MODELS.items() for model in models.split(", ")}


def catalogue_models(path: Path) -> Iterator[tuple[str, Tensor, Tensor]]:
    """(noun, vertices, faces) of the catalogue's models that MODELS names, normalised, +Z up.

    Raises UserError for a file that is not such a catalogue.
    """
    try:
        archive = zipfile.ZipFile(path)
        facts = _facts(archive.read(FACTS).decode("latin-1"))
    except (OSError, KeyError, zipfile.BadZipFile) as error:
        raise UserError(f"{path} is not a furniture catalogue: {error}.", INSTALL) from error
    with archive, tempfile.TemporaryDirectory() as folder:
        for fact in facts:
            noun = NOUN_OF.get(fact["id"].rpartition("#")[2])
            if noun:
                mesh = load_mesh(archive.extract(fact["model"].lstrip("/"), folder))
                yield noun, normalise(mesh.verts)[0], mesh.faces


def _facts(text: str) -> list[dict[str, str]]:
    """The facts of each model, in the order of the numbers after the keys."""
    facts: dict[int, dict[str, str]] = {}
    for key, number, value in re.findall(r"^(\w+)#(\d+)=(.*?)\s*$", text, re.MULTILINE):
        facts.setdefault(int(number), {})[key] = value
    return [facts[number] for number in sorted(facts)]


def make_models(
    path: Path, views: int = VIEWS, seed: int = SEED, nouns: Sequence[str] = NOUNS
) -> Samples | None:
    """``views`` views of each model of ``nouns`` in the catalogue, or None if it has none; all
    visible pixels are part 0."""
    draw = Draw(torch.Generator().manual_seed(seed))
    rows = []
    for noun, verts, faces in catalogue_models(path):
        if noun not in nouns:
            continue
        cameras = sample_cameras(views, CAMERAS, draw.generator)
        seen = render_mesh(verts * draw(1 - JITTER, 1 + JITTER), faces, cameras, SIZE)
        rows.append(Samples.of(seen, cameras, NOUNS.index(noun)))
    return joined(rows) if rows else None


def render_mesh(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    cameras: Cameras,
    size: int = SIZE,
    samples: int = 2,
) -> Pictures:
    """A mesh's pictures as :func:`core.prior.tracer.render` makes a family's.

    The mesh may be open and its faces may be wound either way: each is visible from both sides,
    with its normal turned to the camera.
    """
    flat = normalize(face_normals(verts, faces), eps=1e-30)
    fragments = rasterize(verts, faces, cameras.mvp, size * samples, size * samples, cull=False)
    points = interpolate(verts, fragments)
    normal = flat[fragments.face]
    outwards = dot(normal, cameras.eye[fragments.view] - points) >= 0
    normal = torch.where(outwards, normal, -normal)
    buffer = scatter(torch.cat([normal, torch.ones_like(normal[:, :1]), points], 1), fragments)
    mean = avg_pool2d(buffer.permute(0, 3, 1, 2), samples)
    coverage = mean[:, 3:4]
    part = torch.where(coverage[:, 0] > 0, 0, -1)
    return Pictures(mean[:, :3], coverage, part, mean[:, 4:] / coverage.clamp_min(1e-6))
