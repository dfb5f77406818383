"""Writes transfer_functions.tsv: zeros, poles and gains of transfer functions, from the matrices that `carvallo analyze` prints.

python transfer_functions.py CARVALLO > transfer_functions.tsv, with the path of the program; needs mpmath. The doubles of the
matrices are taken exactly, determinants of M s^2 + C s + K and of its minors are exact polynomials of fractions, and their roots
are found with 60 digits: nothing is shared with what is tested.
"""

import json
import subprocess
import sys
from fractions import Fraction

import mpmath

mpmath.mp.dps = 60

CASES = [
    ("Whipple", "benchmark", "5", [("Tdelta", "phi"), ("Tdelta", "delta"), ("Tphi", "phi"), ("Tphi", "delta")]),
    ("Whipple", "benchmark", "0.5", [("Tdelta", "phi"), ("Tphi", "delta")]),
    ("Whipple", "pista", "8", [("Tdelta", "phi"), ("Tdelta", "delta")]),
    ("WhippleTyres", "benchmark", "4", [("Tdelta", "phi")]),
    ("WhippleLeaning", "example", "6", [("Ttheta", "phi"), ("Tdelta", "phi"), ("Ttheta", "delta")]),
    ("Motorcycle", "standard", "20", [("Tdelta", "phi"), ("Tdelta", "delta"), ("Tphi", "phi")]),
    ("Motorcycle", "standard", "60", [("Tdelta", "phi"), ("Tdelta", "psi")]),
    ("CarTrailer", "caravan", "25", [("Tpsi", "q"), ("Fy", "q")]),
    ("Car", "oversteering", "20", [("Tpsi", "y_rate"), ("Fy", "psi_rate")]),
    ("TowedWheel", "example", "2", [("Tpsi", "y"), ("Fy", "psi")]),
    ("CantileveredPipe", "beta_05", "7", [("Ffirst", "first"), ("Ffirst", "second")]),
    ("WheeledPendulum", "robot", "1", [("Ttheta", "x_rate"), ("Fx", "theta_acceleration")]),
    ("WheeledPendulum", "transporter", "1", [("Ttheta", "x_acceleration"), ("Ttheta", "theta_rate")]),
    ("Motorcycle", "standard", "9.7", [("Fer", "ef_acceleration"), ("Tdelta", "delta_acceleration")]),
    ("ThreePipes", "hose", "9.7", [("Tfirst", "third_acceleration")]),
]

ORDERS = {"_rate": 1, "_acceleration": 2}


def add(p, q):
    return [a + b for a, b in zip(p + [0] * (len(q) - len(p)), q + [0] * (len(p) - len(q)))]


def times(p, q):
    product = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            product[i + j] += a * b
    return product


def determinant(rows):
    """Of polynomials in s, from the lowest power up, by minors of the rows."""
    if not rows:
        return [Fraction(1)]
    total = [Fraction(0)]
    for column, entry in enumerate(rows[0]):
        if any(entry):
            minor = determinant([row[:column] + row[column + 1 :] for row in rows[1:]])
            total = add(total, times([(-1) ** column * a for a in entry], minor))
    return total


def stripped(p):
    while p and p[-1] == 0:
        p = p[:-1]
    return p


def roots(p):
    return mpmath.polyroots([mpmath.mpf(a.numerator) / a.denominator for a in reversed(p)], maxsteps=2000, extraprec=2000)


def stem(output):
    return output.removesuffix("_rate").removesuffix("_acceleration")


def order(output):
    return next((power for end, power in ORDERS.items() if output.endswith(end)), 0)


def all_roots(p):
    """With those at zero, which are exact."""
    at_rest = next(power for power, coefficient in enumerate(p) if coefficient)
    return (roots(p[at_rest:]) if len(p) > at_rest + 1 else []) + [mpmath.mpc(0)] * at_rest


def text(values):
    ordered = sorted(values, key=lambda z: (mpmath.re(z), mpmath.im(z)))
    return " ".join(f"{float(mpmath.re(z))!r},{float(mpmath.im(z))!r}" for z in ordered)


def main():
    print("# model\tset\tspeed\tinput\toutput\tgain\tzeros\tpoles")
    for model, name, speed, channels in CASES:
        command = [sys.argv[1], "analyze", name, "--model", model, "--speeds", speed, "--format", "json"]
        told = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        v, g = Fraction(speed), Fraction(told["parameters"].get("g", 0))
        zero = [[0] * len(told["matrices"]["M"])] * len(told["matrices"]["M"])
        get = lambda key: [[Fraction(a) for a in row] for row in told["matrices"].get(key, zero)]
        size = range(len(zero))
        m, cm1, c0, c1, kc, k0, k1, k2 = map(get, ["M", "C-1", "C0", "C1", "Kc", "K0", "K1", "K2"])
        pencil = [
            [
                [
                    kc[i][j] + g * k0[i][j] + v * k1[i][j] + v * v * k2[i][j],
                    cm1[i][j] / v + c0[i][j] + v * c1[i][j],
                    m[i][j],
                ]
                for j in size
            ]
            for i in size
        ]
        command = [sys.argv[1], "statespace", name, "--model", model, "--speed", speed, "--format", "json"]
        inputs = [signal["name"] for signal in json.loads(subprocess.run(command, capture_output=True).stdout)["inputs"]]
        names = [signal[1:] for signal in inputs]
        for given, wanted in channels:
            row, column = inputs.index(given), names.index(stem(wanted))
            minor = determinant([r[:column] + r[column + 1 :] for i, r in enumerate(pencil) if i != row])
            numerator = stripped([(-1) ** (row + column) * a for a in minor])
            denominator = stripped(determinant(pencil))
            numerator = [Fraction(0)] * order(wanted) + numerator
            # Positions that are no states.
            while denominator[0] == 0 and numerator[0] == 0:
                numerator, denominator = numerator[1:], denominator[1:]
            gain = float(numerator[-1] / denominator[-1])
            columns = [model, name, speed, given, wanted, repr(gain), text(all_roots(numerator)), text(all_roots(denominator))]
            print("\t".join(columns))


if __name__ == "__main__":
    main()
