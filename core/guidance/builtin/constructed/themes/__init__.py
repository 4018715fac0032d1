"""The constructed things, a file a theme: each makes the solids of a thing's parts."""
