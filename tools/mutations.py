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
        ("(3-3)", "cos + k * nw * nw", "cos + k * nw * nv"),
        ("(3-3)", "k = 1 - cos", "k = 1 + cos"),
        ("(3-3)", "(0, 1), (-2, -1)", "(0, 1), (-1, -2)"),
        ("(3-1)", "np.cross(n, r)", "np.cross(r, n)"),
        ("(3-1)", "(1 - cos) * _dot", "(1 + cos) * _dot"),
        ("(3-2)", "points @ matrix.T", "points @ matrix"),
        ("(3-1)", 'unit("axis", n), theta', "n, theta"),
        ("(3-3)", 'unit("axis", n), -1', "n, -1"),
        ("(3-2)", "linear, r) + translation", "linear, r)"),
        ("(3-2)", "+ last_row[..., 3]", ""),
        ("(3-2)", "return np.asarray(moved / divisor)", "return moved"),
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
        ("(5-7) of a_i", "space.arc(reflected, after, 0.5)", "space.arc(reflected, after, 1 / 3)"),
        ("(5-7) of a_i", "space.arc(reflected, after, 0.5)", "space.arc(before, after, 0.5)"),
        ("(5-10) of a_i", "space.arc(here, middle, fraction)", "space.arc(middle, here, fraction)"),
        ("(5-10) of a_i", "space.arc(here, middle, fraction)", "space.arc(here, middle, 1 / 2)"),
        ("(5-10) of a_i", "space.arc(here, middle, fraction)", "space.arc(here, middle, 1 / 3)"),
        ("(5-13) of b_i", "return a, space.double(a, here)", "return a, space.double(here, a)"),
        ("(5-13) of b_i", "return a, space.double(a, here)", "return space.double(a, here), a"),
        ("neighbours", "for shift in (1, -1))", "for shift in (-1, 1))"),
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
        ("segments", "return [here, a, next_b, after]", "return [here, next_b, a, after]"),
        (
            "segments",
            "np.roll(x, -1, space.axis) for x in (b, here)",
            "np.roll(x, 1, space.axis) for x in (b, here)",
        ),
        (
            "segments",
            "np.roll(x, -1, space.axis) for x in (b, here)",
            "np.roll(x, -1, space.axis) for x in (a, here)",
        ),
        (
            "pseudocode",
            "space.arc(p, q, u) for p, q in pairwise",
            "space.arc(q, p, u) for p, q in pairwise",
        ),
        (
            "pseudocode",
            "u = (np.arange(samples) / samples)",
            "u = ((np.arange(samples) + 1) / samples)",
        ),
        ("blocks", "step = max(1, BLOCK // samples)", "step = BLOCK // samples"),
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
        ("unique arcs", "missing <= space.tolerance(_eps(missing))", "missing <= 0"),
        ("unique arcs", "missing <= space.tolerance(_eps(missing))", "missing <= 1e-6"),
        ("unique arcs", 'np.sqrt, "antipodal"', 'lambda eps: 64 * eps, "antipodal"'),
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
        ("orientations", "r2 @ r1.mT @ r2", "r1 @ r2.mT @ r1"),
        ("orientations", "r2 @ r1.mT @ r2", "r2 @ r1 @ r2"),
    ],
}


def survives(copy: Path, module: str, code: str, wrong: str) -> bool:
    """Whether the tests of a module pass although its code is wrong."""
    source = (ROOT / "rotedu" / f"{module}.py").read_text("utf-8")
    if source.count(code) != 1:
        raise SystemExit(
            f"{module}: this must be there once, not {source.count(code)} times: {code}"
        )
    mutant = copy / "rotedu" / f"{module}.py"
    mutant.write_text(source.replace(code, wrong), "utf-8")
    try:
        options = ["-x", "-q", "-o", "addopts=", "-p", "no:cacheprovider", "--noconftest"]
        run = subprocess.run(
            [sys.executable, "-m", "pytest", *options, f"tests/test_{module}.py"],
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
