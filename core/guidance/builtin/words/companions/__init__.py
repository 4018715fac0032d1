"""Things with a thing: worn, held, beside, on and in it. Standard library only."""
