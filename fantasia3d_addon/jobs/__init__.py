"""Jobs of the core: queue, processes, progress, history, and the import of their results."""
