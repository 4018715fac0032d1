"""Things that are put together from simple solids, exactly: no network draws them."""
