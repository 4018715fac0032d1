"""What phrases of their own state: emblems, poses, moods, cuts, styles. Standard library only."""
