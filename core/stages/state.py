"""The state of a training, which its checkpoints hold."""

import json
from typing import Any, Generic, TypeVar

import torch
from torch import Tensor

from core.adam import Adam
from core.io.run_folder import RunFolder
from core.ranks import Ranks

Net = TypeVar("Net", bound=torch.nn.Module)
HEALTHY = "healthy."  # in a checkpoint's names: of the state to go back to


class Training(Generic[Net]):
    """The state that a training needs to continue where it stopped.

    The parameters, the optimiser's moments, the random generator and the step; and the tensors of
    the present round of fitting.
    """

    def __init__(self, name: str, module: Net, generator: torch.Generator, run: RunFolder) -> None:
        self.name, self.module, self.generator, self.run = name, module, generator, run
        # "Implementation Details": AdamW, here without a decay. The betas and eps are the released
        # code's. Each step sets its own learning rate.
        # So small an eps lets weak and rare gradients move a hash grid (Müller et al. 2022, §4, the
        # same values).
        self.optimizer = Adam(module.parameters(), betas=(0.9, 0.99), eps=1e-15)
        self.step = 0  # the next one
        self.extra: dict[str, Any] = {}  # small JSON values, such as the guard's
        self.healthy: dict[str, Tensor] = {}  # the state to go back to (guard.py)
        self.at_once = 0  # views at a time, where memory did not hold the config's; 0: it did
        self._kept: dict[str, Tensor] = {}

    @property
    def device(self) -> torch.device:
        """Where the parameters are."""
        return next(self.module.parameters()).device

    def set_learning_rate(self, rate: float) -> None:
        """The learning rate of the next step."""
        self.optimizer.rate = rate

    def keep(self, label: str, tensors: dict[str, Tensor]) -> None:
        """Put ``tensors`` into the checkpoints under ``label``, in place of any others."""
        self._kept = {f"{label}.{key}": value for key, value in tensors.items()}

    def kept(self, label: str) -> dict[str, Tensor]:
        """The values kept under ``label``; nothing under another label."""
        start = f"{label}."
        return {k.removeprefix(start): v for k, v in self._kept.items() if k.startswith(start)}

    def state(self) -> dict[str, Tensor]:
        """All tensors of the training, by name; copies."""
        tensors = {f"module.{k}": v for k, v in self.module.state_dict().items()}
        for i, p in enumerate(self.optimizer.parameters):
            for key, value in self.optimizer.state.get(p, {}).items():
                tensors[f"optimizer.{i}.{key}"] = torch.as_tensor(value)
        tensors |= {f"kept.{key}": value for key, value in self._kept.items()}
        tensors["generator"] = self.generator.get_state()
        # Copies: the optimiser changes its tensors in place, and the guard keeps a state for many
        # steps.
        return {key: value.detach().clone() for key, value in tensors.items()}

    def set_state(self, tensors: dict[str, Tensor]) -> None:
        """Put a :meth:`state` back."""
        split: dict[str, dict[str, Tensor]] = {"module": {}, "optimizer": {}, "kept": {}}
        for key, value in tensors.items():
            if key != "generator":
                kind, name = key.split(".", 1)
                split[kind][name] = value
        self.module.load_state_dict(split["module"])
        self._kept = {key: value.to(self.device) for key, value in split["kept"].items()}
        self._set_moments(split["optimizer"])
        self.generator.set_state(tensors["generator"])

    def save(self) -> None:
        """Write a checkpoint."""
        meta = {"step": self.step, "extra": self.extra}
        healthy = {f"{HEALTHY}{key}": value for key, value in self.healthy.items()}
        self.run.save(self.name, self.state() | healthy, meta)

    def resume(self) -> None:
        """Load the checkpoint, where there is one."""
        found = self.run.load(self.name)
        if found is None:
            return
        tensors, meta = found
        start = len(HEALTHY)
        with self.run.whole_checkpoint(self.name):
            self.healthy = {k[start:]: v for k, v in tensors.items() if k.startswith(HEALTHY)}
            self.set_state({k: v for k, v in tensors.items() if not k.startswith(HEALTHY)})
            self.step, self.extra = int(meta["step"]), dict(meta["extra"])

    def synchronize(self, ranks: Ranks) -> None:
        """Take over the first process's state, whatever the others have computed of their own.

        Their fits, or the order of a GPU's sums in them, may differ in the last bits.
        """
        if ranks.world == 1:
            return
        healthy = {f"{HEALTHY}{key}": value for key, value in self.healthy.items()}
        meta = json.loads(ranks.texts(json.dumps([self.step, self.extra]))[0])
        tensors, start = ranks.from_first(self.state() | healthy), len(HEALTHY)
        self.step, self.extra = meta
        self.healthy = {k[start:]: v for k, v in tensors.items() if k.startswith(HEALTHY)}
        self.set_state({k: v for k, v in tensors.items() if not k.startswith(HEALTHY)})

    def synchronize_noise(self, ranks: Ranks) -> None:
        """Take over the state of the first process's random generator."""
        if ranks.world > 1:
            state = ranks.from_first({"generator": self.generator.get_state()})
            self.generator.set_state(state["generator"])

    def mark(self) -> tuple[Tensor, dict[str, Tensor]]:
        """The state that a step changes before the parameters: the generator, the kept values."""
        return self.generator.get_state(), self._kept

    def back_to(self, mark: tuple[Tensor, dict[str, Tensor]]) -> None:
        """Put a :meth:`mark` of the same step back."""
        self.generator.set_state(mark[0])
        self._kept = mark[1]

    def _set_moments(self, moments: dict[str, Tensor]) -> None:
        # A state from before the first step has no moments: those of now must not stay.
        self.optimizer.state.clear()
        for key, value in moments.items():
            i, name = key.split(".", 1)
            p = self.optimizer.parameters[int(i)]
            if name != "step" and value.shape != p.shape:
                raise ValueError(f"{key} does not have its parameter's shape")
            self.optimizer.state[p][name] = value.clone().to("cpu" if name == "step" else p.device)
