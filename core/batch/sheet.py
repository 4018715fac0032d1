"""The contact sheet of a batch: one HTML page with each asset's picture, health and a viewer.

Pictures are in the page; an asset's GLB is in a script next to it, ``contact_sheet/``, which is
loaded at a click: a thousand of them would be too much for one page.
"""

import base64
import json
from collections.abc import Sequence
from html import escape
from pathlib import Path

from core.batch.results import Result
from core.errors import UserError
from core.io.atomic import atomic_file
from core.io.job import write_text
from core.report.lights import COLUMNS, ROWS, lights_of
from core.report.page import filled, picture_url, viewer_script

HERE = Path(__file__).parent
SIDE = 256  # pixels of a picture


def write_sheet(out: Path, file: str, results: Sequence[Result], title: str) -> Path:
    """Write the page ``file`` into the batch's folder ``out``; its path."""
    # Rows that share an asset are one picture.
    shown = list({result.folder or result.line: result for result in results}.values())
    lights = lights_of("studio")
    del lights["the run's"]
    parts = {
        "title": escape(title),
        "end": escape(_summary(results)),
        "body": "\n".join(_figure(out, result) for result in shown),
        "lights": "".join(f"<option>{escape(name)}</option>" for name in lights),
        "scripts": _scripts(lights),
    }
    page = filled((HERE / "sheet.html").read_text(encoding="utf-8"), parts)
    with atomic_file(out / file) as temporary:
        # The title is a file's name, which may be no text.
        temporary.write_text(page, encoding="utf-8", errors="replace")
    return out / file


def _summary(results: Sequence[Result]) -> str:
    states = [result.state for result in results]
    counts = {state: states.count(state) for state in ("done", "failed", "unfinished", "missing")}
    return ", ".join(f"{count} {state}" for state, count in counts.items() if count)


def _figure(out: Path, result: Result) -> str:
    name, prompt = escape(result.name, quote=True), escape(result.prompt)
    asset = out / result.folder / "asset"
    caption = f"<b>{name}</b>{prompt}<br>{_health(result)}"
    if result.state != "done":
        return _empty(result.state, caption)
    try:
        picture = picture_url(asset / "preview.png", SIDE)
        _write_script(out / "contact_sheet" / f"{result.folder}.js", asset, result.folder)
    except (UserError, OSError) as error:  # one broken asset must not hide the others
        return _empty("broken", f'{caption}<span class="bad">{escape(str(error))}</span>')
    folder = escape(result.folder, quote=True)
    return (
        f'<figure><button data-folder="{folder}" data-file="{folder}" data-name="{name}">'
        f'<img src="{picture}" alt="{prompt}" loading="lazy"></button>'
        f"<figcaption>{caption}</figcaption></figure>"
    )


def _empty(state: str, caption: str) -> str:
    return f'<figure><div class="none">{state}</div><figcaption>{caption}</figcaption></figure>'


def _health(result: Result) -> str:
    if result.state != "done":
        return f'<span class="bad">{escape(result.text)}</span>'
    whole = result.closed is True and result.components == 1
    closed = "closed" if result.closed is True else "open"
    parts = "1 component" if result.components == 1 else f"{result.components} components"
    text = f"{closed}, {parts}, {result.faces} faces, {result.seconds} s"
    return f'<span class="{"health" if whole else "bad"}">{text}</span>'


def _write_script(path: Path, asset: Path, folder: str) -> None:
    """The asset's GLB as a script; one that is newer than the asset stays."""
    source = asset / "asset.glb"
    if path.is_file() and path.stat().st_mtime >= source.stat().st_mtime:
        return
    path.parent.mkdir(exist_ok=True)
    glb = base64.b64encode(source.read_bytes()).decode()
    write_text(path, f"showAsset({json.dumps(folder)}, {json.dumps(glb)});\n")


def _scripts(lights: dict[str, str]) -> str:
    own = (HERE / "sheet.js").read_text(encoding="utf-8")
    own = own.replace("@rows@", str(ROWS)).replace("@columns@", str(COLUMNS))
    return (
        f'<script type="application/json" id="lights">{json.dumps(lights)}</script>'
        f'<script type="module">{viewer_script()}</script>'
        f'<script type="module">{own}</script>'
    )
