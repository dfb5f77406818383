"""Responses in time, held against python-control and numpy's exponential, and what excites and shows the modes."""

import xml.etree.ElementTree as xml

import numpy as np
import pytest

import carvallo

OUTPUTS = ["phi", "delta", "psi", "phi_rate"]


@pytest.fixture
def steered(benchmark):
    control = pytest.importorskip("control", reason="python-control is not installed")
    return control, control.ss(*benchmark.state_space(5.0, inputs="Tdelta", outputs=OUTPUTS))


def test_steps_are_those_of_python_control(benchmark, steered):
    control, system = steered
    found = benchmark.step_response(5.0, "Tdelta", OUTPUTS, 3.0, size="2 N m")
    expected = 2.0 * control.step_response(system, found.t, squeeze=False).outputs[:, 0]
    assert list(found) == OUTPUTS and found.units["phi_rate"] == "rad/s" and len(found.t) == 101
    np.testing.assert_allclose(np.stack(list(found.values())), expected, rtol=1e-9, atol=1e-12)


def test_impulses_are_those_of_python_control(benchmark, steered):
    control, system = steered
    times = np.linspace(0.0, 2.0, 21)
    found = benchmark.impulse_response(5.0, "Tdelta", "phi, delta, psi, phi_rate", size=0.5, times=times)
    expected = 0.5 * control.impulse_response(system, times, squeeze=False).outputs[:, 0]
    np.testing.assert_allclose(np.stack(list(found.values())), expected, rtol=1e-9, atol=1e-12)


def test_initial_states_follow_the_exponential(benchmark):
    a = benchmark.state_space(4.6).A
    values, vectors = np.linalg.eig(a)
    times = np.linspace(0.0, 3.0, 7)
    modal = np.linalg.solve(vectors, [np.radians(5.0), 0.0, 0.5, 0.0])
    expected = (vectors @ (modal[:, np.newaxis] * np.exp(np.outer(values, times)))).real
    found = benchmark.initial_response(4.6, {"phi": "5 deg", "lean rate": 0.5}, ["phi", "delta"], times=times)
    np.testing.assert_allclose([found["phi"], found["delta"]], expected[:2], atol=1e-12)


def test_what_leaves_the_range_of_doubles_ends(benchmark):
    found = benchmark.step_response(0.5, "Tdelta", duration=1000.0)
    assert found.t[-1] < 1000.0 and "range of floating-point numbers" in found.end and np.isfinite(found["phi"]).all()


def test_cosines_are_those_of_eigenvectors(benchmark):
    speeds = np.array([[0.7, 3.0], [5.0, 8.0]])
    found = benchmark.controllability(speeds, "Tdelta", ["phi", "delta_rate"])
    assert found.modes.shape == found.eigenvalues.shape == (2, 2, 4)
    assert found.controllability.shape == (2, 2, 4, 1) and found.observability.shape == (2, 2, 4, 2)
    assert found.modes[1, 0].tolist() == ["castering", "capsize", "weave", "weave"]
    for place in np.ndindex(speeds.shape):
        a, b, c, _ = benchmark.state_space(speeds[place], inputs="Tdelta", outputs=["phi", "delta_rate"])
        values, right = np.linalg.eig(a)
        left = np.linalg.inv(right)
        for mode, value in enumerate(found.eigenvalues[place]):
            own = np.abs(values - value).argmin()
            w, x = left[own], right[:, own]
            cosine = abs(w @ b[:, 0]) / np.linalg.norm(w) / np.linalg.norm(b)
            assert found.controllability[place][mode, 0] == pytest.approx(cosine, rel=1e-9)
            # Of the pure number w^H b c x no scale is left.
            assert found.excitation[place][mode, 0] * found.share[place][mode, 1] == pytest.approx(w @ b[:, 0] * (c[1] @ x), rel=1e-9)
            shown = np.abs(c @ x) / np.linalg.norm(x)
            np.testing.assert_allclose(found.observability[place][mode], shown, rtol=1e-9)


def test_lost_modes_leave_a_space_out_of_reach(benchmark):
    # Where resultants of sympy have them, as the tests of the control library say.
    found = benchmark.controllability(np.linspace(0.0, 8.0, 9), outputs="phi")
    lost = [(mode.port, mode.speed) for mode in found.lost if mode.is_input]
    assert [port for port, _ in lost] == ["Tphi", "Tphi", "Tdelta", "Tdelta"]
    np.testing.assert_allclose([speed for _, speed in lost], [0.5957, 2.6074, 0.0251, 1.4110], atol=5e-5)
    for mode in found.lost[:4]:
        a, b, _, _ = benchmark.state_space(mode.speed, inputs=mode.port, outputs="phi")
        pencil = np.hstack([a - mode.eigenvalue * np.eye(4), b])
        singular = np.linalg.svd(pencil, compute_uv=False)
        assert singular[-1] < 1e-12 * singular[0]


def test_what_does_not_run_has_its_modes():
    found = carvallo.DoublePendulum("rods").controllability()
    assert found.v is None and found.modes.shape == (4,) and found.lost == () and found._repr_svg_() is None


def test_pictures_are_svg(benchmark):
    closed = benchmark.with_feedback("Tdelta = 10*(4.7 - v)*phi_rate")
    pictures = [
        benchmark.bode(5.0, "Tdelta", ["phi", "delta"]), benchmark.nyquist(5.0, "Tdelta", "phi", omega=(0.1, 100.0)),
        closed.locus((0.0, 8.0)), benchmark.locus(), benchmark.phasors([3.0, 5.0]), benchmark.step_response(5.0, "Tdelta"),
        benchmark.controllability(np.linspace(0.0, 10.0, 11)), benchmark.along("mB", 60, 120, 5.0),
    ]
    for picture in pictures:
        assert xml.fromstring(picture._repr_svg_()).tag == "{http://www.w3.org/2000/svg}svg"
    assert pictures[2].svg != pictures[3].svg
    assert benchmark.controllability(5.0)._repr_svg_() is None


@pytest.mark.parametrize(("call", "message"), [
    (lambda own: own.step_response(5.0, "Tdelt"), "`Tdelt` is no input of Whipple; did you mean `Tdelta`"),
    (lambda own: own.step_response(5.0, "Tdelta", size="2 kg"), "^`size`, 2 kg: `2 kg`: `kg` is no unit for it; it is in N m$"),
    (lambda own: own.impulse_response(5.0, "Tdelta", size="2 N m"), "^`size`, 2 N m: .* it is in N m s$"),
    (lambda own: own.step_response(5.0, "Tdelta", "phi,phi"), "^`phi` is named twice$"),
    (lambda own: own.step_response(5.0, "Tdelta", []), "expected at least one name"),
    (lambda own: own.step_response(5.0, "Tdelta", times=[0.0, 2.0, 1.0]), "behind 2 s comes 1 s"),
    (lambda own: own.step_response(5.0, "Tdelta", duration=-1.0), "the duration is -1.0 s; it must be >= 0"),
    (lambda own: own.initial_response(5.0, {"fi": 1.0}), "^`initial`, fi=1.0: `fi` is no state\nthey are phi, delta"),
    (lambda own: own.controllability(5.0, outputs="psi"), "^`outputs`, psi: `psi` is an integral"),
    (lambda own: own.controllability(5.0).svg(), "a range of speeds"),
    (lambda own: own.along("mB", 60, 120), "^`along`, mB=60.0:120.0: `v` is missing"),
    (lambda own: own.along("v", 60, 120, 5.0), "^`along`, v=60.0:120.0: `v` is the speed: everything else is along it$"),
    (lambda own: own.along("mBB", 60, 120, 5.0), "did you mean `mB`"),
    (lambda own: own.along("mB", 60, 120, 5.0).plot((3.0, 2.0)), "`values` is from 3 to 2"),
    (lambda own: own.locus((8.0, 2.0)), "`v` is from 8 to 2"),
    (lambda own: own.phasors(np.arange(20.0)), "there are 20 speeds; the picture has room for 12"),
    (lambda own: own.bode(5.0, omega=(3.0, 1.0)), "`omega` is from 3 to 1 rad/s"),
    (lambda own: own.lqr(5.0, weights={"foo": 1}), "^`weights`, foo=1.0: `foo` is no output"),
    (lambda own: own.lqr(5.0, weights={"phi": "x"}), "^the weight of `phi` is 'x'; expected a number$"),
    (lambda own: own.replace(w=np.array([1.0, 1.1])).bode(5.0), "there are 2 designs"),
])
def test_mistakes_are_told(benchmark, call, message):
    with pytest.raises(ValueError, match=message):
        call(benchmark)


def test_gains_become_code(benchmark):
    regulators = benchmark.lqr([2.0, 5.0], inputs="Tdelta")
    for text in (regulators.to_rust(), regulators.to_c()):
        assert f"{regulators.gains[1, 0, 0]:.10g}"[:9] in text
    assert "pub fn" in regulators.to_rust() and "double" in regulators.to_c()


def test_a_parameter_has_critical_values(benchmark):
    optimize = pytest.importorskip("scipy.optimize", reason="SciPy is not installed")

    def growth(c):
        return np.linalg.eigvals(benchmark.replace(c=c).state_space(5.0).A).real.max()

    along = benchmark.along("c", "0 cm", "20 cm", v=5.0, count=21)
    assert along.unit == "m" and along.v == 5.0 and along.eigenvalues.shape == (21, 4) and along.values[-1] == 0.2
    ends = sorted({end for stable in along.stable_ranges for end in stable} - {0.0, 0.2})
    assert ends and not along.undecided_ranges
    for end in ends:
        assert end == pytest.approx(optimize.brentq(growth, end - 1e-3, end + 1e-3, xtol=1e-15), rel=1e-9)
        assert end in [critical.value for critical in along.critical_values]
    for value, eigenvalues, verdict in zip(along.values, along.eigenvalues, along.verdicts):
        np.testing.assert_allclose(eigenvalues, benchmark.replace(c=value).eigenvalues(5.0), rtol=1e-12)
        assert (verdict == "stable") == (eigenvalues.real.max() < 0.0)
