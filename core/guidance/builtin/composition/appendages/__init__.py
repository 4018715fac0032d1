"""Wings, horns, ears and tails that a thing does not have by itself: simple solids on its body."""
