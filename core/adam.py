"""Adam, with which everything here is learnt.

torch's own loads torch's compiler before the first step, though nothing is compiled: 2 CPU-seconds.
"""

import math
from collections import defaultdict
from collections.abc import Iterable

import torch
from torch import Tensor


class Adam:
    """Adam (Kingma and Ba 2015, algorithm 1), which is AdamW with a weight decay of 0.

    A parameter without a gradient keeps its value, its moments and its count of steps.
    """

    def __init__(
        self,
        parameters: Iterable[Tensor],
        rate: float = 1e-3,
        betas: tuple[float, float] = (0.9, 0.999),
        eps: float = 1e-8,
    ) -> None:
        """``rate``: the learning rate, which may be changed from step to step."""
        self.parameters, self.rate, self.betas, self.eps = list(parameters), rate, betas, eps
        # Of each parameter, from its first step on: "exp_avg" and "exp_avg_sq", the moments, and
        # "step", which stays on the CPU. So checkpoints name them.
        self.state: defaultdict[Tensor, dict[str, Tensor]] = defaultdict(dict)

    def zero_grad(self) -> None:
        """Forget the gradients."""
        for parameter in self.parameters:
            parameter.grad = None

    @torch.no_grad()
    def step(self) -> None:
        """Move each parameter that has a gradient."""
        for parameter in self.parameters:
            if parameter.grad is not None:
                self._move(parameter, parameter.grad)

    def _move(self, parameter: Tensor, gradient: Tensor) -> None:
        state, (first, second) = self.state[parameter], self.betas
        if not state:
            state["step"] = torch.zeros(())
            state["exp_avg"] = torch.zeros_like(parameter)
            state["exp_avg_sq"] = torch.zeros_like(parameter)
        state["step"] += 1
        step = state["step"].item()
        mean = state["exp_avg"].lerp_(gradient, 1 - first)
        square = state["exp_avg_sq"].mul_(second).addcmul_(gradient, gradient, value=1 - second)
        spread = (square.sqrt() / math.sqrt(1 - second**step)).add_(self.eps)
        parameter.addcdiv_(mean, spread, value=-self.rate / (1 - first**step))
