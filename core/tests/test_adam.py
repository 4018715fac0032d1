"""The optimiser takes torch's own steps, and does not load torch's compiler."""

import pytest
import torch

from core.adam import Adam


@pytest.mark.parametrize("layout", [torch.contiguous_format, torch.channels_last])
def test_each_step_is_that_of_torchs_adamw_to_the_bit(layout):
    generator = torch.Generator().manual_seed(0)
    start = [torch.randn(2, 3, 4, 5, generator=generator).to(memory_format=layout) for _ in "ab"]
    ours, theirs = ([x.clone().requires_grad_() for x in start] for _ in range(2))
    adam = Adam(ours, 1e-2, (0.9, 0.99), 1e-15)
    adamw = torch.optim.AdamW(theirs, 1e-2, (0.9, 0.99), 1e-15, weight_decay=0.0)
    for step in range(20):
        adam.rate = adamw.param_groups[0]["lr"] = 1e-2 / (step + 1)
        adam.zero_grad()
        adamw.zero_grad()
        for one, two in zip(ours, theirs, strict=True):
            if one is ours[0] or step % 3:  # the other has no gradient at times
                one.grad = torch.randn(one.shape, generator=generator)
                two.grad = one.grad.clone()
        adam.step()
        adamw.step()
    for one, two in zip(ours, theirs, strict=True):
        assert torch.equal(one, two)
        for name, value in adamw.state[two].items():
            assert torch.equal(adam.state[one][name], value)


def test_a_parameter_that_never_had_a_gradient_has_no_state():
    still = torch.ones(3, requires_grad=True)
    adam = Adam([still])
    adam.step()
    assert not adam.state and torch.equal(still, torch.ones(3))
