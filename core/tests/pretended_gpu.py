"""A GPU that is not there: tensors that refuse the CPU's, and a count of what waits for them.

The numbers are the CPU's. What a CUDA device would make Python wait for is counted: numbers that
are asked for, sizes that depend on numbers, and copies in either direction, but for those to the
GPU that are asked not to wait (``non_blocking``).
"""

import traceback
from collections import Counter
from contextlib import contextmanager

import torch
from torch import Tensor
from torch.overrides import TorchFunctionMode
from torch.utils import backend_registration
from torch.utils._python_dispatch import TorchDispatchMode
from torch.utils._pytree import tree_leaves, tree_map


class _Module(backend_registration._DummyBackendModule):
    """Of the pretended device; torch.utils.checkpoint asks for it on the CPU too."""

    def get_amp_supported_dtype(self):
        return [torch.float16]


# Gives PyTorch's place for further devices a name, and the autograd engine a device to run on.
backend_registration._setup_privateuseone_for_python_backend("pretended", _Module())
GPU = torch.device("pretended:0")

NUMBERS = ("_local_scalar_dense", "equal", "is_nonzero")
SIZES = ("nonzero", "masked_select", "unique_dim", "unique_consecutive", "_unique2", "bincount")
waits: Counter[str] = Counter()


@contextmanager
def pretended():
    """Within, tensors can be made on ``GPU``, and sent there."""
    waits.clear()
    with _Everything(), _FromPython():
        yield


class There(Tensor):
    """A tensor on the pretended GPU; its numbers are in ``at``."""

    @staticmethod
    def __new__(cls, at):
        return Tensor._make_wrapper_subclass(
            cls, at.shape, strides=at.stride(), dtype=at.dtype, device=GPU
        )

    def __init__(self, at):
        self.at = at

    def __repr__(self):
        return f"There({self.at})"

    @classmethod
    def __torch_dispatch__(cls, func, types, args=(), kwargs=None):
        return run(func, args, kwargs or {})


class _Everything(TorchDispatchMode):
    def __torch_dispatch__(self, func, types, args=(), kwargs=None):
        return run(func, args, kwargs or {})


class _FromPython(TorchFunctionMode):
    """What never comes to the dispatcher: Python's numbers made tensors, and the way back."""

    def __torch_function__(self, func, types, args=(), kwargs=None):
        kwargs = kwargs or {}
        if func is Tensor.new_tensor and isinstance(args[0], There):
            _wait("up")
            return There(torch.tensor(args[1], dtype=args[0].dtype))
        if func in (torch.tensor, torch.as_tensor) and _is_gpu(kwargs.get("device")):
            _wait("up")
            return There(func(*args, **kwargs | {"device": None}))
        if func is Tensor.tolist and isinstance(args[0], There):
            _wait("number")
            return args[0].at.tolist()
        return func(*args, **kwargs)


def run(func, args, kwargs):
    """An operation where its tensors are."""
    name = func.overloadpacket.__name__
    tensors = [x for x in tree_leaves((args, kwargs)) if isinstance(x, Tensor)]
    there = [x for x in tensors if isinstance(x, There)]
    on_gpu = _is_gpu(kwargs["device"]) if kwargs.get("device") is not None else bool(there)
    if name in ("_to_copy", "copy_"):
        source, to = (args[0], on_gpu) if name == "_to_copy" else (args[1], _is_there(args[0]))
        if _is_there(source) != to and not (to and kwargs.get("non_blocking")):
            _wait("up" if to else "down")
    elif there:
        alone = [x for x in tensors if not _is_there(x)]
        # A CPU's number goes along with the kernel's call; its indices are sent.
        if any(x.dim() for x in alone):
            assert name.startswith("index"), f"{func} of tensors on two devices"
            _wait("up")
        _look(func, name, args, kwargs)
    if _is_gpu(kwargs.get("device")):
        kwargs = kwargs | {"device": torch.device("cpu")}
    out = func(*tree_map(_at, args), **tree_map(_at, kwargs))
    known = {id(x.at): x for x in there}  # in place: the same tensor comes back
    there_again = lambda x: known[id(x)] if id(x) in known else There(x)  # noqa: E731
    return tree_map(lambda x: there_again(x) if on_gpu and isinstance(x, Tensor) else x, out)


def _look(func, name, args, kwargs):
    masks = name.startswith("index") and isinstance(args[1], list | tuple)
    masks = masks and any(x is not None and x.dtype == torch.bool for x in args[1])
    sizeless = name == "repeat_interleave" and kwargs.get("output_size") is None
    if name in NUMBERS:
        _wait("number")
    elif name in SIZES or masks or sizeless:
        _wait("size")


def _wait(why):
    calls = [f for f in traceback.extract_stack() if "/core/" in f.filename]
    calls = [f for f in calls if "/tests/" not in f.filename]
    at = calls[-1] if calls else None
    waits[f"{why} {at.filename.split('/core/')[1]}:{at.lineno}" if at else why] += 1


def _is_there(x):
    return isinstance(x, There)


def _at(x):
    return x.at if isinstance(x, There) else x


def _is_gpu(device):
    return device is not None and torch.device(device).type == GPU.type
