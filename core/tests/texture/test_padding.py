"""Every empty texel takes the value of the nearest covered one."""

import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st

from core.errors import UserError
from core.texture.padding import nearest_covered, pad


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 10**6), st.floats(0.02, 0.9))
def test_nearest_is_the_slow_reference(seed: int, fraction: float) -> None:
    generator = torch.Generator().manual_seed(seed)
    covered = torch.rand(9, 13, generator=generator) < fraction
    covered[3, 4] = True
    at = covered.nonzero().float()
    for here, there in zip((~covered).nonzero(), nearest_covered(covered), strict=True):
        y, x = divmod(int(there), 13)
        assert covered[y, x]
        got = torch.tensor([y, x]).float() - here
        assert got.norm() == pytest.approx(float((at - here).norm(dim=1).min()))


def test_no_background_is_left() -> None:
    """Fault 3 of the released code: its padding stopped at the tile's border."""
    covered = torch.zeros(32, 32, dtype=torch.bool)
    covered[20:24, 3:9] = True
    image = torch.where(covered[..., None], torch.tensor([0.2, 0.4, 0.6]), torch.tensor(9.0))
    filled = pad(image, covered, nearest_covered(covered))
    torch.testing.assert_close(filled, torch.tensor([0.2, 0.4, 0.6]).expand(32, 32, 3))


def test_islands_are_not_touched() -> None:
    generator = torch.Generator().manual_seed(0)
    image = torch.rand(16, 16, 3, generator=generator)
    covered = torch.rand(16, 16, generator=generator) < 0.3
    filled = pad(image.clone(), covered, nearest_covered(covered))
    assert torch.equal(filled[covered], image[covered])


def test_all_covered_is_unchanged() -> None:
    image = torch.rand(4, 4, 3)
    covered = torch.ones(4, 4, dtype=torch.bool)
    assert torch.equal(pad(image.clone(), covered, nearest_covered(covered)), image)


def test_nothing_covered_is_reported() -> None:
    with pytest.raises(UserError, match="No texel of the 4 x 4 texture"):
        nearest_covered(torch.zeros(4, 4, dtype=torch.bool))
