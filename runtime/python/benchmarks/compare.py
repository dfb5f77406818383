"""Side by side: BicycleParameters, numpy by hand, and Carvallo. ::

    python runtime/python/benchmarks/compare.py

Each line is the best of several runs, in wall-clock time; the last lines have processor seconds of all threads, too. The same
numbers come out: that is asserted first.
"""

import os
import platform
import time
import warnings

import carvallo
import numpy as np

warnings.filterwarnings("ignore")
SPEEDS = np.linspace(0.0, 10.0, 101)
DESIGNS = 1_000_000


def best(function, seconds=1.0):
    """The shortest time of a call, in s."""
    function()
    times, begun = [], time.perf_counter()
    while time.perf_counter() - begun < seconds or len(times) < 3:
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return min(times)


def by_numpy(m, c1, k0, k2, g, speeds):
    """The eigenvalues of state matrices that are made and solved at once."""
    a = np.zeros((len(speeds), 4, 4))
    a[:, :2, 2:] = np.eye(2)
    inverse, v = np.linalg.inv(m), speeds[:, np.newaxis, np.newaxis]
    a[:, 2:, :2], a[:, 2:, 2:] = -inverse @ (g * k0 + v**2 * k2), -inverse @ (v * c1)
    return np.linalg.eigvals(a)


def along_speed():
    """101 speeds of one design."""
    from bicycleparameters.models import Meijaard2007Model
    from bicycleparameters.parameter_dicts import meijaard2007_browser_jason
    from bicycleparameters.parameter_sets import Meijaard2007ParameterSet

    theirs = Meijaard2007Model(Meijaard2007ParameterSet(meijaard2007_browser_jason, True))
    ours = carvallo.Whipple({name: value for name, value in meijaard2007_browser_jason.items() if name != "v"})
    matrices = [ours.matrices()[name] for name in ("M", "C1", "K0", "K2")]
    expected = np.sort_complex(theirs.calc_eigen(v=SPEEDS)[0])
    np.testing.assert_allclose(np.sort_complex(ours.eigenvalues(SPEEDS)), expected, atol=1e-6)

    times = {
        "BicycleParameters": best(lambda: theirs.calc_eigen(v=SPEEDS)),
        "numpy by hand": best(lambda: by_numpy(*matrices, ours.g, SPEEDS)),
        "Carvallo": best(lambda: ours.eigenvalues(SPEEDS)),
    }
    print("eigenvalues of one design at 101 speeds")
    for name, seconds in times.items():
        print(f"  {name:18} {1e6 * seconds:10.1f} us  {times['BicycleParameters'] / seconds:8.0f} times as fast")
    return times


def many_designs():
    """The critical speeds of a million designs; by a scan, as the others need one, of some of them."""
    rng = np.random.default_rng(0)
    base = carvallo.Whipple("benchmark")
    columns = {name: value * rng.uniform(0.9, 1.1, DESIGNS) for name, value in base.items()}
    columns["g"] = np.full(DESIGNS, 9.81)
    some = 200
    m, c1, k0, k2 = (base.replace(**{n: c[:some] for n, c in columns.items()}).matrices()[n] for n in ("M", "C1", "K0", "K2"))
    scan = np.arange(0.0, 10.05, 0.1)
    seconds = best(lambda: [by_numpy(m[i], c1[i], k0[i], k2[i], 9.81, scan) for i in range(some)]) * DESIGNS / some
    print(f"critical speeds of {DESIGNS:,} designs, on {os.cpu_count()} cores")
    print(f"  numpy, scanning 101 speeds for a sign: {seconds:.0f} s, extrapolated from {some} designs")
    for threads in (1, os.cpu_count()):
        runs = []
        for _ in range(3):
            start, used = time.perf_counter(), time.process_time()
            table = carvallo.stability(columns, threads=threads)
            runs.append((time.perf_counter() - start, time.process_time() - used))
        wall, used = min(runs)
        assert all(error is None for error in table["error"])
        print(f"  Carvallo, threads={threads}: {wall:.2f} s, {used:.2f} s of processors")


if __name__ == "__main__":
    print(f"{platform.machine()}, Python {platform.python_version()}, numpy {np.__version__}, carvallo {carvallo.__version__}")
    along_speed()
    many_designs()
