"""Writes what BicycleParameters makes of the measurements in `data`, as the tests read it.

    pip install BicycleParameters==1.5.2 uncertainties==3.2.3
    python reference.py

The steer axis tilt of a bicycle that was measured by heights over a table follows from

    (a + b) sin(lam) - c cos(lam) = rF - rR

which BicycleParameters solves by Newton's iteration, to then give it the deviation of the first guess, atan(c/(a + b)), as it says
itself; nothing else varies with it then, either. Here it is solved in closed form, which has the deviation of the solution.

Of each bicycle a line for each parameter: its value, its standard deviation, and its correlations with the parameters before it;
and in a file of its own, a line for each entry of the matrices M, C1, K0 and K2, row by row.
"""

from pathlib import Path

from bicycleparameters import geometry
from bicycleparameters.bicycle import benchmark_par_to_canonical
from bicycleparameters.io import load_parameter_text_file
from bicycleparameters.main import calculate_benchmark_from_measured
from uncertainties import correlation_matrix, umath

ORDER = """w c lam g rR mR IRxx IRyy xB zB mB IBxx IByy IBzz IBxz xH zH mH IHxx IHyy IHzz IHxz rF mF IFxx IFyy""".split()
DATA = Path(__file__).parent / "data"



def tilt(r_f, r_r, a, b, c):
    return umath.atan2(c, a + b) + umath.asin((r_f - r_r) / umath.sqrt((a + b) ** 2 + c**2))


geometry.lambda_from_abc = tilt

for path in sorted(DATA.glob("*Measured.txt")):
    found, _ = calculate_benchmark_from_measured(load_parameter_text_file(path))
    numbers = [found[name] + 0 for name in ORDER]
    varying = [i for i, number in enumerate(numbers) if getattr(number, "std_dev", 0)]
    together = correlation_matrix([numbers[i] for i in varying])
    with open(DATA / path.name.replace("Measured.txt", ".tsv"), "w") as output:
        for i, (name, number) in enumerate(zip(ORDER, numbers)):
            value, deviation = getattr(number, "nominal_value", number), getattr(number, "std_dev", 0.0)
            row = [0.0] * i
            if i in varying:
                for k, other in enumerate(varying):
                    if other < i:
                        row[other] = together[varying.index(i)][k]
            numbers_of_row = [f"{x:.15g}" for x in (float(value), float(deviation), *map(float, row))]
            print(name, *numbers_of_row, sep="\t", file=output)
    with open(DATA / path.name.replace("Measured.txt", "Matrices.tsv"), "w") as output:
        for name, matrix in zip(["M", "C1", "K0", "K2"], benchmark_par_to_canonical(found)):
            for entry in matrix.flatten():
                value, deviation = getattr(entry, "nominal_value", entry), getattr(entry, "std_dev", 0.0)
                print(name, f"{float(value):.15g}", f"{float(deviation):.15g}", sep="\t", file=output)
