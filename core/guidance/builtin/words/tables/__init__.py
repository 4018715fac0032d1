"""What is known about words, as data. Standard library only."""
