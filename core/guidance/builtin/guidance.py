"""The built-in prior as a guidance: two small diffusion models that travel with the project.

The geometry network paints object-frame normals, the appearance network paints colours onto given
normals. Both work on pictures of 64² without an autoencoder: the latent is the picture.
"""

import warnings
from dataclasses import replace

import torch
from jaxtyping import Float, Int
from safetensors import SafetensorError
from torch import Tensor

from core.appearance.material_ranges import MaterialRanges
from core.device import has_fast_bfloat16
from core.geometry.init_shape import Shape
from core.geometry.mesh import Mesh
from core.geometry.parts.assembly import KnownParts
from core.guidance.builtin.areas import AreaFields, SolidAreas
from core.guidance.builtin.bent import bent
from core.guidance.builtin.composition.appendages.appendage import solids_of
from core.guidance.builtin.composition.composed import Composed
from core.guidance.builtin.composition.placing.wearing import freed
from core.guidance.builtin.constructed.solid import ConstructedSolid, solid_of_parts
from core.guidance.builtin.constructed.things import constructed
from core.guidance.builtin.counted_solid import CountedSolid
from core.guidance.builtin.diffusion import alpha_bar_schedule
from core.guidance.builtin.hint import HINT_SLOTS, hint
from core.guidance.builtin.markings.markings import (
    is_marking,
)
from core.guidance.builtin.network import BLOCK, UNet, camera_map
from core.guidance.builtin.nouns import CONSTRUCTED, row_of, solid_of
from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.offered import (
    NETWORKS,
    PARTS,
    RESTORER,
    SOLID,
    WEIGHTS,
    offered_words,
    weights_error,
)
from core.guidance.builtin.painted_solid import (
    PaintedSolid,
    bears,
    stated_sizes,
    uncounted_of,
    uncut,
    unsized,
)
from core.guidance.builtin.palette import FINISHES, looks, painted
from core.guidance.builtin.part_map import PARTS as PART_COUNT
from core.guidance.builtin.part_map import known_part_map, part_map
from core.guidance.builtin.restore import as_render, restored
from core.guidance.builtin.solid import FORMS, Solid, load_solid_net
from core.guidance.builtin.solid_net import SolidNet
from core.guidance.builtin.stretch import known_wider
from core.guidance.builtin.surfaces import surfaces_of
from core.guidance.builtin.weights import load_weights
from core.guidance.builtin.words.companions.bouquets import in_bunch
from core.guidance.builtin.words.companions.glassware import glazed
from core.guidance.builtin.words.grammar.lexicon import SLOTS, Vocabulary
from core.guidance.builtin.words.phrases.poses import FOUR_LEGGED
from core.guidance.builtin.words.phrases.slots import GEOMETRY_SLOTS, Words
from core.guidance.builtin.words.vocabulary import parse
from core.guidance.guidance import (
    Guidance,
    NormalFrame,
    Predictions,
    PromptedGuidance,
    PromptWarning,
    Surface,
    Views,
    coarse_latent,
)
from core.guidance.sds import eps_from_v

FOLDED = ("sitting", "lying", "sleeping")  # poses of animals
SIZE = 64
COUNTED = 4  # drawings at most, until its parts are as many as stated
NO_PICTURES = "no network has learnt its pictures: they are those of no thing in particular."
NOT_DRAWN_ON = (
    "left out, as text, emblems and moods are drawn only on what the built-in prior draws itself, "
    "not on your mesh or a distilled shape."
)


class BuiltinGuidance(Guidance):
    """The built-in networks, and the words that they know."""

    normal_frame: NormalFrame = "object"
    latent_size = SIZE

    def __init__(
        self,
        geometry: UNet,
        appearance: UNet,
        known: Vocabulary = SLOTS,
        ignore_unknown: bool = False,
        *,
        parts: UNet | None = None,
        restorer: UNet | None = None,
        solid: SolidNet | None = None,
    ) -> None:
        self.geometry, self.appearance = geometry, appearance
        self.parts, self.restorer, self.solid = parts, restorer, solid
        self.known, self.ignore_unknown = known, ignore_unknown
        self.device = next(geometry.parameters()).device
        self.alpha_bar = alpha_bar_schedule().to(self.device)
        self.half = has_fast_bfloat16(self.device)

    def prompted(self, prompt: str, negative_prompt: str) -> "PromptedBuiltin | Composed":
        """Raises ``UserError`` for words that are not in the vocabulary, unless they are ignored.

        Warns, as ``PromptWarning``, of what was read as another word or left out.
        """
        options = {"known": self.known, "ignore_unknown": self.ignore_unknown}
        words = parse(prompt, **options)
        negative = parse(negative_prompt, noun_needed=False, **options)
        for note in (*words.notes, *negative.notes):
            warnings.warn(note, PromptWarning, stacklevel=2)
        alone = PromptedBuiltin(self, words, negative)
        if not words.companions and words.count == 1 and not words.pose:
            return alone
        pairs = [(one.relation, one.words) for one in words.companions]
        each = [freed(words, pairs), *(other for _, other in pairs)]
        hows = [how for how, _ in pairs]
        within = [False, *(how == "in" for how in hows)]
        each = [glazed(one, hows, here) for one, here in zip(each, within, strict=True)]
        things = [PromptedBuiltin(self, in_bunch(one), negative) for one in each]
        return Composed(self, alone, things, [how for how, _ in pairs])

    def encode_normals(
        self, n: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """[n * o, 2o - 1], area-downsampled."""
        return coarse_latent(n, o, SIZE)

    def encode_color(
        self, srgb: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """[(2 srgb - 1) * o, 2o - 1], area-downsampled; ``srgb`` comes weighted by coverage."""
        return coarse_latent(2 * srgb - o, o, SIZE)


def is_constructed(words: Words) -> bool:
    """Whether it is put together of simple solids. An animal whose legs are folded is not, where a
    network draws it too: that one's legs are short enough to be folded."""
    folded = words.pose in FOLDED and row_of(words.noun) and words.noun in FOUR_LEGGED
    return words.noun in CONSTRUCTED and not folded


class PromptedBuiltin(PromptedGuidance):
    """ε̂ of the built-in networks for one prompt.

    The unconditional branch has the negative prompt's words, or none, and keeps the camera, so
    that guidance pulls towards the word and not towards having a camera.
    """

    def __init__(
        self,
        guidance: BuiltinGuidance,
        words: Words,
        negative: Words,
        solid: Solid | None = None,
        whole: bool = True,
    ) -> None:
        """``solid``: the drawn object, with known parts; ``whole``: of which it is put together."""
        super().__init__(guidance)
        self.builtin, self.words, self.negative, self.solid = guidance, words, negative, solid
        self.painted = solid and PaintedSolid(words, solid, whole)

    def ranges(self) -> MaterialRanges:
        """The roughness and metallic that the words' parts are painted with, and a little around.

        At 64² a rough metal and a dark plastic look the same; the words distinguish them.
        """
        # Over all parts, as their places are not known.
        parts = list(painted(self.words.noun, self.words)) if self.words.noun else []
        named = [part for part in parts if part.material] if self.words.material else parts
        finishes = [part.finish for part in named] or [FINISHES[self.words.material]]
        rough, metal = ([getattr(f, n) for f in finishes] for n in ("roughness", "metallic"))
        return MaterialRanges(
            (max(min(rough) - 0.15, 0.05), min(max(rough) + 0.1, 0.95)),
            (max(min(metal) - 0.02, 0.0), min(max(metal) + 0.02, 1.0)),
        )

    def surfaces(self) -> tuple[Surface, ...]:
        """The surface of each part, by the words or by nature."""
        return surfaces_of(self.words)

    def of_object(self, seed: int, whole: bool = True) -> "PromptedBuiltin":
        """An object drawn by the solids' network, then stretched for the shape's adjective."""
        net, words = self.builtin.solid, self.words
        if net is None or not words.noun:
            return self
        if is_constructed(words):
            own = solids_of(words.noun) if words.noun in APPENDAGES else None
            solid = solid_of_parts(words, net, own) if own else constructed(words, net, seed)
            solid = solid.sized(stated_sizes(words)) if whole else solid
            return PromptedBuiltin(self.builtin, words, self.negative, solid, whole)
        formed = (words.noun, words.shape) in FORMS
        asked = words if formed else replace(words, shape="")
        rows = torch.tensor([asked.indices(GEOMETRY_SLOTS)], device=self.builtin.device)
        parts = list(looks(words.noun))
        gone = {part for part in words.absent if not bears(words, part)}
        gone |= {part for part in parts if is_marking(words.noun, part)}
        absent = [k for k, part in enumerate(parts) if part in gone]
        absent += range(len(parts), len(looks(solid_of(words.noun))))
        generator, found = torch.Generator().manual_seed(seed), []
        for _ in range(COUNTED if words.part_counts and whole else 1):
            solid = Solid.drawn(net, rows, generator, tuple(absent), words.kinds)
            solid = solid.placed("" if formed else words.shape, known_wider(solid_of(words.noun)))
            painted = PaintedSolid(words, solid, whole)
            found.append(painted.counted() if whole else painted)
            if not any(found[-1].uncounted()):
                break
        solid = min(found, key=lambda one: len(list(one.uncounted()))).fitting().solid
        return PromptedBuiltin(self.builtin, words, self.negative, solid, whole)

    def with_solid(self, solid: Solid) -> "PromptedBuiltin":
        """The same with another solid, such as a shirt cut to its wearer."""
        return PromptedBuiltin(self.builtin, self.words, self.negative, solid)

    def in_proportion(self, guide: Mesh, strength: float, least: float) -> "PromptedBuiltin":
        """With the drawn solid stretched and bent."""
        solid, parts = self.solid, self.parts()
        if solid is None or parts is None or isinstance(solid, ConstructedSolid):
            return self
        if isinstance(solid, CountedSolid):  # a guide has its own number of them
            solid = solid.drawn_alone()
        made = bent(solid, parts.forms.flat, guide, strength, least)
        return PromptedBuiltin(self.builtin, self.words, self.negative, made, whole=False)

    def start_shape(self) -> Shape | None:
        """The drawn solid."""
        return self.solid and self.solid.shape()

    def areas(self) -> SolidAreas | None:
        """The drawn solid's parts, each in the colours of its pattern."""
        fields = self.area_fields()
        return fields and SolidAreas(fields.drawn, fields.each, fields.near, fields.heights)

    def area_fields(self) -> AreaFields | None:
        """Those areas in space, with their properties."""
        return self.painted and self.painted.area_fields(self._axes)

    def style(self) -> str:
        """The words' own."""
        return self.words.style

    def left_out(self) -> tuple[str, ...]:
        """A note on each emblem and each mood that is left out (on the user's mesh, on a distilled
        shape, or without room on the thing), on each part that stays, and on each that keeps its
        size."""
        if self.painted is None:
            drawn = (*map(str, self.words.emblems), *filter(None, [self.words.mood]))
            notes = (f"{one}: {NOT_DRAWN_ON}" for one in drawn)
            unmade = (*unsized(self.words), *uncounted_of(self.words), *uncut(self.words))
            noun = self.words.noun
            unknown = (f"{noun}: {NO_PICTURES}",) if noun and not row_of(noun) else ()
            return (*notes, *unmade, *unknown)
        return self.painted.left_out()

    def parts(self) -> KnownParts | None:
        """The parts of the drawn solid."""
        return self.painted and self.painted.made

    @property
    def _axes(self) -> tuple[int, ...]:
        """For each part of the drawn solid, the axis along which stripes follow one another; none
        where the negative prompt names another thing."""
        return () if self.painted is None or self.negative.noun else self.painted.axes

    @torch.no_grad()
    def restore(
        self, pictures: Float[Tensor, "b 4 s s"], views: Views
    ) -> Float[Tensor, "b 4 s s"] | None:
        """Geometry pictures from the restorer; None without one."""
        net = self.builtin.restorer
        # It was trained on geometry pictures alone, and a given surface means colours.
        if net is None or views.surface is not None:
            return None
        # Only the prompt's row: restoring has no unconditional branch.
        words = self._indices(GEOMETRY_SLOTS)[:1]
        # A word newer than its training is not stated: one training object in ten had no words.
        words = words * (words <= words.new_tensor(net.config.words))
        words = words.expand(len(pictures), -1)
        camera = camera_map(views.cameras.to(words.device), SIZE // BLOCK)
        with torch.autocast(words.device.type, torch.bfloat16, enabled=self.builtin.half):
            return as_render(restored(net, pictures, words, camera))

    @torch.no_grad()
    def predict(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        views: Views,
        *,
        cond_only: bool = False,
        apart: bool = False,
    ) -> Predictions:
        """Both branches in one batch, always: the size of a batch changes the last bits of its
        rows, and a run repeats to the bit. With ``views.surface`` the appearance network predicts.
        """
        del cond_only
        paints = views.surface is not None
        net = self.builtin.appearance if paints else self.builtin.geometry
        words = self._indices(HINT_SLOTS if paints else GEOMETRY_SLOTS, apart)
        branches = len(words)
        words = words.repeat_interleave(len(z_t), 0)
        # All branches get the camera and the surface; only their words differ.
        camera = camera_map(views.cameras.to(words.device), SIZE // BLOCK)
        camera, all_z, t = (
            camera.repeat(branches, 1, 1, 1),
            z_t.repeat(branches, 1, 1, 1),
            t.repeat(branches),
        )
        given = None  # the hint, of the appearance network alone
        if views.surface is not None:
            surface = torch.nn.functional.adaptive_avg_pool2d(views.surface, SIZE)
            stated = [one for one in self._branches(HINT_SLOTS, apart) for _ in range(len(z_t))]
            parts = self._parts(surface, words[:, 0], camera)
            surface = surface.repeat(branches, 1, 1, 1)
            given = hint(surface, parts, words, stated, self._axes)
        with torch.autocast(words.device.type, torch.bfloat16, enabled=self.builtin.half):
            # Back to 32 bit at once: the gradient is a small difference of predictions.
            v = net(all_z, t, words[:, : len(net.config.words)], camera, given).float()
        cond, uncond, *negative = eps_from_v(v, all_z, self.alpha_bar[t]).chunk(branches)
        return Predictions(cond, uncond, negative=negative[0] if negative else None)

    def _parts(
        self, surface: Float[Tensor, "b 7 s s"], nouns: Int[Tensor, " n"], camera: Tensor
    ) -> Float[Tensor, "n 8 s s"]:
        """The part at each place of the views' ``surface``, for each branch's ``nouns``."""
        branches = len(nouns) // len(surface)
        if self.builtin.parts is None:  # no place has a stated colour then
            return surface.new_zeros(len(nouns), PART_COUNT, SIZE, SIZE)
        if self.painted is not None and not self.negative.noun:
            # The branch without words has no parts.
            known = known_part_map(self.painted.shown, surface)
            return known.repeat(branches, 1, 1, 1) * (nouns > 0)[:, None, None, None]
        surface = surface.repeat(branches, 1, 1, 1)
        with torch.autocast(nouns.device.type, torch.bfloat16, enabled=self.builtin.half):
            return part_map(self.builtin.parts, surface, nouns, camera)

    def _indices(self, slots: tuple[str, ...], apart: bool = False) -> Int[Tensor, "_k n"]:
        """The rows of the prompt's words and of the negative prompt's, by slot.

        ``apart``: a row of no words between the two; without a negative prompt it is the last.
        """
        rows = [words.indices(slots) for words in self._branches(slots, apart)]
        return torch.tensor(rows, device=self.builtin.device)

    def _branches(self, slots: tuple[str, ...], apart: bool) -> list[Words]:
        none = apart and self.negative.indices(slots) != Words().indices(slots)
        return [self.words, *([Words()] if none else []), self.negative]


def load_builtin(device: "torch.device | str", *, ignore_unknown: bool = False) -> BuiltinGuidance:
    """The shipped networks on ``device``; ``ignore_unknown`` leaves out words that are unknown.

    Raises ``MissingError`` when the weights are not there or broken.
    """
    nets = {}
    for name in (*NETWORKS, PARTS, SOLID, RESTORER):
        if name == RESTORER and not (WEIGHTS / f"{name}.safetensors").exists():
            continue  # refining then denoises
        path = WEIGHTS / f"{name}.safetensors"
        try:
            load = load_solid_net if name == SOLID else load_weights
            nets[name] = load(path).to(device)
        except (FileNotFoundError, SafetensorError, ValueError) as error:
            raise weights_error(path, error) from error
    first = (nets[name] for name in NETWORKS)
    words = {"known": offered_words(), "ignore_unknown": ignore_unknown}
    more = {"parts": nets[PARTS], "restorer": nets.get(RESTORER), "solid": nets[SOLID]}
    return BuiltinGuidance(*first, **words, **more)
