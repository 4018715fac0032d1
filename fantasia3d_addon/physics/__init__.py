"""Rigid body, soft body, cloth and draping, simulated on simple proxies and baked."""
