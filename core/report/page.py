"""``run.py report RUN``: one HTML file that holds all of a run, and needs nothing else.

The viewer is Google's model-viewer (Apache-2.0, ``model-viewer.LICENSE.txt``; its file also holds
three.js, MIT, and lit, BSD-3-Clause). The page's own policy forbids it every connection.
"""

import base64
import io
import json
from html import escape
from pathlib import Path
from typing import Any

from PIL import Image

from core.errors import UserError
from core.io.atomic import atomic_file
from core.io.input_file import own_file
from core.report.facts import REMAKE, Facts, facts_of, fields_of
from core.report.lights import COLUMNS, ROWS, lights_of
from core.report.svg import curve

HERE = Path(__file__).parent
VIEWER = HERE / "model-viewer.min.js"
MARK = b"<!doctype html>\n<!-- fantasia3d report -->"
MAP_SIDE = 512  # pixels of a map in the page; the asset's own are in the viewer
MAPS = {"base_color.png": "base colour", "orm.png": "occlusion, roughness, metallic"}
MAPS |= {"normal.png": "normals", "emission.png": "emission", "transmission.png": "transmission"}


def write_report(run: Path, out: Path | None = None) -> Path:
    """Write the report of the run folder ``run``; the path of its file.

    ``out``: None is report.html in the run folder.

    Raises:
        UserError: no run folder or a broken one; ``out`` is a file that is not a report.
    """
    out = out or run / "report.html"
    facts = facts_of(run)
    _refuse_foreign(out)
    text = html(facts)
    with atomic_file(out) as temporary:
        temporary.write_text(text, encoding="utf-8")
    return out


def _refuse_foreign(out: Path) -> None:
    """Only a report is replaced; anything else is somebody's work."""
    if out.suffix.lower() not in (".html", ".htm"):
        raise UserError(f"{out} is not an HTML file.", "Use a name that ends in .html.")
    if out.is_dir():
        raise UserError(f"{out} is a folder.", "Use another --out.")
    if out.exists():
        with out.open("rb") as file:
            if file.read(len(MARK)) != MARK:
                raise UserError(f"{out} is not a report, and would be lost.", "Use another --out.")


def html(facts: Facts) -> str:
    """The whole page."""
    parts = {
        "title": escape(facts.job.prompt),
        "end": escape(_end(facts)),
        "body": "\n".join(_sections(facts)),
        "viewer": _scripts(facts),
    }
    return filled((HERE / "page.html").read_text(encoding="utf-8"), parts)


def filled(page: str, parts: dict[str, str]) -> str:
    """``page`` with each ``@name@`` replaced by that part."""
    # Split, not replaced: a prompt may contain the name of a place.
    first, *rest = page.split("@")
    return first + "".join(parts[text] if at % 2 == 0 else text for at, text in enumerate(rest))


def _end(facts: Facts) -> str:
    sessions = "" if facts.sessions < 2 else f", in {facts.sessions} sessions"
    seconds = sum(facts.seconds.values())
    return f"{facts.job.command}, {facts.job.preset} preset: {facts.end}{sessions}; {seconds:.0f} s"


def _sections(facts: Facts) -> list[str]:
    """The page's parts in their order; what a run does not have yet is left out."""
    plots = [
        curve(points, f"{shown.stage}: {name}", logarithmic=name == "loss")
        for shown in facts.curves
        for name, points in (("loss", shown.loss), ("coverage", shown.coverage))
        if points
    ]
    folded = f"<details><summary>All settings in force</summary>{_table(facts.settings)}</details>"
    frames = "".join(_figure(path, stage) for stage, path in facts.film)
    sections = [
        (_viewer_tag(facts), ""),
        (f'<div class="film">{frames}</div>' if frames else "", "Previews"),
        (_maps(facts.folder), "Maps"),
        (f'<div class="grid">{"".join(plots)}</div>' if plots else "", "Loss and coverage"),
        (_table(_health(facts.asset)), "Health of the mesh"),
        (_bars(facts.seconds), "Seconds by stage"),
        (_table(fields_of(facts.job)) + folded, "Prompt and settings"),
        ("".join(f'<p class="warning">{escape(text)}</p>' for text in facts.warnings), "Warnings"),
    ]
    return [(f"<h2>{title}</h2>" if title else "") + text for text, title in sections if text]


def _table(values: dict[str, Any]) -> str:
    rows = (
        f"<tr><td>{escape(str(name))}</td><td>{escape(_shown(value))}</td></tr>"
        for name, value in values.items()
    )
    return f'<table class="facts">{"".join(rows)}</table>' if values else ""


def _shown(value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.6g}"
    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)


def _health(asset: dict[str, Any]) -> dict[str, Any]:
    found = asset.get("mesh")
    return found if isinstance(found, dict) else {}


def _bars(seconds: dict[str, float]) -> str:
    most = max(seconds.values(), default=0.0) or 1.0
    rows = (
        f"<tr><td>{escape(stage)}</td><td>{value:.1f}</td>"
        '<td style="width:60%">'
        f'<div class="bar" style="width:{100 * value / most:.1f}%"></div></td></tr>'
        for stage, value in seconds.items()
    )
    return f"<table>{''.join(rows)}</table>" if seconds else ""


def _maps(run: Path) -> str:
    paths = [(run / "asset" / name, text) for name, text in MAPS.items()]
    shown = [(own_file(path, run, REMAKE), text) for path, text in paths if path.is_file()]
    figures = "".join(_figure(path, text) for path, text in shown)
    return f'<div class="grid maps">{figures}</div>' if figures else ""


def _figure(path: Path, caption: str) -> str:
    return (
        f'<figure><img src="{picture_url(path)}" alt="{escape(caption)}">'
        f"<figcaption>{escape(caption)}</figcaption></figure>"
    )


def picture_url(path: Path, side: int = MAP_SIDE) -> str:
    """A picture as a data URL, at most ``side`` pixels wide.

    Raises UserError for a file that is not a picture.
    """
    try:
        with Image.open(path) as file:
            # Normals have 16 bits a channel, which JPEG has not.
            picture = file.convert("RGB")
    except (OSError, ValueError) as error:
        raise UserError(f"{path} is not a picture ({error}).", "Make the asset again.") from None
    picture.thumbnail((side, side))
    packed = io.BytesIO()
    picture.save(packed, "JPEG", quality=88)
    return f"data:image/jpeg;base64,{base64.b64encode(packed.getvalue()).decode()}"


def _viewer_tag(facts: Facts) -> str:
    if not facts.asset:
        return ""
    options = "".join(f"<option>{escape(name)}</option>" for name in lights_of(facts.job.light))
    return (
        '<model-viewer camera-controls touch-action="pan-y" shadow-intensity="0.6" '
        'interaction-prompt="none" alt="The asset"></model-viewer>'
        f'<p class="tools"><label>Light <select id="light">{options}</select></label>'
        '<label>turned by <input id="turn" type="range" min="0" max="360" value="0"></label>'
        '<label>Exposure <input id="exposure" type="range" min="0.2" max="3" step="0.05" '
        'value="1"></label><label><input id="spin" type="checkbox"> Turn the asset</label></p>'
    )


def _scripts(facts: Facts) -> str:
    if not facts.asset:
        return ""
    own = (HERE / "viewer.js").read_text(encoding="utf-8")
    own = own.replace("@rows@", str(ROWS)).replace("@columns@", str(COLUMNS))
    glb = base64.b64encode(facts.glb).decode()
    lights = json.dumps(lights_of(facts.job.light))
    return (
        f'<script type="text/plain" id="glb">{glb}</script>'
        f'<script type="application/json" id="lights">{lights}</script>'
        f'<script type="module">{viewer_script()}</script>'
        f'<script type="module">{own}</script>'
    )


def viewer_script() -> str:
    """model-viewer's source for a page."""
    # Without its map, which is not here; an end of script inside a script's text would end it.
    viewer = VIEWER.read_text(encoding="utf-8").partition("//# sourceMappingURL")[0]
    return viewer.replace("</script", "<\\/script")
