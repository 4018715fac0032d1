"""The page: every figure of the paper next to what was made, in Markdown with JPEG pictures."""

import io
from pathlib import Path

from PIL import Image

from core.batch.table import slug
from core.io.atomic import atomic_file, disk_errors
from core.io.job import write_text
from core.reproduce.figures import ASSETS, FIGURES, Figure
from core.reproduce.make import Order, Plan, plan, words_of
from core.reproduce.numbers import LABELS

GAP = 4  # pixels between pictures
QUALITY = 86
HEAD = """# The paper's figures, made again

Written by `python3 run.py reproduce`, which makes what is missing, can be stopped with Ctrl-C and
continues at the next call; `--figure NAME` makes one figure, `--list` shows what there is.
What the paper shows is described in words: its pictures are not part of this project.

{guidance}

Not made again: the comparisons with DreamFusion, Magic3D, Latent-NeRF, Text2Mesh and CLIP-Mesh
(Figs. 7, 9 and 10), which are other projects' results; the overview (Fig. 3); the edge padding
(Fig. 5), which is a test here (`core/tests/texture/test_padding.py`).

Numbers, where the paper has none: *retrieval* is the noun's place among the prior's nouns by
Chamfer distance to their held-out shapes (in brackets the nearest, where it is another); *colour
error* is the median CIE76 difference to the word's colour.
"""
BUILTIN_TEXT = """**What cannot be shown here.** The paper's prompts ("a highly detailed stone
bust of Theodoros Kolokotronis") need Stable Diffusion's weights, which cannot be shipped. All
assets below are made with the built-in prior, on one CPU core each: simple objects, named in its
own words. They show that the method's parts work, not the paper's detail. With a checkpoint,
`python3 run.py reproduce --guidance FOLDER` takes the paper's prompts and the `standard` preset;
that has not been run yet."""
FREE_TEXT = "Made with the checkpoint `{guidance}` and the `standard` preset."


def write_page(page: Path, order: Order) -> Path:
    """Write the page from what ``order.out`` has; its pictures go to a folder of the same name."""
    text = BUILTIN_TEXT
    if order.guidance != "builtin":
        text = FREE_TEXT.format(guidance=Path(order.guidance).name)
    with disk_errors(page):
        page.with_suffix("").mkdir(parents=True, exist_ok=True)
    parts = [HEAD.format(guidance=text)]
    parts += [section(figure, order, page) for figure in figures_for(order)]
    write_text(page, "\n".join(parts))
    return page


def figures_for(order: Order) -> list[Figure]:
    """The figures that the guidance of ``order`` can make."""
    return [f for f in FIGURES if order.guidance == "builtin" or not f.builtin_only]


def section(figure: Figure, order: Order, page: Path) -> str:
    """One figure's part of the page."""
    plans = plan(figure, order)
    made = [each for each in plans if each.is_made]
    failed = [each for each in plans if each.result and not each.is_made]
    rest = [each.row.name for each in plans if not each.result]
    lines = [f"## {figure.title}", "", f"**Paper.** {figure.paper}", "", f"**Here.** {figure.note}"]
    if made:
        lines += ["", *_table(figure, made, order, page)]
    for each in failed:
        lines += ["", f"**{each.row.name}** failed: {(each.result or {})['failure']}"]
    if rest:
        command = f"python3 run.py reproduce --figure {figure.name}"
        lines += ["", f"Not made yet: {', '.join(rest)}. `{command}` makes them."]
    return "\n".join([*lines, ""])


def _table(figure: Figure, made: list[Plan], order: Order, page: Path) -> list[str]:
    labels = list(dict.fromkeys(" · ".join(name for name, _ in p.row.shots) for p in made))
    head = labels[0] if len(labels) == 1 else "pictures"
    lines = [f"| | {head} | measured |", "|---|---|---|"]
    for each in made:
        picture = page.with_suffix("") / f"{figure.name}-{slug(each.row.name)}.jpg"
        _strip(each, picture)
        own = "" if len(labels) == 1 else "<br>" + " · ".join(name for name, _ in each.row.shots)
        link = f"![{each.row.name}]({page.stem}/{picture.name})"
        lines.append(f"| {_words(each, order)} | {link}{own} | {_numbers(each)} |")
    return lines


def _words(each: Plan, order: Order) -> str:
    """The row's name and what its assets were asked for."""
    names = (each.row.asset, *each.row.others)
    asked = [f'"{words_of(name, order)[-1]}"' for name in names]
    settings = [text.replace("=", " ", 1) for text in ASSETS[each.row.asset].options]
    return "<br>".join([f"**{each.row.name}**", *asked, *(f"`{text}`" for text in settings)])


def _numbers(each: Plan) -> str:
    numbers = (each.result or {})["numbers"]
    return "<br>".join(f"{LABELS[name]}: {value}" for name, value in numbers.items())


def _strip(each: Plan, out: Path) -> None:
    """The row's pictures next to each other as one JPEG."""
    files = [each.folder / name for name in (each.result or {})["pictures"]]
    pictures = [Image.open(file).convert("RGB") for file in files]
    width = sum(picture.width + GAP for picture in pictures) - GAP
    strip = Image.new("RGB", (width, max(picture.height for picture in pictures)), "white")
    x = 0
    for picture in pictures:
        strip.paste(picture, (x, 0))
        x += picture.width + GAP
    packed = io.BytesIO()
    strip.save(packed, "JPEG", quality=QUALITY, optimize=True)
    with atomic_file(out) as temporary:
        temporary.write_bytes(packed.getvalue())
