"""Critical speeds and stable ranges, against print and a scan of numpy's eigenvalues."""

import carvallo
import numpy as np
import pytest


def test_benchmark_has_the_published_critical_speeds(benchmark):
    double_root, weave, capsize = benchmark.critical_speeds()
    # Section 7 of the paper.
    assert (weave.name, capsize.name, double_root.name) == ("weave", "capsize", "double_root")
    assert weave.speed == pytest.approx(4.29238253634111, abs=1e-13) and capsize.speed == pytest.approx(6.02426201538837, abs=1e-13)
    assert double_root.speed == pytest.approx(0.68428307889246, abs=1e-13)
    assert (weave.below, weave.above, capsize.above) == ("unstable", "stable", "unstable")
    assert benchmark.stable_ranges() == ((weave.speed, capsize.speed),)
    assert benchmark.marginal_ranges() == () and benchmark.undecided_ranges() == ()


def test_stable_ranges_are_those_of_a_scan():
    rng = np.random.default_rng(1)
    factors = rng.uniform(0.9, 1.1, (2, 200))
    base = carvallo.Whipple("pista")
    designs = base.replace(w=base.w * factors[0], lam=base.lam * factors[1])
    stability = designs.stability()
    speeds = np.linspace(0.05, 12.0, 240)
    stable = np.linalg.eigvals(designs.state_space(speeds).A).real.max(axis=-1) < 0.0
    ranges = stability.stable_ranges
    inside = np.zeros_like(stable)
    for index in range(ranges.shape[1]):
        start, end = ranges[:, index, 0, np.newaxis], ranges[:, index, 1, np.newaxis]
        inside |= np.ma.filled((speeds > start) & (speeds < np.ma.filled(end, np.inf)), False)
    np.testing.assert_array_equal(inside, stable)
    assert stable.any() and not stable.all()


def test_none_is_masked_and_never_nan(benchmark):
    designs = benchmark.replace(c=np.array([0.08, -0.3]))
    stability = designs.stability()
    assert stability.stable_from.mask.tolist() == [False, True] and stability["stable_count"].tolist() == [1, 0]
    assert not any(np.isnan(np.ma.getdata(column)).any() for column in stability.values() if column.dtype.kind == "f")
    assert stability.stable_ranges.shape == (2, 1, 2)
    assert stability.stable_from.mean() == pytest.approx(benchmark.stable_ranges()[0].start)
    disc = carvallo.RollingDisc()
    assert disc.stability()["stable_count"].tolist() == 0
    (marginal,) = disc.marginal_ranges()
    # sqrt(g r / 3), of textbooks.
    assert marginal.start == pytest.approx(np.sqrt(disc.g * disc.r / 3)) and marginal.end is None


def test_verdicts_and_eigenvalues_at_speeds(benchmark):
    stability = benchmark.replace(mB=np.array([60.0, 85.0])).stability([4.0, 5.0])
    assert stability["verdict_at_4"].tolist() == ["stable", "unstable"] and stability["verdict_at_5"].tolist() == ["stable"] * 2
    values = benchmark.eigenvalues(5.0)
    assert stability["eigenvalue_2_im_at_5"][1] == values[1].imag and stability["eigenvalue_4_re_at_5"][1] == values[3].real


def test_speeds_by_kind(benchmark):
    stability = benchmark.stability()
    assert stability.speeds("weave").tolist() == [benchmark.critical_speeds()[1].speed]
    with pytest.raises(ValueError, match="`flutter` is no kind of critical speed; they are weave, capsize, double_root"):
        stability.speeds("flutter")
    car = carvallo.Car("oversteering")
    assert car.stability().speeds("divergence").tolist() == pytest.approx([critical.speed for critical in car.critical_speeds()])
