"""``run.py reproduce``: the paper's figures, made again, and the page that shows them."""
