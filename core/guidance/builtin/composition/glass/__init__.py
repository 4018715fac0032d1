"""Things in closed glass."""
