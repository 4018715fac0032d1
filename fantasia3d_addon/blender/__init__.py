"""What the other folders need of bpy: version differences, mesh arrays, names, PNG files."""
