"""Closed loops, and gains that close them."""

import pickle

import numpy as np
import pytest
from numpy.testing import assert_allclose

import carvallo

LAW = "Tdelta = 10*(4.7 - v)*phi_rate"


def test_a_law_makes_the_model_that_has_it():
    closed = carvallo.Whipple("benchmark").with_feedback(LAW)
    model = carvallo.BalanceAssist("benchmark")
    speeds = np.linspace(0.5, 6.0, 12)
    assert_allclose(closed.eigenvalues(speeds), model.eigenvalues(speeds), rtol=1e-11)
    assert closed.feedback == (LAW,)
    # Recomputed with 40 digits.
    assert_allclose([stable.start for stable in closed.stable_ranges()], [1.0948652805741492], rtol=1e-14)
    assert list(closed.matrices()) == ["M", "C0", "C1", "K0", "K2"]
    assert_allclose(closed.matrices()["C0"], [[0.0, 0.0], [-47.0, 0.0]])
    assert closed.with_feedback().feedback == ()
    assert closed != carvallo.Whipple("benchmark") == closed.with_feedback()


def test_the_loop_stays_closed():
    closed = carvallo.Whipple("benchmark").with_feedback(LAW)
    heavier = closed.replace(mB=np.array([80.0, 85.0]))
    assert_allclose(heavier.eigenvalues(3.0)[1], closed.eigenvalues(3.0))
    assert pickle.loads(pickle.dumps(closed)) == closed
    motion = closed.simulate(3.0, duration=1.0, initial={"phi_rate": 0.5})
    assert not motion.is_linear
    force = motion.feedback_forces[next(iter(motion.feedback_forces))]
    # At the speed of the moment, which hardly changes.
    assert_allclose(force, 17.0 * motion["phi_rate"], rtol=0.05)


def test_files_have_laws(tmp_path):
    path = tmp_path / "closed.json"
    path.write_text('{"M": [[1]], "Kc": [[-1]], "feedback": ["q1 = -5*q1 - 2*q1_rate"]}')
    values = carvallo.read(path).eigenvalues()
    assert_allclose(values, [-1.0 - np.sqrt(3.0) * 1j, -1.0 + np.sqrt(3.0) * 1j], rtol=1e-14)


def test_mistakes_are_told():
    with pytest.raises(ValueError, match="`Tdelt` is no force on Whipple; did you mean `Tdelta`"):
        carvallo.Whipple("benchmark").with_feedback("Tdelt = phi")
    with pytest.raises(ValueError, match="there is a law for the force `Tdelta` already"):
        carvallo.Whipple("benchmark").with_feedback("Tdelta = phi", "steer = phi_rate")
    with pytest.raises(ValueError, match="did you mean `Tdelta`"):
        carvallo.Whipple("benchmark").lqr(5.0, inputs="Tdelt")
    with pytest.raises(ValueError, match="the weight of an input is 0; it must be > 0"):
        carvallo.Whipple("benchmark").lqr(5.0, weights={"Tdelta": 0.0})


def test_regulators_are_those_of_scipy():
    """scipy.linalg.solve_continuous_are of the benchmark, with all weights 1."""
    found = carvallo.Whipple("benchmark").lqr([2.0, 5.0], inputs="Tdelta")
    expected = [
        [-48.193886319443095, 16.95776104501121, -14.631875451334958, 2.2678181395740706],
        [-2.540400702348214, 4.85198630211049, -0.33451833216407395, 0.45007281456856885],
    ]
    assert_allclose(found.gains[:, 0], expected, rtol=1e-9)
    assert found.gains.shape == (2, 1, 4) and found.eigenvalues.shape == (2, 4)
    assert (found.eigenvalues.real < 0.0).all() and found.unstable_between == ()
    assert found.inputs == ("Tdelta",) and found.states == ("phi", "delta", "phi_rate", "delta_rate")
    assert_allclose(found.v, [2.0, 5.0])
    a, b = carvallo.Whipple("benchmark").state_space(2.0)
    closed = np.linalg.eigvals(a - b[:, 1:] @ found.gains[0])
    assert_allclose(np.sort(closed.real), found.eigenvalues[0].real, rtol=1e-9)
    weighted = carvallo.Whipple("benchmark").lqr(2.0, inputs=["Tdelta"], weights={"phi": 10.0, "Tdelta": 0.5})
    assert weighted.gains.shape == (1, 1, 4)
    assert carvallo.DoublePendulum("rods").lqr().v is None


def test_sensitivities_of_gains_are_differences_of_scipys():
    """Sixth-order differences of scipy.linalg.solve_continuous_are, all weights 1."""
    linalg = pytest.importorskip("scipy.linalg", reason="SciPy is not installed")
    benchmark = carvallo.Whipple("benchmark")
    regulators = benchmark.lqr([3.0, 6.0], inputs="Tdelta")
    found = regulators.sensitivities()
    assert list(found) == list(benchmark) and found["w"].shape == regulators.gains.shape == (2, 1, 4)

    def gains(name, value, v):
        a, b = benchmark.replace(**{name: value}).state_space(v)
        return b[:, 1:].T @ linalg.solve_continuous_are(a, b[:, 1:], np.eye(4), np.eye(1))

    for name in ("w", "c", "lam", "mB", "IFyy"):
        step = 1e-3 * benchmark[name]
        for place, v in enumerate(regulators.v):
            at = {k: gains(name, benchmark[name] + k * step, v) for k in (-3, -2, -1, 1, 2, 3)}
            expected = ((at[3] - at[-3]) - 9 * (at[2] - at[-2]) + 45 * (at[1] - at[-1])) / (60 * step)
            assert_allclose(found[name][place], expected, rtol=1e-6, atol=1e-7 * np.abs(expected).max())
    degree = np.pi / 180
    in_degrees = benchmark.lqr([3.0, 6.0], inputs="Tdelta", units="deg")
    assert_allclose(in_degrees.gains, regulators.gains * degree, rtol=1e-13)
    assert_allclose(in_degrees.sensitivities()["w"], found["w"] * degree, rtol=1e-13)
