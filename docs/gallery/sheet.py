"""The model card's pictures, of what ``run.py bench prior`` made.

``run.py python docs/gallery/sheet.py``: docs/images/bench.jpg shows every noun with both seeds,
failures.jpg the worst of them.
"""

import json
from pathlib import Path

from PIL import Image, ImageDraw

ROOT = Path(__file__).resolve().parents[2]
RUNS = ROOT / "out" / "bench_prior"
IMAGES = ROOT / "docs" / "images"
FAILURES = "truck-1 vase-0 flower-1 pineapple-0 robot-0 bookshelf-0 tower-1 church-1".split()
SIDE = 150  # pixels, of one asset
LINE = 14  # of the words below it
COLUMNS = 12


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
        draw.text((left + side / 2, top + side), prompt, "black", anchor="ma", font_size=10)
    page.save(out, quality=86, optimize=True)


if __name__ == "__main__":
    every = sorted(score.parent for score in RUNS.glob("*/score.json"))
    sheet(every, SIDE, COLUMNS, IMAGES / "bench.jpg")
    sheet([RUNS / run for run in FAILURES], 220, 4, IMAGES / "failures.jpg")
