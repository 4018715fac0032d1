"""The interface between the trainings and a diffusion model.

A ``Guidance`` turns renders into latents and reads a prompt. What it returns for one, a
``PromptedGuidance``, predicts the noise in a diffused latent: ε̂_φ(z_t; y, t) of Eqs. 1, 5 and 9.
It is all that the trainings know of the model and of the words.

Pictures arrive as the renderer gives them, over black: ``n`` and ``srgb`` are zero where the
coverage ``o`` is, and already weighted by it at the silhouette. A guidance that wants another
background adds ``(1 - o) * background`` itself.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Literal, NamedTuple, Protocol, runtime_checkable

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.appearance.material_ranges import MaterialRanges
from core.camera import Cameras
from core.geometry.init_shape import Shape
from core.geometry.mesh import Mesh
from core.geometry.parts.assembly import KnownParts

NormalFrame = Literal["object", "camera"]


class PromptWarning(UserWarning):
    """A part of a prompt was read as something else or left out; the message names it."""


@dataclass(frozen=True)
class Views:
    """What a guidance may know about a batch of pictures."""

    cameras: Cameras
    # [n, 2o - 1, p]: object-frame normals, coverage, and points weighted by coverage, of the same
    # views. The appearance training gives it to a guidance that can use it. None: not given.
    surface: Float[Tensor, "b 7 h w"] | None = None

    def __getitem__(self, index: "slice | Tensor") -> "Views":
        """The views of a part of the batch."""
        surface = None if self.surface is None else self.surface[index]
        return Views(self.cameras[index], surface)

    def __len__(self) -> int:
        return len(self.cameras)


class Surface(NamedTuple):
    """The substance of a part of the object, for the detail of its maps."""

    kind: str  # one of core.texture.detail.kinds
    color: tuple[float, float, float]  # sRGB, by which the part is found among the others
    # For a kind that the model knows by another name: the base colour's factor, linear, and what is
    # added to roughness and metallic.
    factor: tuple[float, float, float] = (1.0, 1.0, 1.0)
    roughness: float = 0.0
    metallic: float = 0.0
    weather: tuple[str, ...] = ()  # of core.texture.detail.weather, the lowest first
    glow: float = 0.0  # how much of its colour it emits, in [0, 1]
    clear: float = 0.0  # transmitted fraction of the light that is not reflected, in [0, 1]
    depth: float = 1.0  # of the kind's light and dark in the base colour: 0 is none


class Predictions(NamedTuple):
    """ε̂_φ(z_t; y, t) for each text y, not yet combined (``core.guidance.sds.guided``)."""

    cond: Float[Tensor, "b 4 s s"]  # the prompt
    uncond: Float[Tensor, "b 4 s s"] | None = None  # no words, or the negative prompt's instead
    # Perp-Neg: the prompt from k other sides, and how strongly to steer each picture away from it.
    opposing: Float[Tensor, "k b 4 s s"] | None = None
    opposing_weight: Float[Tensor, "k b"] | None = None
    # Only where asked for (``apart``): the negative prompt's; ``uncond`` is then that of no words.
    negative: Float[Tensor, "b 4 s s"] | None = None


class Work(NamedTuple):
    """Floating-point operations for one view."""

    prediction: float  # guided: of all its texts
    encoding: float  # with its gradient


class Guidance(ABC):
    """A diffusion model over latents (B, 4, ``latent_size``, ``latent_size``)."""

    alpha_bar: Float[
        Tensor, " t"
    ]  # the schedule; z_t = sqrt(alpha_bar) z + sqrt(1 - alpha_bar) eps
    latent_size: int
    normal_frame: NormalFrame  # the axes in which it wants its normals
    # Views that it predicts together: a batch then holds whole groups with evenly spaced azimuths.
    views_together: int = 1
    busy_bytes: int = 0  # memory of a prediction or an encoding, where it is much

    def work(self) -> Work | None:
        """The work for one view where it is worth a notice; None: little."""
        return None

    @abstractmethod
    def prompted(self, prompt: str, negative_prompt: str) -> "PromptedGuidance":
        """Read the two prompts once, before the training.

        Raises:
            UserError: what it cannot read, and what to write instead.
        """

    @abstractmethod
    def encode_normals(
        self, n: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """The latent of a normal picture (fine geometry), differentiable.

        Args:
            n: normals in ``normal_frame``, in [-1, 1], weighted by coverage (zero outside).
            o: coverage in [0, 1].
        """

    @abstractmethod
    def encode_color(
        self, srgb: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """The latent of a shaded picture (appearance), differentiable.

        Args:
            srgb: sRGB-encoded colour in [0, 1] over black (zero outside).
            o: coverage in [0, 1].
        """


class Area(NamedTuple):
    """The properties of an area of an object."""

    plain: bool  # no more than one colour
    ranges: MaterialRanges
    surface: Surface
    level: bool = True  # no part of it stands out of the shape or is sunk


@runtime_checkable
class Areas(Protocol):
    """The areas of an object, each of one colour and one substance."""

    each: tuple[Area, ...]

    def of(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """The area of each place of the surface, training units."""
        ...

    def certain(
        self, points: Float[Tensor, "n 3"], reach: float
    ) -> tuple[Int[Tensor, " n"], Bool[Tensor, " n"]]:
        """The area of each place of the surface, and whether all within ``reach`` have the same."""
        ...

    def inside(self, points: Float[Tensor, "n 3"], area: Int[Tensor, " n"]) -> Float[Tensor, "n 3"]:
        """The place from which each place of an area takes its material: farther inside the area
        near a border."""
        ...

    def slope(
        self,
        points: Float[Tensor, "n 3"],
        normals: Float[Tensor, "n 3"],
        area: Int[Tensor, " n"],
        step: float,
    ) -> Float[Tensor, "n 3"]:
        """The gradient along the surface of its height at places of the areas, such as around a
        pane in a frame; over ``step``, training units."""
        ...

    def nearest(self) -> Int[Tensor, "k k k"]:
        """The area of each node of a lattice over the training's cube, by x, y and z."""
        ...


class PromptedGuidance(ABC):
    """A guidance with its prompts, as the trainings use it. The schedule, the latents and their
    encoders are the guidance's own."""

    views_together: int = 1
    busy_bytes: int = 0

    def __init__(self, guidance: Guidance) -> None:
        self._guidance = guidance
        self.alpha_bar = guidance.alpha_bar
        self.latent_size = guidance.latent_size
        self.normal_frame: NormalFrame = guidance.normal_frame
        self.views_together = guidance.views_together
        self.busy_bytes = guidance.busy_bytes

    def encode_normals(
        self, n: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """See ``Guidance.encode_normals``."""
        return self._guidance.encode_normals(n, o)

    def encode_color(
        self, srgb: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """See ``Guidance.encode_color``."""
        return self._guidance.encode_color(srgb, o)

    def ranges(self) -> MaterialRanges | None:
        """The material ranges that the words state; None where they leave all open."""
        return None

    def surfaces(self) -> tuple[Surface, ...]:
        """The substances of the parts by the words and by nature; none where the model paints its
        own detail."""
        return ()

    def restore(
        self, pictures: Float[Tensor, "b 4 s s"], views: Views
    ) -> Float[Tensor, "b 4 s s"] | None:
        """The latents of a shape's own renders, made crisp, without gradient; None without such a
        network."""
        del pictures, views
        return None

    def of_object(self, seed: int, whole: bool = True) -> "PromptedGuidance":
        """The guidance of one object of the prompt, drawn by ``seed``; itself where it knows
        pictures alone.

        ``whole``: with the things that the prompt wants together with it, such as its support.
        """
        del seed, whole
        return self

    def in_proportion(self, guide: Mesh, strength: float, least: float) -> "PromptedGuidance":
        """The guidance of that object in the proportions of ``guide``; itself without a drawn
        object.

        ``least``: half of the thickness that thin parts of the guide get, training units.
        """
        del guide, strength, least
        return self

    def start_shape(self) -> Shape | None:
        """The solid of that object, for Ψ to start from; None without one."""
        return None

    def size_m(self) -> float | None:
        """The longest side of that object in metres; None: only the prompt's words state it."""
        return None

    def areas(self) -> Areas | None:
        """The areas of that object; None without known parts."""
        return None

    def style(self) -> str:
        """The style that the prompt wants of the shape, as the setting geometry.style names it; "":
        none, or the pictures have it."""
        return ""

    def left_out(self) -> tuple[str, ...]:
        """A note on each thing that the prompt wants of the object and that is left out."""
        return ()

    def parts(self) -> KnownParts | None:
        """The parts of that object, each a solid of its own; None: unknown."""
        return None

    @abstractmethod
    def predict(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        views: Views,
        *,
        cond_only: bool = False,
        apart: bool = False,
    ) -> Predictions:
        """The noise predictions for the prompt and for what it is compared with; no gradient.

        Args:
            t: indices into ``alpha_bar``.
            cond_only: the caller needs ``cond`` alone, and the others may be left out.
            apart: the negative prompt's prediction next to that of no words, not in its place;
                ``negative`` is None without a negative prompt.
        """


def coarse_latent(
    n: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"], size: int
) -> Float[Tensor, "b 4 {size} {size}"]:
    """ñ as a latent: [n, 2o - 1], area-downsampled; the paper's early phase (§4.2).

    Args:
        n: normals weighted by coverage, as ``render_normals`` gives them.
        o: coverage in [0, 1]; it goes to [-1, 1], the range of a normal's component.
    """
    picture = torch.cat([n, 2 * o - 1], -1).permute(0, 3, 1, 2)
    return torch.nn.functional.adaptive_avg_pool2d(picture, size)
