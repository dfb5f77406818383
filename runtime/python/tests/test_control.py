"""State spaces with inputs and outputs, transfer functions and margins, held against python-control."""

import numpy as np
import pytest

import carvallo


def test_a_state_space_has_inputs_and_outputs_by_their_names(benchmark):
    a, b, c, d = benchmark.state_space(5.0, inputs="Tdelta", outputs=["phi", "psi_rate", "phi_acceleration"])
    assert a.shape == (4, 4) and b.shape == (4, 1) and c.shape == (3, 4) and d.shape == (3, 1)
    whole = benchmark.state_space(5.0)
    np.testing.assert_array_equal(a, whole.A)
    np.testing.assert_array_equal(b, whole.B[:, [1]])
    np.testing.assert_array_equal(c[2], whole.A[2])
    assert d[2, 0] == whole.B[2, 1]
    # (v delta + c delta') cos(lambda) / w.
    np.testing.assert_allclose(c[1], [0.0, 4.66204174654487, 0.0, 0.07459266794471793], rtol=1e-14)


def test_speeds_are_axes_in_front(benchmark):
    speeds = np.array([[3.0, 4.0, 5.0], [6.0, 7.0, 8.0]])
    spaces = benchmark.state_space(speeds, outputs="y")
    assert spaces.A.shape == (2, 3, 6, 6) and spaces.B.shape == (2, 3, 6, 2) and spaces.C.shape == (2, 3, 1, 6)
    np.testing.assert_array_equal(spaces.A[1, 2], benchmark.state_space(8.0, outputs="y").A)


def test_python_control_agrees(benchmark):
    control = pytest.importorskip("control", reason="python-control is not installed")
    system = control.ss(*benchmark.state_space(5.0, inputs="Tdelta", outputs="phi"))
    function = benchmark.transfer_function(5.0, "Tdelta", "phi")
    np.testing.assert_allclose(np.sort_complex(function.poles), np.sort_complex(system.poles()), rtol=1e-9)
    np.testing.assert_allclose(np.sort_complex(function.zeros), np.sort_complex(system.zeros()), rtol=1e-9)
    omega, gain, phase = function.bode(np.logspace(-2, 2, 50))
    np.testing.assert_allclose(gain * np.exp(1j * phase), system(1j * omega), rtol=1e-9)
    np.testing.assert_allclose(function(1j * omega), system(1j * omega), rtol=1e-9)
    assert np.abs(np.diff(function.bode().phase)).max() < 0.5
    margins = benchmark.margins(5.0, "Tdelta", "phi")
    gm, pm, _, wg, wp, _ = control.stability_margins(system)
    assert margins.gain[0] == pytest.approx((wg, gm), abs=1e-9)
    assert margins.phase[0] == pytest.approx((wp, np.radians(pm)), abs=1e-9)
    assert margins.stable == bool((control.feedback(system, 1).poles().real < 0.0).all())


def test_a_constant_input_comes_to_the_static_gain(benchmark):
    A, B, C, _ = benchmark.state_space(5.0, inputs="Tdelta", outputs="phi")
    expected = float((-C @ np.linalg.solve(A, B)).item())
    assert benchmark.transfer_function(5.0, "Tdelta", "phi").static_gain == pytest.approx(expected, rel=1e-12)
    # The yaw angle goes on growing.
    assert benchmark.transfer_function(5.0, "Tdelta", "psi").static_gain is None


def test_what_cancels_is_left_out():
    function = carvallo.TransferFunction(np.array([-2.0, -1.0]), np.array([-3.0, -1.0, 0.0]), 6.0).minimal()
    assert function.zeros.tolist() == [-2.0] and function.poles.tolist() == [-3.0, 0.0] and function.static_gain is None
    # 6 (s + 2)/(s + 3) at zero.
    cancelled = carvallo.TransferFunction(np.array([-2.0, -1.0]), np.array([-3.0, -1.0]), 6.0)
    assert cancelled.static_gain == 4.0 and cancelled.minimal().static_gain == 4.0


def test_transmission_zeros_are_those_of_python_control(benchmark):
    control = pytest.importorskip("control", reason="python-control is not installed")
    ports = {"inputs": ["Tphi", "Tdelta"], "outputs": ["phi_acceleration", "psi"]}
    zeros = benchmark.transmission_zeros(5.0, **ports)
    expected = control.ss(*benchmark.state_space(5.0, **ports)).zeros()
    assert len(zeros) == len(expected) > 0
    np.testing.assert_allclose(zeros, sorted(expected, key=lambda zero: (round(zero.real, 9), zero.imag)), atol=1e-7)
    assert benchmark.transmission_zeros(5.0, "Tdelta", ["phi", "delta"]) is None


def test_singular_values_are_those_of_numpy(benchmark):
    """numpy.linalg.svd of ``C (iω - A)^-1 B + D``."""
    ports = {"inputs": ["Tphi", "Tdelta"], "outputs": ["phi", "delta", "psi_rate"]}
    omega = np.array([0.02, 0.5, 3.0, 40.0])
    a, b, c, d = benchmark.state_space(5.0, **ports)
    matrices = [c @ np.linalg.solve(1j * at * np.eye(4) - a, b) + d for at in omega]
    found = benchmark.singular_values(5.0, **ports, omega=omega)
    np.testing.assert_array_equal(found.omega, omega)
    np.testing.assert_allclose(found.values, [np.linalg.svd(own, compute_uv=False) for own in matrices], rtol=1e-11)
    everything = benchmark.singular_values(5.0, **ports)
    assert len(everything.omega) > 100 and (np.diff(everything.omega) > 0).all() and everything.values.shape[1] == 2
    assert "singular values" in benchmark.sigma(5.0, **ports).svg
    with pytest.raises(ValueError, match="`omega` has 0 rad/s; it must be finite and above 0"):
        benchmark.singular_values(5.0, omega=[1.0, 0.0])


def test_signals_have_the_units_that_are_asked_for(benchmark):
    """A degree is pi/180 rad, and a pound-force foot 4.4482216152605 * 0.3048 N m (NIST SP 811)."""
    degree, foot = np.pi / 180, 4.4482216152605 * 0.3048
    ports = {"inputs": "Tdelta", "outputs": ["phi", "phi_rate"]}
    si, other = benchmark.state_space(5.0, **ports), benchmark.state_space(5.0, **ports, units="deg,lbf*ft")
    np.testing.assert_allclose(other.A, si.A, rtol=1e-14)
    np.testing.assert_allclose(other.B, si.B * foot / degree, rtol=1e-14)
    np.testing.assert_allclose(other.C, si.C, rtol=1e-14)
    gains = [benchmark.transfer_function(5.0, "Tdelta", "phi", units=units).gain for units in ("si", "deg,lbf*ft")]
    assert gains[1] == pytest.approx(gains[0] * foot / degree, rel=1e-14)
    values = [benchmark.singular_values(5.0, omega=[1.0], units=units).values for units in ("si", "deg")]
    np.testing.assert_allclose(values[1], values[0] / degree, rtol=1e-12)
    steps = [benchmark.step_response(5.0, "Tdelta", size="2 N m", units=units) for units in ("si", "deg,lbf*ft")]
    assert steps[1].units == {"phi": "deg", "delta": "deg"}
    np.testing.assert_allclose(steps[1]["phi"], steps[0]["phi"] / degree, rtol=1e-12)
    starts = [benchmark.initial_response(5.0, {"phi": "5 deg"}, units=units)["phi"][0] for units in ("si", "deg")]
    assert starts == pytest.approx([5 * degree, 5.0], rel=1e-14)
    with pytest.raises(ValueError, match="the units deg,parsecs: `parsecs` is no unit"):
        benchmark.margins(5.0, "Tdelta", "phi", units="deg,parsecs")
    with pytest.raises(ValueError, match="expected `inputs` or `outputs`"):
        benchmark.state_space(5.0, units="deg")


def test_scipy_takes_the_transfer_function(benchmark):
    signal = pytest.importorskip("scipy.signal", reason="SciPy is not installed")
    function = benchmark.transfer_function(5.0, "steer", "lean")
    omega, gain, _ = function.bode([0.3, 3.0])
    _, response = signal.freqs_zpk(*function, worN=omega)
    np.testing.assert_allclose(np.abs(response), gain, rtol=1e-12)


def test_unknown_names_are_told(benchmark):
    with pytest.raises(ValueError, match="`Tdelt` is no input of Whipple; did you mean `Tdelta`?"):
        benchmark.state_space(5.0, inputs="Tdelt")
    with pytest.raises(ValueError, match="`rolling` is no output of Whipple"):
        benchmark.transfer_function(5.0, "Tdelta", "rolling")
    with pytest.raises(ValueError):
        carvallo.Whipple("benchmark", w=np.array([1.0, 1.1])).transfer_function(5.0, "Tdelta", "phi")
