"""Break the code of every equation, one edit at a time, and see whether a test notices.

``python tools/mutations.py`` makes each edit of MUTATIONS in a copy of the package, runs the tests
of that module on it until one fails, and prints the score; it ends with 1 if an edit went
unnoticed. Names of modules as arguments keep it to those. It takes a few minutes, so it is no
part of ``make test``; that only checks that the edits still fit the code.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import SimpleQueue

ROOT = Path(__file__).parents[1]

# For each module: what equation the code is of, the code, which is there once, and a wrong one.
MUTATIONS: dict[str, list[tuple[str, str, str]]] = {
    "quaternions": [
        (
            "(2-1)",
            "components[..., 0], components[..., 1:] = w, v",
            "components[..., 3], components[..., :3] = w, v",
        ),
        (
            "(2-2) +",
            "Quaternion._of(self.components + other.components)",
            "Quaternion._of(self.components - other.components)",
        ),
        (
            "(2-2) -",
            "Quaternion._of(self.components - other.components)",
            "Quaternion._of(other.components - self.components)",
        ),
        ("(2-3)", "w1 * w2 - _dot(v1, v2)", "w1 * w2 + _dot(v1, v2)"),
        ("(2-3)", "np.cross(v1, v2)", "np.cross(v2, v1)"),
        ("(2-3)", "w1 * v2 + w2 * v1", "w1 * v2 - w2 * v1"),
        ("(2-3)", "w1 * v2 + w2 * v1", "w1 * v1 + w2 * v2"),
        ("(2-3)", "w2 * v1 + np.cross", "w2 * v1 - np.cross"),
        ("conjugate", "_joined(self.w, -self.v)", "_joined(self.w, self.v)"),
        ("conjugate", "_joined(self.w, -self.v)", "_joined(-self.w, self.v)"),
        ("norm", "return length(self.components)", "return length(self.components) ** 2"),
        (
            "(2-4)",
            "conjugate().components / _dot(q, q) / size",
            "conjugate().components / _dot(q, q)",
        ),
        ("(2-4)", "Quaternion._of(q).conjugate().components", "Quaternion._of(q).components"),
        ("(2-4)", "conjugate().components / _dot(q, q) / size", "conjugate().components / size"),
        (
            "(2-4) symbols",
            "self.conjugate().components / _dot(q, q)",
            "self.components / _dot(q, q)",
        ),
        ("(2-4) zero", "_refuse_zero((q == 0).all(axis=-1))", ""),
        ("(2-5)", "return self * other.inverse()", "return other.inverse() * self"),
        ("(2-5)", "return self * other.inverse()", "return self * other"),
        ("(2-5) numbers", "_of(q / w[..., np.newaxis])", "_of(q * w[..., np.newaxis])"),
        ("numbers", "return -self + other", "return self - other"),
        ("numbers", "return self.inverse() * other", "return self * other"),
        ("numbers", "__radd__ = __add__", "__radd__ = __sub__"),
        ("negative", "Quaternion._of(-self.components)", "Quaternion._of(self.components)"),
        ("equality", ".astype(bool).all(axis=-1)", ".astype(bool).any(axis=-1)"),
        ("inequality", "return ~(self == other)", "return self == other"),
        ("half angle", "half = theta[..., np.newaxis] / 2", "half = theta[..., np.newaxis]"),
        ("half angle", "half = theta[..., np.newaxis] / 2", "half = theta[..., np.newaxis] / 3"),
        (
            "half angle",
            "np.cos(half)[..., 0], np.sin(half) *",
            "np.cos(half)[..., 0], -np.sin(half) *",
        ),
        (
            "half angle",
            "np.cos(half)[..., 0], np.sin(half) *",
            "np.sin(half)[..., 0], np.cos(half) *",
        ),
        ("half angle", 'np.sin(half) * unit("axis", n)', "np.sin(half) * n"),
        ("axis, angle", "2 * np.arctan2(_dot(axis, v), w)", "np.arctan2(_dot(axis, v), w)"),
        (
            "axis, angle",
            "2 * np.arctan2(_dot(axis, v), w)",
            "2 * np.arctan2(_dot(axis, v), abs(w))",
        ),
        ("axis, angle", "2 * np.arctan2(_dot(axis, v), w)", "2 * np.arccos(w)"),
        ("axis, angle", "np.eye(3, dtype=int)[0], v)", "np.eye(3, dtype=int)[1], v)"),
        ("(2-6)", "r + w * twice + np.cross(v, twice)", "r - w * twice + np.cross(v, twice)"),
        ("(2-6)", "r + w * twice + np.cross(v, twice)", "r + w * twice + np.cross(twice, v)"),
        ("(2-6)", "twice = 2 * np.cross(v, r)", "twice = np.cross(v, r)"),
        ("(2-6)", "twice = 2 * np.cross(v, r)", "twice = 2 * np.cross(r, v)"),
        ("(2-6) U", "cos * rv - sin * rw", "cos * rv + sin * rw"),
        ("(2-6) U", "cos * rv - sin * rw", "cos * rv - rw"),
        ("(2-6) U", "cos * rw + sin * rv", "cos * rw - sin * rv"),
        ("(2-6) U", "np.broadcast_arrays(ru, cos", "np.broadcast_arrays(ru * cos, cos"),
        ("matrix", "xy - wz", "xy + wz"),
        ("matrix", "xz + wy", "xz - wy"),
        ("matrix", "yz - wx", "yz + wx"),
        ("matrix", "1 - (xx + zz)", "1 - (xx + yy)"),
        ("matrix", "x * x2, y * y2, z * z2", "x * x2, y * y2, z * z"),
        (
            "matrix",
            "np.moveaxis(matrix, (0, 1), (-2, -1))",
            "np.moveaxis(matrix, (0, 1), (-1, -2))",
        ),
        ("unit", 'unit("quaternion", self.components)', "self.components"),
        ("immutable", "array.flags.writeable = False", ""),
        ("numpy", "__array_ufunc__: ClassVar[None] = None", ""),
    ],
    "ordinary_rotation": [
        ("(3-3)", "k * nu * nv - sin * nw", "k * nu * nv + sin * nw"),
        ("(3-3)", "k * nu * nw - sin * nv", "k * nu * nw + sin * nv"),
        ("(3-3)", "k * nv * nw + sin * nu", "k * nv * nw - sin * nu"),
        ("(3-3)", "k * nu * nv + sin * nw", "k * nu * nv - sin * nw"),
        ("(3-3)", "k * nu * nw + sin * nv", "k * nu * nw - sin * nv"),
        ("(3-3)", "k * nv * nw - sin * nu", "k * nv * nw + sin * nu"),
        ("(3-3)", "cos + k * nu * nu", "cos + k * nu * nv"),
        ("(3-3)", "cos + k * nv * nv", "cos + k * nu * nv"),
        ("(3-3)", "cos + k * nw * nw", "cos + k * nw * nv"),
        ("(3-3)", "k = 1 - cos", "k = 1 + cos"),
        ("(3-3)", "(0, 1), (-2, -1)", "(0, 1), (-1, -2)"),
        ("(3-1)", "np.cross(n, r)", "np.cross(r, n)"),
        ("(3-1)", "(1 - cos) * _dot", "(1 + cos) * _dot"),
        ("(3-1)", "= cos * r + (1 - cos)", "= r + (1 - cos)"),
        ("(3-1)", "+ sin * np.cross", "- sin * np.cross"),
        ("(3-1)", 'unit("axis", n), theta', "n, theta"),
        ("(3-3)", 'unit("axis", n), -1', "n, -1"),
        (
            "(3-2)",
            "np.asfortranarray(matrix).dot(points.T)",
            "np.asfortranarray(matrix.T).dot(points.T)",
        ),
        (
            "(3-2)",
            "reshape(-1, 3)).reshape(*points.shape[:-1], len",
            "reshape(-1, 3)).reshape(-1, len",
        ),
        ("columns", "columns.T.reshape(*points.shape[:-1], len", "columns.T.reshape(-1, len"),
        ("(3-2)", "np.asarray(matrix @ points)", "np.asarray(points @ matrix)"),
        ("(3-2)", "(matrix @ points[..., np.newaxis])", "(matrix.mT @ points[..., np.newaxis])"),
        ("(3-2)", "moved += m[..., : linear", "moved -= m[..., : linear"),
        ("(3-2)", "    if homogeneous:\n", "    if projective:\n"),
        ("(3-2)", "m[..., : 3 + projective, :3]", "m[..., :3, :3]"),
        ("(3-2) divide", "(0, 0, 0, 1)).all()", "(0, 0, 0, 1)).any()"),
        ("(3-2) divide", "and not (m[..., 3, :]", "and (m[..., 3, :]"),
        ("(3-2) divide", "moved[..., :3] / moved[..., 3:]", "moved[..., :3]"),
        ("(3-2) divide", "moved[..., :3] / moved[..., 3:]", "moved[..., :3] * moved[..., 3:]"),
        ("(3-2) divide", "infinite = moved[..., 3] == 0", "infinite = moved[..., 3] <= 0"),
        ("(3-2) divide", "infinite = moved[..., 3] == 0", "infinite = moved[..., 2] == 0"),
        ("(3-2) divide", "    if infinite.any():", "    if infinite.all():"),
        ("(3-2) objects", '"O" in (m.dtype.char, r.dtype.char)', '"O" == r.dtype.char'),
        ("(3-2) objects", '"O" in (m.dtype.char, r.dtype.char)', '"O" == m.dtype.char'),
        ("(3-2) stacks", " or m.ndim > 2 or ", " or "),
        ("(3-2) finite", '    require_finite("matrix", m)', ""),
        ("(3-2) finite", '        require_finite("points", r)', ""),
        (
            "(3-2) finite",
            'if out is points:\n        require_finite("points", points)',
            "if out is points:\n        pass",
        ),
        ("(3-2) finite", "if out is not points and not (", "if not ("),
        ("(3-2) finite", "(matrix[0].all() and math", "(math"),
        ("(3-2) finite", "(matrix[0].all() and math", "(matrix[1].all() and math"),
        ("(3-2) finite", "np.vdot(images[0], images[0])", "np.vdot(images[1], images[1])"),
        ("(3-2) finite", "squares += float(np.vdot(images[0]", "squares = float(np.vdot(images[0]"),
        ("(3-2) finite", "squares += float(np.vdot(images,", "squares = float(np.vdot(images,"),
        ("(3-2) finite", "math.isfinite(squares)", "True"),
        ("(3-2) finite", 'invalid="ignore", over="ignore"', 'over="ignore"'),
        ("(3-2) finite", 'invalid="ignore", over="ignore"', 'invalid="ignore"'),
        ("(3-2) as it is", "and matrix.shape == (3, 3)", ""),
        ("(3-2) as it is", "and points.shape[-1:] == (3,)", ""),
        ("(3-2) as it is", "and matrix.dtype is points.dtype is DOUBLE", ""),
        ("(3-2) out=", "        _require_like_result(out, m, r)", "        pass"),
        ("(3-2) out=", "not isinstance(out, np.ndarray) or (out", "(out"),
        ("(3-2) out=", "(out.shape, out.dtype) != (shape, dtype)", "out.shape != shape"),
        ("(3-2) out=", "(out.shape, out.dtype) != (shape, dtype)", "out.dtype != dtype"),
        (
            "(3-2) out=",
            "(*np.broadcast_shapes(m.shape[:-2], r.shape[:-1]), 3)",
            "(*r.shape[:-1], 3)",
        ),
        ("(3-2) out=", "dtype = np.result_type(m, r)", "dtype = r.dtype"),
        (
            "(3-2) out=",
            "_multiply_many(linear, r, None if projective else out)",
            "_multiply_many(linear, r, out)",
        ),
        ("(3-2) out=", "        out[...] = moved", "        pass"),
        ("(3-2) out=", "out[...] = moved\n    return out", "out[...] = moved\n    return moved"),
        ("(3-2) out=", "        points = points.copy()", "        pass"),
        ("(3-2) out=", "out is not None and out.flags.c_contiguous", "out is not None"),
        ("columns", "range(0, len(points), BLOCK)", "range(0, len(points) - BLOCK, BLOCK)"),
        ("columns", "columns[:, start : start + BLOCK]", "columns[:, : len(r)]"),
        ("columns", "m, squares = np.asfortranarray(matrix)", "m, squares = matrix.T.copy()"),
        ("rows", "range(0, len(points), CACHED)", "range(0, len(points) - CACHED, CACHED)"),
        ("rows", "rows[start : start + CACHED]", "rows[: len(r)]"),
        ("rows", "np.ascontiguousarray(matrix.T)", "np.ascontiguousarray(matrix)"),
        ("axis, angle", "2 * np.arctan2", "np.arctan2"),
        ("axis, angle", "sign < 0", "sign > 0"),
        ("axis, angle", "1 - trace + 2 * diagonal", "1 - trace + diagonal"),
        ("axis, angle", "np.where(half_turn, np.take_along_axis(axis, first, axis=-1), w)", "w"),
        (
            "axis, angle",
            "largest = np.argmax(squares, axis=-1)",
            "largest = np.argmin(squares, axis=-1)",
        ),
        (
            "axis, angle",
            "largest = np.argmax(squares, axis=-1)",
            "largest = 0 * np.argmax(squares, axis=-1)",
        ),
    ],
    "_validation": [
        ("finite", "        require_finite(name, array)", "        pass"),
        (
            "finite",
            "or math.isfinite(np.vdot(array, array))",
            "or not math.isnan(np.vdot(array, array))",
        ),
        ("finite", 'array.dtype.char == "O" or ', ""),
        ("finite", "finite = np.isfinite(array)", "finite = ~np.isnan(array)"),
        ("finite", "    if not finite.all():", "    if True:"),
        ("numbers", "element is None", "element is NotImplemented"),
        ("numbers", 'not in "iufO"', 'not in "bciufO"'),
        (
            "float32",
            "floating == {np.dtype(np.float32)}",
            "np.dtype(np.float32) in floating",
        ),
        ("float32", ' and hasattr(values[name], "dtype")', ""),
        ("float32", 'with np.errstate(over="ignore"):\n        return', "if True:\n        return"),
        ("shapes", "isinstance(axis, str) or axis == length", "True"),
        ("shapes", "lengths |= {axis: length", "_ = {axis: length"),
        ("unit", "    if zero.any():", "    if False:"),
        ("unit", "    return normalised(vectors)", "    return vectors"),
        (
            "unit",
            "scaled: Array = vectors / np.abs(vectors).max(axis=-1, keepdims=True)",
            "scaled: Array = vectors",
        ),
        ("length", "np.where(largest == 0, 1, largest)", "largest"),
        ("length", "np.asarray(largest[..., 0] * np.sqrt(", "np.asarray(np.sqrt("),
        ("rotation", "matrices.mT @ matrices - np.eye(3)", "matrices @ matrices - np.eye(3)"),
        ("rotation", "np.sqrt(np.finfo(matrices.dtype).eps)", "4 * np.finfo(matrices.dtype).eps"),
        ("rotation", "(determinant < 0).any()", "(determinant < 0).all()"),
        ("place", "np.argwhere(mask)[0])", "np.argwhere(mask)[-1])"),
    ],
    "general_rotation": [
        ("M_u", "[0, cos, -sin, 0], [0, sin, cos, 0]", "[0, cos, sin, 0], [0, -sin, cos, 0]"),
        ("M_v", "[cos, 0, sin, 0], [0, 1, 0, 0], [-sin,", "[cos, 0, -sin, 0], [0, 1, 0, 0], [sin,"),
        ("M_w", "[cos, -sin, 0, 0], [sin, cos, 0, 0]", "[cos, sin, 0, 0], [-sin, cos, 0, 0]"),
        ("(4-2)", "[cv * cw,", "[cv * cu,"),
        ("(4-2)", "su * sv * cw - cu * sw", "su * sv * cw + cu * sw"),
        ("(4-2)", "cu * sv * cw + su * sw", "cu * sv * cw - su * sw"),
        ("(4-2)", "[cv * sw,", "[cv * su,"),
        ("(4-2)", "su * sv * sw + cu * cw", "su * sv * sw - cu * cw"),
        ("(4-2)", "cu * sv * sw - su * cw", "cu * sv * sw + su * cw"),
        ("(4-2)", "[-sv, su * cv, cu * cv, 0]", "[sv, su * cv, cu * cv, 0]"),
        ("(4-2)", "[-sv, su * cv, cu * cv, 0]", "[-sv, cu * cv, su * cv, 0]"),
        ("(4-3)", "a[unturned] = 1, 0, 0", "a[unturned] = 0, 1, 0"),
        ("(4-3)", "a[unturned] = 1, 0, 0", ""),
        ("(4-3)", "a = a / np.where(unturned, 1, sine)[..., np.newaxis]", ""),
        ("(4-3)", "unturned = sine <= _rounding(angles)", "unturned = sine == 0"),
        ("(4-3)", "unturned = sine <= _rounding(angles)", "unturned = sine <= 1e-15"),
        ("(4-4) alpha", "su * cv * cw - cu * sv * sw", "su * cv * cw + cu * sv * sw"),
        ("(4-4) beta", "cu * sv * cw + su * cv * sw", "cu * sv * cw - su * cv * sw"),
        ("(4-4) gamma", "cu * cv * sw - su * sv * cw", "cu * cv * sw + su * sv * cw"),
        ("(4-4)", "halves = [theta / 2 for", "halves = [theta for"),
        ("(4-4)", "halves = [theta / 2 for", "halves = [theta / 3 for"),
        (
            "(4-5)",
            "2 * np.arctan2(np.where(unturned, 0, sine), cosine)",
            "2 * np.arcsin(np.clip(sine, 0, 1))",
        ),
        (
            "(4-5)",
            "2 * np.arctan2(np.where(unturned, 0, sine), cosine)",
            "2 * np.arctan2(sine, cosine)",
        ),
        ("(4-6)", "cu * cv * cw + su * sv * sw", "cu * cv * cw - su * sv * sw"),
        ("(4-5), (4-6)", "2 * np.arctan2(np.where", "np.arctan2(np.where"),
        ("(4-7)", "_matrix(*([*row, 0] for", "_matrix(*([*row, 1] for"),
        ("(4-7)", "np.moveaxis(m, (-2, -1), (0, 1))", "np.moveaxis(m, (-2, -1), (1, 0))"),
        ("(4-7)", "(*rows, [0, 0, 0, 1])", "(*rows, [0, 0, 0, 0])"),
        ("translation", "[1, 0, 0, u], [0, 1, 0, v]", "[1, 0, 0, v], [0, 1, 0, u]"),
        ("translation", "[0, 0, 1, w])", "[0, 0, 1, -w])"),
        ("scaling", "[0, v, 0, 0], [0, 0, w, 0])", "[0, w, 0, 0], [0, 0, v, 0])"),
        ("shearing", "[vu, 1, vw, 0]", "[uv, 1, vw, 0]"),
        ("shearing", "[wu, wv, 1, 0]", "[wv, wu, 1, 0]"),
        ("reflection", "[1 - 2 * nu * nu,", "[1 - nu * nu,"),
        ("reflection", "-2 * nw * nv, 1 - 2 * nw * nw", "2 * nw * nv, 1 - 2 * nw * nw"),
        ("reflection", 'unit("normal", n)', "n"),
        ("perspective", "-1 / d, 1])", "1 / d, 1])"),
        ("perspective", "[0, 0, 1, 0], [0, 0, -1 / d", "[0, 0, 0, 0], [0, 0, -1 / d"),
        ("(4-1)", "reduce(np.matmul, factors)", "reduce(np.matmul, factors[::-1])"),
    ],
    "interpolation": [
        ("theta", "np.asarray(2 * np.arctan2(length(q - p)", "np.asarray(np.arctan2(length(q - p)"),
        (
            "theta",
            "2 * np.arctan2(length(q - p), length(q + p))",
            "np.arccos((p * q).sum(axis=-1).clip(-1, 1))",
        ),
        (
            "theta",
            "2 * np.arctan2(length(q - p), length(q + p))",
            "2 * np.arcsin(length(q - p) / 2)",
        ),
        ("(5-1)", "np.cross(q + p, q - p, axis=0)", "np.cross(q - p, q + p, axis=0)"),
        ("(5-1)", "np.cross(q + p, q - p, axis=0)", "np.cross(p, q, axis=0)"),
        ("(5-1)", "np.asarray(axis / _length(axis))", "axis"),
        ("(5-1)", "coincident = _length(q - p) <= 4 * _eps(p)", "coincident = _length(q - p) < 0"),
        (
            "(5-1)",
            "coincident = _length(q - p) <= 4 * _eps(p)",
            "coincident = _length(q - p) < 1e-8",
        ),
        ("(5-2)", "turn = (t - 1 / 2) * theta", "turn = (t - 1 / 3) * theta"),
        ("(5-2)", "turn = (t - 1 / 2) * theta", "turn = (1 / 2 - t) * theta"),
        ("(5-2)", "chord, middle = q - p, _sum(p, q)", "chord, middle = p - q, _sum(p, q)"),
        ("(5-2)", "chord, middle = q - p, _sum(p, q)", "chord, middle = q - p, q + p"),
        ("(5-2)", "theta = 2 * np.arctan2(sine, cosine)", "theta = np.arctan2(sine, cosine)"),
        ("(5-2)", "theta = 2 * np.arctan2(sine, cosine)", "theta = 2 * np.arctan2(cosine, sine)"),
        ("(5-2)", "theta = 2 * np.arctan2(sine, cosine)", "theta = 2 * np.arcsin(sine / 2)"),
        ("(5-2)", "np.sin(turn) / _or_one(sine) * chord", "np.sin(turn) / sine * chord"),
        ("(5-2)", "np.sin(turn) / _or_one(sine) * chord", "np.sin(turn) / 2 * chord"),
        ("(5-2)", "np.cos(turn) / cosine * middle", "np.cos(turn) / 2 * middle"),
        ("(5-2)", "_dot(total, chord) / 4 * chord", "_dot(total, chord) / 2 * chord"),
        (
            "(5-2)",
            "_dot(total, chord) / 4 * chord",
            "_dot(total, chord) / _or_one(_dot(chord, chord)) * chord",
        ),
        (
            "(5-3)",
            "rotation_matrix(axis, t * theta), _comp",
            "rotation_matrix(axis, -t * theta), _comp",
        ),
        ("(5-3)", "rotation_matrix(axis, t * theta), _comp", "rotation_matrix(axis, theta), _comp"),
        (
            "(5-3)",
            "np.asarray(2 * np.arctan2(_length(q - p)",
            "np.asarray(np.arctan2(_length(q - p)",
        ),
        ("(5-3)", "lost = _length(axis) <= 8 * _eps(p)", "lost = _length(axis) < 0"),
        ("(5-4), (5-13)", "2 * _dot(p, q) * q - p", "2 * _dot(p, q) * p - q"),
        ("(5-4), (5-13)", "2 * _dot(p, q) * q - p", "2 * _dot(p, q) * q + p"),
        ("(5-4), (5-13)", "2 * _dot(p, q) * q - p", "_dot(p, q) * q - p"),
        ("(5-5), (5-14)", "_arc_by_rotation(p, q, 2)", "_arc_by_rotation(p, q, 1)"),
        ("(5-5), (5-14)", "_arc_by_rotation(p, q, 2)", "_arc_by_rotation(q, p, 2)"),
        ("(5-7), (5-10)", "np.asarray(middle / _length(middle))", "np.asarray(middle / 2)"),
        ("(5-8), (5-11)", "_arc_by_rotation(p, q, 0.5)", "_arc_by_rotation(p, q, 1 / 3)"),
        ("(5-8), (5-11)", "_arc_by_rotation(p, q, 0.5)", "_arc_by_rotation(p, q, -0.5)"),
        ("(5-4) of a_i", "space.double(before, here)", "space.double(here, before)"),
        ("(5-4) of a_i", "space.double(before, here)", "space.double(after, here)"),
        (
            "(5-7) of a_i",
            "space.bisect(reflected, after)",
            "space.arc(reflected, after, 1 / 3)",
        ),
        ("(5-7) of a_i", "space.bisect(reflected, after)", "space.bisect(before, after)"),
        ("(5-10) of a_i", "space.arc(here, middle, fraction)", "space.arc(middle, here, fraction)"),
        ("(5-10) of a_i", "space.arc(here, middle, fraction)", "space.arc(here, middle, 1 / 2)"),
        ("(5-10) of a_i", "space.arc(here, middle, fraction)", "space.arc(here, middle, 1 / 3)"),
        ("(5-13) of b_i", "return a, space.double(a, here)", "return a, space.double(here, a)"),
        ("(5-13) of b_i", "return a, space.double(a, here)", "return space.double(a, here), a"),
        ("neighbours", "by) for by in (-1, 1))", "by) for by in (1, -1))"),
        ("neighbours", "np.arange(by, n + by)", "np.arange(-by, n - by)"),
        ("neighbours", 'mode="wrap"', 'mode="clip"'),
        ("neighbours", 'space.axis, mode="wrap"', '-1, mode="wrap"'),
        ("neighbours", '"antipodal", axis=-1', '"antipodal", axis=0'),
        ("neighbours", "axis=-3,\n)", "axis=0,\n)"),
        (
            "fraction",
            'fraction: float = 1 / 2\n) -> Array:\n    """Draw a closed composite',
            'fraction: float = 1 / 3\n) -> Array:\n    """Draw a closed composite',
        ),
        (
            "fraction",
            "points: npt.ArrayLike, fraction: float = 1 / 2) -> tuple",
            "points: npt.ArrayLike, fraction: float = 1 / 3) -> tuple",
        ),
        ("segments", "return here, a, next_b, after", "return here, next_b, a, after"),
        (
            "segments",
            "_shifted(space, x, 1) for x in (b, here)",
            "_shifted(space, x, -1) for x in (b, here)",
        ),
        (
            "segments",
            "_shifted(space, x, 1) for x in (b, here)",
            "_shifted(space, x, 1) for x in (a, here)",
        ),
        (
            "segments",
            '_segments(SPHERE, "points", p, part), axis=1)',
            '_segments(SPHERE, "points", p, part), axis=0)',
        ),
        (
            "segments",
            "reshape(4, -1, 9).transpose(2, 0, 1)",
            "reshape(-1, 4, 9).transpose(2, 1, 0)",
        ),
        (
            "pseudocode",
            "slerp(points[:, :-1], points[:, 1:], u)",
            "slerp(points[:, 1:], points[:, :-1], u)",
        ),
        (
            "pseudocode",
            "slerp(points[:, :-1], points[:, 1:], u)",
            "slerp(points[:, :-1], points[:, -1:], u)",
        ),
        ("pseudocode", "while points.shape[1] > 1:", "while points.shape[1] > 2:"),
        (
            "pseudocode",
            "u = (np.arange(samples) / samples)",
            "u = ((np.arange(samples) + 1) / samples)",
        ),
        (
            "pseudocode",
            "u = (np.arange(samples) / samples)",
            "u = (np.arange(samples) / max(1, samples - 1))",
        ),
        (
            "blocks",
            "step = max(1, BLOCK // (samples * components))",
            "step = BLOCK // (samples * components)",
        ),
        ("blocks", "range(0, n, step)", "range(0, n - 1, step)"),
        ("blocks", "control[:, :, segments, np", "control[:, :, :step, np"),
        ("blocks", "control[:, :, segments, np", "control[:, ::-1, segments, np"),
        ("blocks", "points[:, 0].transpose(1, 2, 0)", "points[::-1, 0].transpose(1, 2, 0)"),
        ("float32", "samples, components), control.dtype)", "samples, components))"),
        (
            "(5-2) inside",
            "np.minimum(cosine, 1 - _eps(p))",
            "np.minimum(cosine, 1)",
        ),
        ("(5-2) counted", "if cosine.dtype != object:", "if True:"),
        (
            "(5-2) inside",
            "np.minimum(cosine, 1 - _eps(p))",
            "np.minimum(cosine, 1 - 2**-53)",
        ),
        (
            "(5-2) inside",
            "np.minimum(cosine, 1 - _eps(p))",
            "np.minimum(cosine, 1 - 1e-7)",
        ),
        (
            "(5-2) inside",
            "np.minimum(cosine, 1 - _eps(p))",
            "cosine - _eps(p)",
        ),
        (
            "(5-2) near pi",
            "if cosine.min() < NEAR_PI:\n        return _arc(p, q, t)",
            "if cosine.max() < NEAR_PI:\n        return _arc(p, q, t)",
        ),
        (
            "(5-2) near pi",
            "if cosine.min() < NEAR_PI:\n        return _arc(p, q, t)",
            "if cosine.min() < -1:\n        return _arc(p, q, t)",
        ),
        ("(5-2) near pi", "        return _arc(p, q, t)", "        return _arc(q, p, t)"),
        ("near pi", "NEAR_PI = -0.8", "NEAR_PI = -0.9999"),
        ("(5-2) inside", "_sin_cos(t * np.arccos(cosine))", "_sin_cos(np.arccos(cosine))"),
        (
            "(5-2) inside",
            "_sin_cos(t * np.arccos(cosine))",
            "_sin_cos(t * np.sqrt((1 - cosine) * (1 + cosine)))",
        ),
        ("(5-2) inside", "np.sqrt((1 - cosine) * (1 + cosine))", "np.sqrt(1 - cosine)"),
        ("(5-2) inside", "np.sqrt((1 - cosine) * (1 + cosine))", "np.sqrt(1 - cosine * cosine)"),
        ("(5-2) inside", "(cos - cosine * weight) * p", "(cos + cosine * weight) * p"),
        ("(5-2) inside", "(cos - cosine * weight) * p", "(cos - weight) * p"),
        ("(5-2) inside", "(cos - cosine * weight) * p", "(1 - cosine * weight) * p"),
        ("(5-2) inside", "(cos - cosine * weight) * p", "(1 - weight) * p"),
        ("(5-2) inside", "* p + weight * q", "* q + weight * p"),
        ("sine and cosine", "tan = np.tan(angle / 2)", "tan = np.tan(angle)"),
        ("sine and cosine", "twice = 2 / (1 + tan * tan)", "twice = 2 / (1 - tan * tan)"),
        ("sine and cosine", "twice = 2 / (1 + tan * tan)", "twice = 1 / (1 + tan * tan)"),
        ("sine and cosine", "return tan * twice, twice - 1", "return tan, twice - 1"),
        ("sine and cosine", "return tan * twice, twice - 1", "return tan * twice, 1 - twice"),
        ("sine and cosine", "return tan * twice, twice - 1", "return twice - 1, tan * twice"),
        ("dot product", "np.add.reduce(p * q)", "np.add.reduce(p * p)"),
        ("cross product", "v1 * w2 - w1 * v2", "v1 * w2 + w1 * v2"),
        ("cross product", "v1 * w2 - w1 * v2", "w1 * v2 - v1 * w2"),
        ("cross product", "w1 * u2 - u1 * w2", "w1 * u2 + u1 * w2"),
        ("cross product", "w1 * u2 - u1 * w2", "u1 * w2 - w1 * u2"),
        ("cross product", "u1 * v2 - v1 * u2", "u1 * v2 + v1 * u2"),
        ("cross product", "u1 * v2 - v1 * u2", "v1 * u2 - u1 * v2"),
        ("cross product", "(u1, v1, w1), (u2, v2, w2) = p, q", "(u1, v1, w1), (u2, v2, w2) = q, p"),
        (
            "unique arcs",
            '_require_unique_arc(space, reflected, after, "Double({h}, {i}) and {j}", name)',
            "",
        ),
        (
            "unique arcs",
            '_require_unique_arc(space, here, middle, "{i}',
            '(lambda *_: None)(space, here, middle, "{i}',
        ),
        ("unique arcs", "_require_unique_arc(space, a, next_b, which, name, warn=True)", ""),
        (
            "unique arcs",
            "_require_unique_arc(space, a, next_b, which, name, warn=True)",
            "_require_unique_arc(space, a, next_b, which, name)",
        ),
        ("unique arcs", "initial=1) > NEAR_PI", "initial=1) > -1"),
        ("unique arcs", "initial=1) > NEAR_PI", "initial=1) < NEAR_PI"),
        ("unique arcs", "space.cosine(p, q).min(initial=1)", "space.cosine(p, q).min()"),
        (
            "unique arcs",
            "space.cosine(p, q).min(initial=1)",
            "space.cosine(p, q).max(initial=-1)",
        ),
        ("unique arcs", "if p.dtype == object or q.dtype == object:", "if False:"),
        ("unique arcs", "missing <= space.tolerance(_eps(missing))", "missing <= 0"),
        ("unique arcs", "missing <= space.tolerance(_eps(missing))", "missing <= 1e-6"),
        ("unique arcs", 'np.sqrt, "antipodal"', 'lambda eps: 64 * eps, "antipodal"'),
        (
            "unique arcs",
            "level[:, j], level[:, j + 1], ends)",
            "level[:, 0], level[:, 1], ends)",
        ),
        ("unique arcs", "range(level.shape[1] - 1)", "range(level.shape[1] - 2)"),
        ("unstable", "missing < np.radians(1)", "missing < np.radians(1.2)"),
        ("unstable", "missing < np.radians(1)", "missing < np.radians(0.9)"),
        ("unstable", "stacklevel=4", "stacklevel=3"),
        ("neighbours by name", "for k in (i - 1, i, i + 1)]", "for k in (i + 1, i, i - 1)]"),
        ("neighbours by name", "[*leading, k % n]", "[*leading, k]"),
        ("orientations", "lambda eps: 64 * eps", "np.sqrt"),
        ("orientations", "lambda eps: 64 * eps", "lambda eps: 0"),
        (
            "orientations",
            "axis, angle = axis_angle(r1.mT @ r2)",
            "axis, angle = axis_angle(r2.mT @ r1)",
        ),
        (
            "orientations",
            "axis, angle = axis_angle(r1.mT @ r2)",
            "axis, angle = axis_angle(r2 @ r1.mT)",
        ),
        (
            "orientations",
            "r1 @ rotation_matrix(axis, t * angle)",
            "rotation_matrix(axis, t * angle) @ r1",
        ),
        (
            "orientations",
            "r1 @ rotation_matrix(axis, t * angle)",
            "r1 @ rotation_matrix(axis, angle)",
        ),
        (
            "orientations",
            "return _rotation_arc(r1, r2, 0.5)",
            "return _rotation_arc(r1, r2, 1 / 3)",
        ),
        (
            "orientations",
            "return axis_angle(r1.mT @ r2)[1]",
            "return axis_angle(r1 @ r2)[1]",
        ),
        (
            "trace",
            "((r1 * r2).sum(axis=(-2, -1)) - 1) / 2",
            "((r1 * r2).sum(axis=(-2, -1)) + 1) / 2",
        ),
        (
            "trace",
            "((r1 * r2).sum(axis=(-2, -1)) - 1) / 2",
            "((r1 @ r2).sum(axis=(-2, -1)) - 1) / 2",
        ),
        ("inside", '"ij...,kj...->ik...", r2, r1)', '"ij...,kj...->ik...", r1, r2)'),
        ("inside", '"ij...,kj...->ik...", r2, r1)', '"ji...,jk...->ik...", r2, r1)'),
        ("inside", '"ij...,kj...->ik...", r2, r1)', '"ij...,jk...->ik...", r2, r1)'),
        (
            "inside",
            "(turn[0, 0] + turn[1, 1] + turn[2, 2] - 1) / 2",
            "(turn[0, 0] + turn[1, 1] + turn[2, 2] + 1) / 2",
        ),
        (
            "inside",
            "(turn[0, 0] + turn[1, 1] + turn[2, 2] - 1) / 2",
            "turn[0, 0] + turn[1, 1] + turn[2, 2] - 1",
        ),
        (
            "inside",
            "(turn[0, 0] + turn[1, 1] + turn[2, 2] - 1) / 2",
            "(turn[0, 0] + turn[1, 1] + turn[1, 1] - 1) / 2",
        ),
        (
            "inside near pi",
            "if cosine.min() < NEAR_PI:\n        first",
            "if cosine.max() < NEAR_PI:\n        first",
        ),
        (
            "inside near pi",
            "if cosine.min() < NEAR_PI:\n        first",
            "if cosine.min() < -1:\n        first",
        ),
        (
            "inside near pi",
            "_rotation_arc(first, last, t), (-2",
            "_rotation_arc(last, first, t), (-2",
        ),
        (
            "inside near pi",
            "np.moveaxis(r, (0, 1), (-2, -1))",
            "np.moveaxis(r, (0, 1), (-1, -2))",
        ),
        ("inside near pi", "last, t), (-2, -1), (0, 1))", "last, t), (-2, -1), (1, 0))"),
        ("inside", "turn[2, 1] - turn[1, 2]", "turn[1, 2] - turn[2, 1]"),
        ("inside", "turn[0, 2] - turn[2, 0]", "turn[2, 0] - turn[0, 2]"),
        ("inside", "turn[1, 0] - turn[0, 1]", "turn[0, 1] - turn[1, 0]"),
        ("inside", "axis = np.stack(skew) / 2", "axis = np.stack(skew)"),
        ("inside", "np.maximum(sine, 1e-30)", "sine"),
        ("inside, counted", "if sine.dtype != object:", "if True:"),
        ("inside", "np.maximum(sine, 1e-30)", "np.maximum(sine, 1e-60)"),
        ("inside", "np.maximum(sine, 1e-30)", "np.maximum(sine, 1e-3)"),
        ("inside", "t * np.arctan2(sine, cosine))", "np.arctan2(sine, cosine))"),
        ("inside", "t * np.arctan2(sine, cosine))", "t * np.arctan2(cosine, sine))"),
        ("inside", "t * np.arctan2(sine, cosine))", "t * np.arcsin(np.minimum(sine, 1)))"),
        ("inside", "t * np.arctan2(sine, cosine))", "t * np.arccos(np.minimum(cosine, 1)))"),
        ("inside", "across = _cross(axis, r1)", "across = _cross(r1, axis)"),
        ("inside", "inward = _cross(axis, across)", "inward = _cross(across, axis)"),
        ("inside", "inward = _cross(axis, across)", "inward = _cross(axis, r1)"),
        ("inside", "r1 + sin / sine * across", "r1 - sin / sine * across"),
        ("inside", "r1 + sin / sine * across", "r2 + sin / sine * across"),
        ("inside", "r1 + sin / sine * across", "r1 + sin * across"),
        ("inside", "(1 - cos) / sine / sine * inward", "(1 + cos) / sine / sine * inward"),
        ("inside", "+ (1 - cos) / sine / sine * inward", "- (1 - cos) / sine / sine * inward"),
        ("inside", "(1 - cos) / sine / sine * inward", "(1 - cos) / sine * inward"),
        ("inside", "(1 - cos) / sine / sine * inward", "(1 - cos) / (sine * sine) * inward"),
        ("orientations", "r2 @ r1.mT @ r2", "r1 @ r2.mT @ r1"),
        ("orientations", "r2 @ r1.mT @ r2", "r2 @ r1 @ r2"),
    ],
}


# The tests of a module, if they are not in a file with its name.
TESTS = {"_validation": ["ordinary_rotation", "interpolation"]}


def survives(copy: Path, module: str, code: str, wrong: str) -> bool:
    """Whether the tests of a module pass although its code is wrong."""
    source = (ROOT / "rotedu" / f"{module}.py").read_text("utf-8")
    if source.count(code) != 1:
        raise SystemExit(
            f"{module}: this must be there once, not {source.count(code)} times: {code}"
        )
    tests = [f"tests/test_{name}.py" for name in TESTS.get(module, [module])]
    mutant = copy / "rotedu" / f"{module}.py"
    mutant.write_text(source.replace(code, wrong), "utf-8")
    try:
        options = ["-x", "-q", "-o", "addopts=", "-p", "no:cacheprovider", "--noconftest"]
        run = subprocess.run(
            [sys.executable, "-m", "pytest", *options, *tests],
            cwd=copy,
            env=os.environ | {"PYTHONPATH": str(copy), "PYTHONDONTWRITEBYTECODE": "1"},
            capture_output=True,
            text=True,
            timeout=300,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return False
    finally:
        mutant.write_text(source, "utf-8")
    if run.returncode not in (0, 1, 2):
        raise SystemExit(f"pytest ended with {run.returncode}:\n{run.stdout}{run.stderr}")
    return run.returncode == 0


def main(modules: list[str]) -> int:
    """Run the edits of some modules, or of all, and print the score."""
    edits = [(m, *edit) for m in modules or MUTATIONS for edit in MUTATIONS[m]]
    with tempfile.TemporaryDirectory() as folder:
        copies: SimpleQueue[Path] = SimpleQueue()
        workers = os.cpu_count() or 1
        for number in range(workers):
            copy = Path(folder, str(number))
            for part in ("rotedu", "tests"):
                shutil.copytree(ROOT / part, copy / part)
            shutil.copy(ROOT / "pyproject.toml", copy)
            copies.put(copy)

        def judge(edit: tuple[str, str, str, str]) -> bool:
            module, equation, code, wrong = edit
            copy = copies.get()
            try:
                survived = survives(copy, module, code, wrong)
            finally:
                copies.put(copy)
            verdict = "UNNOTICED" if survived else "noticed"
            print(f"{verdict:9}  {module} {equation}: {code!r} -> {wrong!r}", flush=True)
            return survived

        with ThreadPoolExecutor(workers) as pool:
            survivors = sum(pool.map(judge, edits))
    print(f"{len(edits) - survivors} of {len(edits)} errors in the code were noticed by the tests.")
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
