"""An embedding table in which only some rows are trained."""

import torch
import torch.nn.functional as F
from jaxtyping import Float, Int
from torch import Tensor, nn

from core.errors import UserError


class LearntRows(nn.Module):
    """An embedding table in which only the given rows are trained.

    A step with the whole table as a parameter would move all rows and take nearly twice as long.
    """

    weight: Tensor
    rows: Tensor
    place: Tensor

    def __init__(self, table: nn.Embedding, rows: Int[Tensor, " r"]) -> None:
        super().__init__()
        weight = table.weight.detach()
        # Beyond the end: no other row is available.
        place = torch.full((len(weight),), len(rows) + 1)
        place[0] = 0  # "not stated", which all nouns share
        place[rows.cpu()] = 1 + torch.arange(len(rows))
        for name, tensor in (("weight", weight), ("rows", rows), ("place", place.to(rows.device))):
            self.register_buffer(name, tensor)
        self.learnt = nn.Parameter(weight[rows])

    def forward(self, index: Int[Tensor, " b"]) -> Float[Tensor, "b c"]:
        """The rows at ``index``.

        Raises UserError for a row that is not trained: samples of it were added later.
        """
        if bool((self.place[index] > len(self.rows)).any()):
            raise UserError(
                "There are samples of a noun that this held training did not start with.",
                "Train that noun in a folder of its own.",
            )
        return F.embedding(self.place[index], torch.cat([self.weight[:1], self.learnt]))

    def whole(self, learnt: Float[Tensor, "r c"]) -> Float[Tensor, "v c"]:
        """The whole table, with ``learnt`` in the place of the trained rows."""
        return self.weight.index_copy(0, self.rows, learnt)
