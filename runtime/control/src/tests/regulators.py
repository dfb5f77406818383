"""Gains of regulators by SciPy, for `regulators.rs`: python regulators.py CARVALLO > regulators.tsv

The state matrices are those that `CARVALLO statespace` prints, which other tests hold against print.
"""

import json
import subprocess
import sys

import numpy
import scipy
from scipy.linalg import solve_continuous_are

CASES = [
    ("Whipple", "benchmark", [0.5, 2.0, 4.0, 5.0, 8.0], "Tdelta", {}, {}),
    ("Whipple", "pista", [1.0, 6.0], "Tphi,Tdelta", {"phi": 10.0, "delta_rate": 0.1}, {"Tdelta": 0.5}),
    ("Whipple", "benchmark", [3.0, 5.0], "Tdelta", {"phi": 1.0, "psi": 2.0, "y": 0.5}, {"Tdelta": 0.01}),
    ("Motorcycle", None, [5.0, 20.0, 50.0], "Tdelta", {}, {}),
    ("WhippleLeaning", None, [2.0, 6.0], "Tdelta", {}, {}),
    ("DoublePendulum", None, [0.0], None, {}, {}),
]


def main():
    print(f"# SciPy {scipy.__version__}; model, set, speed, inputs, weights, gains by input and state, growth")
    for model, name, speeds, inputs, outputs, efforts in CASES:
        for speed in speeds:
            command = [sys.argv[1], "statespace", "--format", "json", "--model", model]
            command += [name] if name else []
            command += ["--speed", repr(speed)] if speed else []
            command += ["--inputs", inputs] if inputs else []
            command += ["--outputs", ",".join(outputs)] if outputs else []
            found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
            a, b, c = (numpy.array(found[key], dtype=float) for key in "ABC")
            q = c.T @ numpy.diag([outputs.get(y["name"], 1.0) for y in found["outputs"]]) @ c
            r = numpy.diag([efforts.get(u["name"], 1.0) for u in found["inputs"]])
            x = solve_continuous_are(a, b, q, r)
            gains = numpy.linalg.solve(r, b.T @ x)
            growth = max(numpy.linalg.eigvals(a - b @ gains).real)
            weights = ",".join(f"{key}={value!r}" for key, value in {**outputs, **efforts}.items())
            name_or = name or found["bicycle" if "bicycle" in found else "name"]
            numbers = ",".join(repr(float(gain)) for gain in gains.flatten())
            own = ",".join(u["name"] for u in found["inputs"])
            print("\t".join([model, name_or, repr(speed), own, weights, numbers, repr(float(growth))]))


main()
