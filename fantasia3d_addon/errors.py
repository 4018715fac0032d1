"""What the user can mend, said in a sentence. Anything else keeps its traceback."""


class AddonError(Exception):
    """A sentence for the user: what was got and expected (``text``), and what to do (``fix``)."""

    def __init__(self, text: str, fix: str = "") -> None:
        super().__init__(f"{text} {fix}".strip())
        self.text = text
        self.fix = fix


class AssetError(AddonError):
    """A folder is no asset, or half of one."""


class JobError(AddonError):
    """A job could not be started."""


class LightError(AddonError):
    """A light is not there, or is no picture."""


class OutputError(AddonError):
    """A file could not be written."""
