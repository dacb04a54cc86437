"""The code behind an executable edition of a paper on rotations without quaternions.

The paper is F. Cheng et al., "We Don't Really Need Quaternions in Geometric Modeling, Computer
Graphics and Animation: Here Is Why", Computer-Aided Design & Applications 20(6), 2023, 1061-1073,
doi:10.14733/cadaps.2023.1061-1073. Each module serves one section, or a page beyond the paper, and
every function names the equation that it computes.

Conventions, the same everywhere:

- The axes U, V, W are right-handed; rotations are active, anticlockwise seen from the tip of
  the axis. Vectors are columns, matrices act from the left, so ``A @ B`` does B first.
- Angles are in radians. Quaternions put the scalar first, ``[w, (x, y, z)]``.
- Points have shape (..., 3), matrices (..., 3, 3) or (..., 4, 4); the leading axes broadcast.
- The result is float32 if an argument is a float32 array and no argument is an array or a NumPy
  number of another floating type (Python numbers, sequences of them and integer arrays adapt),
  else float64.
- Arguments that must be unit vectors are normalised. A matrix M that must be a rotation is replaced
  by the nearest one if no entry of M^T M differs from the identity's by more than 1e-3; single
  precision and four decimals leave less. An argument that is zero where it must not be, not finite,
  of the wrong shape or not a rotation raises a `ValueError` that names it. A geometry without an
  answer raises `rotedu.errors.DegenerateError`, which is a `ValueError` too.
- *To half of the digits* is to within 1.5e-8, or 3.5e-4 in float32.
- Arrays of dtype object may hold something other than numbers, such as the counting scalars of
  `rotedu.cost` or symbols. Their shapes are checked and their values are not. Where a unit vector
  is expected, they must already be one.
"""

__all__ = ["__version__"]

__version__ = "2.0.0"
