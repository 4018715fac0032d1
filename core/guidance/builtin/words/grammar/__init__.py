"""The words of one thing: names, looks, numbers, parts. Standard library only."""
