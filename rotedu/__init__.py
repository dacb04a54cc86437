"""The code behind an executable edition of a paper on rotations without quaternions.

The paper is F. Cheng et al., "We Don't Really Need Quaternions in Geometric Modeling, Computer
Graphics and Animation: Here Is Why", Computer-Aided Design & Applications 20(6), 2023, 1061-1073,
doi:10.14733/cadaps.2023.1061-1073. One module serves one section; every function names the
equation it computes.

Conventions, the same everywhere:

- The axes U, V, W are right-handed; rotations are active, counterclockwise seen from the tip of
  the axis. Vectors are columns, matrices act from the left, so ``A @ B`` does B first.
- Angles are in radians. Quaternions put the scalar first, ``[w, (x, y, z)]``.
- Points have shape (..., 3), matrices (..., 3, 3) or (..., 4, 4); the leading axes broadcast.
- The result is float32 if an argument is a float32 array and no argument is an array or a NumPy
  number of another floating type (Python numbers, sequences of them and integer arrays adapt),
  else float64.
- Arguments that must be unit vectors are normalised; those that must be rotations, and are to half
  of their digits, are taken to the nearest rotation. An argument that is zero where it must not be,
  not finite, of the wrong shape or no rotation is a `ValueError` that names it. A geometry without
  an answer is a `rotedu.errors.DegenerateError`, which is a `ValueError` too.
- Arrays of dtype object that hold anything but numbers, such as the counting scalars of
  `rotedu.cost` or symbols, are computed with as they are: their shapes are checked, their values
  are not, and vectors of them are taken to be unit vectors where unit vectors are expected.
"""

__all__ = ["__version__"]

__version__ = "0.1.0"
