"""Errors that the user can fix, as one sentence each. Anything else keeps its traceback."""


class AddonError(Exception):
    """``text``: one sentence, what is wrong; ``fix``: what the user can do."""

    def __init__(self, text: str, fix: str = "") -> None:
        super().__init__(f"{text} {fix}".strip())
        self.text = text
        self.fix = fix


class AssetError(AddonError):
    """A folder is no asset, or an incomplete one."""


class JobError(AddonError):
    """A job could not be started."""


class LightError(AddonError):
    """A light does not exist, or is no picture."""


class OutputError(AddonError):
    """A file could not be written."""
