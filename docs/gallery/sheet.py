"""The model card's picture of what ``run.py bench prior`` made: docs/images/bench.jpg.

``run.py python docs/gallery/sheet.py``: all that out/bench_prior has, each over its prompt.
"""

import json
from pathlib import Path

from PIL import Image, ImageDraw

ROOT = Path(__file__).resolve().parents[2]
RUNS = ROOT / "out" / "bench_prior"
IMAGES = ROOT / "docs" / "images"
SIDE = 220  # pixels, of one asset
LINE = 14  # of the words below it
COLUMNS = 5


def sheet(runs: list[Path], side: int, columns: int, out: Path) -> None:
    """The previews of run folders in rows, each over its prompt."""
    high = side + LINE
    rows = -(-len(runs) // columns)
    page = Image.new("RGB", (columns * side, rows * high), "white")
    draw = ImageDraw.Draw(page)
    for i, run in enumerate(runs):
        left, top = i % columns * side, i // columns * high
        preview = Image.open(run / "asset" / "preview.png").convert("RGB")
        page.paste(preview.resize((side, side), Image.Resampling.LANCZOS), (left, top))
        prompt = json.loads((run / "job.json").read_text("utf-8"))["prompt"]
        draw.text((left + side / 2, top + side), prompt, "black", anchor="ma", font_size=12)
    page.save(out, quality=86, optimize=True)


if __name__ == "__main__":
    every = sorted(score.parent for score in RUNS.glob("*/score.json"))
    sheet(every, SIDE, COLUMNS, IMAGES / "bench.jpg")
