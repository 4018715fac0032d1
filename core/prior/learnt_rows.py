"""A table of which some rows learn."""

import torch
import torch.nn.functional as F
from jaxtyping import Float, Int
from torch import Tensor, nn

from core.errors import UserError


class LearntRows(nn.Module):
    """A table of which some rows learn and the others stay: of all nouns' features a step for the
    few that learn would else move all, and take nearly twice as long."""

    weight: Tensor
    rows: Tensor
    place: Tensor

    def __init__(self, table: nn.Embedding, rows: Int[Tensor, " r"]) -> None:
        super().__init__()
        weight = table.weight.detach()
        place = torch.full((len(weight),), len(rows) + 1)  # beyond: no other row may be asked for
        place[0] = 0  # "not stated", which all nouns share
        place[rows.cpu()] = 1 + torch.arange(len(rows))
        for name, tensor in (("weight", weight), ("rows", rows), ("place", place.to(rows.device))):
            self.register_buffer(name, tensor)
        self.learnt = nn.Parameter(weight[rows])

    def forward(self, index: Int[Tensor, " b"]) -> Float[Tensor, "b c"]:
        """The rows.

        Raises UserError for one that does not learn, of samples that came later.
        """
        if bool((self.place[index] > len(self.rows)).any()):
            raise UserError(
                "There are samples of a noun that this held training did not begin with.",
                "Train it in a folder of its own.",
            )
        return F.embedding(self.place[index], torch.cat([self.weight[:1], self.learnt]))

    def whole(self, learnt: Float[Tensor, "r c"]) -> Float[Tensor, "v c"]:
        """The table with such rows in the place of those that learn."""
        return self.weight.index_copy(0, self.rows, learnt)
