"""What every room needs of bpy: version differences, mesh arrays, names, PNG files."""
