"""The scene around an asset: light, camera, render, turntable, Cornell box, placement."""
