"""Materials that look like their word: detail in the maps, made from noise in the object's space.

The guidance states what the object is made of (``Surface``); each kind of material has a function
(:mod:`core.texture.detail.kinds`) that changes what was learnt: the base colour by a factor,
roughness and metallic by a sum, the normal by the slope of a height. All are functions of the place
in space, so there are no seams where the UV map was cut. Lengths are in units of the object's
longest side.
"""
