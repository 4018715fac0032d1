"""The processes that make one asset together: each renders a part of the views of every step.

All of them draw the same random numbers for all views (``Draw``) and take every ``world``-th of
them. Common values, above all the network's gradient, are summed. So N of them make
the same asset as one, except for rounding. The only file that uses torch.distributed.
"""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import timedelta
from typing import Any

import torch
from jaxtyping import Float
from safetensors.torch import load, save
from torch import Tensor

from core.errors import MissingError, RankLostError, UserError

# Of what the others wait for: the first one sharpens, unwraps and bakes alone, which takes minutes.
TIMEOUT = timedelta(hours=1)
NEEDED = ("RANK", "WORLD_SIZE", "MASTER_ADDR", "MASTER_PORT")  # what torchrun sets
WORDS = "last words"  # in the store


@dataclass(frozen=True)
class Ranks:
    """This process among those that make one asset; alone, nothing here costs anything."""

    rank: int = 0
    world: int = 1
    group: Any = None  # torch's process group
    store: Any = None  # torch's key-value store, which the first process or torchrun holds

    @property
    def first(self) -> bool:
        """Whether it is the one that reads and writes the run folder."""
        return self.rank == 0

    @property
    def own(self) -> slice:
        """The views of a step that this process renders."""
        return slice(self.rank, None, self.world)

    def sum(self, x: Tensor) -> Tensor:
        """``x`` of all processes together, in place: to the bit the same in each of them.

        Raises:
            RankLostError: one of them has ended.
        """
        if self.world > 1:
            try:
                self.group.allreduce([x]).wait()
            except RuntimeError as error:
                raise self._lost() from error
        return x

    def sum_gradients(self, module: torch.nn.Module) -> None:
        """Put the sum of all processes' gradients into each of them."""
        if self.world == 1:
            return
        parameters = list(module.parameters())
        # A regulariser may not apply in one of them, and so leave no gradient there.
        has = self.rows([float(p.grad is not None) for p in parameters]).amax(0).tolist()
        some = [p for p, any_has in zip(parameters, has, strict=True) if any_has]
        grads = [torch.zeros_like(p) if p.grad is None else p.grad for p in some]
        if not grads:
            return
        flat = self.sum(torch.cat([grad.flatten() for grad in grads]))  # one message for all
        for p, grad in zip(some, flat.split([grad.numel() for grad in grads]), strict=True):
            p.grad = grad.view_as(p)

    def rows(self, mine: list[float]) -> Float[Tensor, "r n"]:
        """A row of numbers of each process, on the CPU."""
        table = torch.zeros(self.world, len(mine), dtype=torch.float64)
        table[self.rank] = torch.tensor(mine, dtype=torch.float64)
        return self.sum(table)

    def whole(self, mine: Float[Tensor, "m ..."], count: int) -> Float[Tensor, "{count} ..."]:
        """All ``count`` rows; each process has its own of them."""
        if self.world == 1:
            return mine
        rows = mine.new_zeros(count, *mine.shape[1:])
        rows[self.own] = mine
        return self.sum(rows)

    def texts(self, mine: str) -> list[str]:
        """A text of each process."""
        return [found.decode() for found in self._bytes(mine.encode())]

    def from_first(self, tensors: dict[str, Tensor]) -> dict[str, Tensor]:
        """The first process's tensors, whatever the others give; on the CPU."""
        if self.world == 1:
            return tensors
        values = {k: x.detach().cpu().contiguous() for k, x in tensors.items()}
        return load(self._bytes(save(values) if self.first else b"")[0])

    def report(self, text: str) -> None:
        """Leave an error sentence for the others before the end."""
        if self.store is not None:
            self.store.set(WORDS, text)

    def leave(self) -> None:
        """End what :func:`join` started."""
        if self.group is not None:
            torch.distributed.destroy_process_group()

    def _bytes(self, mine: bytes) -> list[bytes]:
        lengths = [int(n) for n in self.rows([len(mine)])[:, 0]]
        flat = torch.zeros(sum(lengths), dtype=torch.uint8)
        start = sum(lengths[: self.rank])
        if mine:
            flat[start : start + len(mine)] = torch.frombuffer(bytearray(mine), dtype=flat.dtype)
        parts = self.sum(flat).split(lengths)
        return [part.numpy().tobytes() for part in parts]

    def _lost(self) -> RankLostError:
        words = "Another process of this run has ended."
        try:
            if self.store is not None and self.store.check([WORDS]):
                words = f"Another process of this run has ended: {self.store.get(WORDS).decode()}"
        except RuntimeError:  # the store has ended with the first process
            pass
        return RankLostError(words, "Continue it with resume, on the available GPUs.")


ALONE = Ranks()


def rank_in(environ: Mapping[str, str] = os.environ) -> int | None:
    """The number of this process among several, as torchrun sets it; None where it is alone."""
    if not all(environ.get(name) for name in NEEDED) or environ["WORLD_SIZE"] == "1":
        return None
    return int(environ["RANK"])


def join(environ: Mapping[str, str] = os.environ) -> Ranks:
    """Meet the other processes of ``environ``, each of which calls this."""
    rank, world = int(environ["RANK"]), int(environ["WORLD_SIZE"])
    return meet(_store(environ, rank, world), rank, world)


def host(world: int) -> tuple[Any, int]:
    """The store that the first of ``world`` processes on this machine holds, and its port."""
    store = torch.distributed.TCPStore(
        "127.0.0.1", 0, world, is_master=True, timeout=TIMEOUT, wait_for_workers=False
    )
    return torch.distributed.PrefixStore("0", store), store.port  # as in the others' join()


def meet(store: Any, rank: int, world: int) -> Ranks:
    """The group of ``world`` processes that have this store in common."""
    # Flags and counts are on the CPU, for which no kernel of the GPU has to be waited for.
    backend = "cpu:gloo,cuda:nccl" if torch.distributed.is_nccl_available() else "gloo"
    store = torch.distributed.PrefixStore("fantasia3d", store)
    torch.distributed.init_process_group(
        backend, store=store, rank=rank, world_size=world, timeout=TIMEOUT
    )
    return Ranks(rank, world, torch.distributed.group.WORLD, store)


def _store(environ: Mapping[str, str], rank: int, world: int) -> Any:
    # torchrun has a store already, and one that outlives a restart.
    agent = environ.get("TORCHELASTIC_USE_AGENT_STORE") == "True"
    store = torch.distributed.TCPStore(
        environ["MASTER_ADDR"],
        int(environ["MASTER_PORT"]),
        world,
        is_master=rank == 0 and not agent,
        timeout=TIMEOUT,
        wait_for_workers=False,
    )
    return torch.distributed.PrefixStore(environ.get("TORCHELASTIC_RESTART_COUNT", "0"), store)


def require_gpus(count: int, device: str, found: int) -> None:
    """Refuse ``--gpus`` where it cannot be: ``found`` CUDA devices are there.

    Raises:
        UserError, MissingError: it takes another device, or more of them.
    """
    if device not in ("auto", "cuda"):
        raise UserError(
            f"--gpus {count} and the device {device} cannot be combined.",
            "Use --device cuda, or leave --gpus out.",
        )
    if count > found:
        raise MissingError(
            f"--gpus is {count}, and this torch finds {found or 'no'} CUDA "
            f"device{'s' * (found != 1)}.",
            "Use fewer, or leave --gpus out.",
        )


def require_views(world: int, views: Mapping[str, int]) -> None:
    """Refuse more processes than the views of a step; ``views``: by the setting's name."""
    for name, count in views.items():
        if count < world:
            raise UserError(
                f"{world} processes cannot share the {count} view{'s' * (count != 1)} of {name}.",
                f"Use {count} or fewer, or raise {name} with --set.",
            )
