"""Run the benchmarks, print what they found, and write it to _build/benchmark.json.

``make bench`` calls this. With ``--store`` it writes rotedu/edition/benchmark.json instead,
which is committed and which Chapter 6 shows. The shortest time of each measurement counts, because
on a busy machine the longer ones say more about the machine.
"""

import datetime
import importlib.metadata
import json
import os
import platform
import subprocess
import sys
import tempfile
from collections import defaultdict
from dataclasses import asdict
from pathlib import Path
from typing import Any

from rotedu.cost import count
from rotedu.ordinary_rotation import rotate, rotation_matrix, transform
from rotedu.quaternions import Quaternion

HERE = Path(__file__).parent
ROOT = HERE.parent
RESULTS = ROOT / "_build" / "benchmark.json"
STORED = ROOT / "rotedu" / "edition" / "benchmark.json"
PACKAGES = ("numpy", "scipy", "numpy-quaternion", "pytransform3d", "splines")
PYTEST = [
    *(sys.executable, "-m", "pytest", HERE, "-v", "-o", "addopts=", "-p", "no:nbval"),
    *("--benchmark-disable-gc", "--benchmark-max-time=0.5", "--benchmark-min-rounds=5"),
    "--benchmark-quiet",
]


def measure() -> dict[str, Any]:
    """Run the benchmarks and return the results of pytest-benchmark."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        # This variable makes OpenBLAS use the kernels of another processor.
        environment = {k: v for k, v in os.environ.items() if k != "OPENBLAS_CORETYPE"}
        command = [*PYTEST, f"--benchmark-json={report}"]
        if subprocess.run(command, env=environment, check=False).returncode != 0:
            sys.exit("a benchmark failed: nothing was written")
        result: dict[str, Any] = json.loads(report.read_text(encoding="utf-8"))
    return result


def times(report: dict[str, Any]) -> dict[str, dict[str, float]]:
    """Return nanoseconds per point, by group and name; importing has another unit."""
    groups: dict[str, dict[str, float]] = defaultdict(dict)
    for test in report["benchmarks"]:
        name = test["params"].get("way", "closed_curve") if test["params"] else test["name"]
        extra = test["extra_info"]
        if "points" in extra:
            value = test["stats"]["min"] / extra["points"] * 1e9
        else:
            (name, value), *_ = extra.items()
        groups[test["group"]][name] = float(f"{value:.4g}")
    return groups


def counts() -> dict[str, dict[str, int]]:
    """Count the operations of turning one point."""
    axis, angle, point = [0, 0, 1], 0.5, [1, 2, 3]
    matrix, q = rotation_matrix(axis, angle), Quaternion.from_axis_angle(axis, angle)
    found = {
        "rotate, Rodrigues' formula": count(rotate, point, axis, angle),
        "transform, the matrix being there": count(transform, matrix, point),
        "rotation_matrix": count(rotation_matrix, axis, angle),
        "Quaternion.rotate": count(lambda w, v, r: Quaternion(w, v).rotate(r), q.w, q.v, point),
        "Quaternion.matrix": count(lambda w, v: Quaternion(w, v).matrix(), q.w, q.v),
    }
    return {name: asdict(operations) for name, operations in found.items()}


def main(results: Path) -> None:
    """Measure, print and write."""
    report = measure()
    groups = times(report)
    result = {
        "date": datetime.datetime.now(datetime.UTC).date().isoformat(),
        "machine": {
            "processor": report["machine_info"]["cpu"].get("brand_raw", platform.processor()),
            "cores": os.cpu_count(),
            "system": f"{platform.system()} {platform.machine()}",
        },
        "versions": {"python": platform.python_version()}
        | {name: importlib.metadata.version(name) for name in PACKAGES},
        "nanoseconds a point": groups,
        "operations": counts(),
    }
    results.parent.mkdir(exist_ok=True)
    results.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    for group, row in groups.items():
        print(f"\n{group}")
        for name, value in row.items():
            print(f"  {name:34} {value:12.4g}")
    print(f"\nwritten to {results.relative_to(ROOT)}")


if __name__ == "__main__":
    main(STORED if "--store" in sys.argv else RESULTS)
