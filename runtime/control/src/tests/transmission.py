"""Writes transmission.tsv: transmission zeros and singular values of systems of several inputs and outputs.

python transmission.py CARVALLO > transmission.tsv, with the path of the program; needs mpmath. The doubles of the matrices that
`CARVALLO analyze` prints are taken exactly. By Jacobi's identity the determinant of some rows and columns of the inverse of
M s^2 + C s + K is that of the other columns and rows over that of all, so that zeros are roots of an exact polynomial, which are found
with 60 digits. Singular values are those of the inverse itself, in 60 digits.
"""

import json
import subprocess
import sys
from fractions import Fraction

import mpmath
from transfer_functions import all_roots, determinant, order, stem, stripped, text

mpmath.mp.dps = 60

CASES = [
    ("Whipple", "benchmark", "5", "Tdelta,Tphi", "phi,delta"),
    ("Whipple", "benchmark", "5", "Tphi,Tdelta", "phi_rate,delta"),
    ("Whipple", "pista", "2", "Tphi,Tdelta", "delta,phi_rate"),
    ("WhippleLeaning", "example", "6", "Tdelta,Ttheta", "phi,delta"),
    ("WhippleLeaning", "example", "3", "Tphi,Ttheta", "delta_rate,theta"),
    ("WhippleLeaning", "example", "6", "Tphi,Tdelta,Ttheta", "phi,delta_rate,theta"),
    ("WhippleLeaning", "example", "6", "Tdelta", "phi,delta,theta"),
    ("Motorcycle", "standard", "20", "Tdelta,Tphi", "phi,delta"),
    ("Motorcycle", "standard", "50", "Tphi,Tdelta", "delta,phi_rate"),
    ("Motorcycle", "standard", "20", "Tphi,Tdelta", "phi"),
    ("CarTrailer", "caravan", "25", "Tpsi,Tq", "psi_rate,q"),
    ("TowedWheel", "example", "2", "Tpsi,Fy", "y,psi"),
    ("CantileveredPipe", "beta_05", "7", "Ffirst,Fsecond", "second,first_rate"),
    ("Whipple", "benchmark", "5", "Tphi,Tdelta", "phi_rate,delta_rate"),
    ("Whipple", "browser", "3", "Tphi,Tdelta", "phi_acceleration,delta_acceleration"),
    ("WhippleLeaning", "example", "6", "Tphi,Tdelta,Ttheta", "phi_acceleration,delta_acceleration,theta_rate"),
    ("ThreePipes", "hose", "9.7", "Tfirst,Tsecond", "second,third_rate"),
]

FREQUENCIES = [0.1, 3.0, 40.0]

def main():
    print("# model\tset\tspeed\tinputs\toutputs\tzeros, - where there are more of one\tsingular values at 0.1, 3 and 40 rad/s")
    for model, name, speed, inputs, outputs in CASES:
        command = [sys.argv[1], "analyze", name, "--model", model, "--speeds", speed, "--format", "json"]
        told = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        v, g = Fraction(speed), Fraction(told["parameters"].get("g", 0))
        zero = [[0] * len(told["matrices"]["M"])] * len(told["matrices"]["M"])
        get = lambda key: [[Fraction(a) for a in row] for row in told["matrices"].get(key, zero)]
        size = range(len(zero))
        m, cm1, c0, c1, kc, k0, k1, k2 = map(get, ["M", "C-1", "C0", "C1", "Kc", "K0", "K1", "K2"])
        k = [[kc[i][j] + g * k0[i][j] + v * k1[i][j] + v * v * k2[i][j] for j in size] for i in size]
        c = [[cm1[i][j] / v + c0[i][j] + v * c1[i][j] for j in size] for i in size]
        command = [sys.argv[1], "statespace", name, "--model", model, "--speed", speed, "--format", "json"]
        told = json.loads(subprocess.run(command, capture_output=True).stdout)
        names = [signal["name"] for signal in told["inputs"]]
        rows = [names.index(given) for given in inputs.split(",")]
        columns = [[given[1:] for given in names].index(stem(output)) for output in outputs.split(",")]
        orders = [order(output) for output in outputs.split(",")]
        zeros = "-"
        if len(rows) == len(columns):
            pencil = [[[k[i][j], c[i][j], m[i][j]] for j in size if j not in columns] for i in size if i not in rows]
            numerator = [Fraction(0)] * sum(orders) + stripped(determinant(pencil))
            # Positions that are no states have no zeros of their own.
            free = [j for j in size if names[j][1:] + "_rate" in [s["name"] for s in told["states"]]]
            hidden = [j for j in free if names[j][1:] not in [s["name"] for s in told["states"]]]
            for j in hidden:
                if numerator[0] != 0:
                    sys.exit(f"{model}: the position of {names[j]} is not cyclic")
                numerator = numerator[1:]
            zeros = text(all_roots(numerator))
        values = []
        for frequency in FREQUENCIES:
            s = mpmath.mpc(0, frequency)
            number = lambda a: mpmath.mpf(a.numerator) / a.denominator
            matrix = mpmath.matrix([[number(k[i][j]) + s * number(c[i][j]) + s * s * number(m[i][j]) for j in size] for i in size])
            inverse = mpmath.inverse(matrix)
            part = mpmath.matrix([[s**power * inverse[j, i] for i in rows] for j, power in zip(columns, orders)])
            found = mpmath.svd_c(part, compute_uv=False)
            values.append(",".join(repr(float(value)) for value in sorted(found, reverse=True)))
        print("\t".join([model, name, speed, inputs, outputs, zeros, " ".join(values)]))


main()
