"""The interface: properties, preferences, panels and operators."""
