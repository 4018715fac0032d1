"""The guidance of one thing of a composition."""

from typing import Protocol, runtime_checkable

from jaxtyping import Float, Int
from torch import Tensor

from core.appearance.material_ranges import MaterialRanges
from core.geometry.init_shape import Shape
from core.geometry.mesh import Mesh
from core.geometry.parts.assembly import KnownParts
from core.guidance.builtin.areas import AreaFields, SolidAreas
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.guidance import Predictions, Surface, Views


@runtime_checkable
class Thing(Protocol):
    """The guidance of one thing by itself."""

    words: Words
    solid: Solid | None

    def of_object(self, seed: int) -> "Thing":
        """See :class:`PromptedGuidance`, also for all that follow."""
        ...

    def with_solid(self, solid: Solid) -> "Thing":
        """The same of another solid."""
        ...

    def in_proportion(self, guide: Mesh, strength: float, least: float) -> "Thing":
        """In the proportions of a guide."""
        ...

    def start_shape(self) -> Shape | None:
        """The drawn solid."""
        ...

    def parts(self) -> KnownParts | None:
        """The parts of the drawn solid."""
        ...

    def area_fields(self) -> AreaFields | None:
        """Its areas in space."""
        ...

    def areas(self) -> SolidAreas | None:
        """The same on a lattice."""
        ...

    def ranges(self) -> MaterialRanges:
        """The ranges of all its parts."""
        ...

    def surfaces(self) -> tuple[Surface, ...]:
        """The surfaces of all its parts."""
        ...

    def style(self) -> str:
        """That of its words."""
        ...

    def left_out(self) -> tuple[str, ...]:
        """Notes."""
        ...

    def restore(
        self, pictures: Float[Tensor, "b 4 s s"], views: Views
    ) -> Float[Tensor, "b 4 s s"] | None:
        """Crisp pictures of the thing."""
        ...

    def predict(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        views: Views,
        *,
        cond_only: bool = False,
        apart: bool = False,
    ) -> Predictions:
        """The predictions for pictures of the thing."""
        ...
