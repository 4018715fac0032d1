"""diffusers' and transformers' classes: the only file that imports them, at the first use of one.

That takes 4 CPU seconds, which whoever needs no checkpoint does not wait for.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from diffusers import AutoencoderKL as AutoencoderKL
    from diffusers import DDPMScheduler as DDPMScheduler
    from diffusers import UNet2DConditionModel as UNet2DConditionModel
    from transformers import CLIPTextConfig as CLIPTextConfig
    from transformers import CLIPTextModel as CLIPTextModel
    from transformers import CLIPTextModelWithProjection as CLIPTextModelWithProjection
    from transformers import CLIPTokenizer as CLIPTokenizer


def __getattr__(name: str) -> Any:
    """The class of that name, as an attribute of this module."""
    if name.startswith("_"):  # what Python itself asks a module for
        raise AttributeError(name)
    import diffusers
    import transformers

    return getattr(transformers if name.startswith("CLIP") else diffusers, name)
