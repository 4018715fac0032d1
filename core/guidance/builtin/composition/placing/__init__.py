"""The place of each thing: on, in, worn, held, in a row."""
