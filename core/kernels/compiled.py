"""How every loop here is compiled."""

from numba import njit

# Kept on disk; other threads run meanwhile; division by zero gives infinity, as in torch.
compiled = njit(cache=True, nogil=True, error_model="numpy")
