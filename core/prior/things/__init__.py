"""The families: what each noun's objects are made of.

Front is -Y, up is +Z. Everything a picture of 64² shall show is at least about 4 pixels wide: legs,
handles and walls are thicker than in life. The units are arbitrary; ``families.normalised`` scales.
A family's solid lies within 1.6 of the z axis along x and y, and within z of -1.6 to 3.2.
"""
