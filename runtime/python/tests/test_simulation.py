"""Motions, against numpy's matrix exponential of the state-space form and closed forms."""

import carvallo
import numpy as np
import pytest


def test_a_linear_motion_is_the_exponential(benchmark):
    a, _ = benchmark.state_space(4.6)
    values, vectors = np.linalg.eig(a)
    start = np.array([0.1, 0.02, 0.5, -0.3])
    times = np.linspace(0.0, 3.0, 7)
    expected = ((vectors * np.exp(np.multiply.outer(times, values))[:, np.newaxis]) @ np.linalg.solve(vectors, start)).real
    names = ("phi", "delta", "phi_rate", "delta_rate")
    motion = benchmark.simulate(4.6, times=times, initial=dict(zip(names, start)), linear=True)
    np.testing.assert_allclose(np.stack([motion[name] for name in names], axis=-1), expected, atol=1e-11)
    assert motion.is_linear and motion.end is None and motion.units["phi"] == "rad"


def test_a_nonlinear_motion_keeps_its_energy(benchmark):
    motion = benchmark.simulate(4.6, 5.0, initial={"phi_rate": 0.5})
    assert not motion.is_linear and len(motion.t) == 101
    energy = motion.energy.sum(axis=1)
    np.testing.assert_allclose(energy, energy[0], rtol=1e-9)
    weight = 9.81 * (benchmark.mR + benchmark.mB + benchmark.mH + benchmark.mF)
    np.testing.assert_allclose(-sum(force[-1, 2] for force in motion.contact_forces.values()), weight, rtol=1e-2)


def test_a_fall_ends_a_motion():
    motion = carvallo.RollingDisc().simulate(0.1, 10.0, initial={"phi": "5 deg"})
    assert "it falls: it leans by 80 degrees" in motion.end and motion.t[-1] < 10.0


def test_a_force_pushes_a_mass(tmp_path):
    # 4 q'' = f: 2 N for a second make 0.5 m/s and 0.25 m, and then nothing acts.
    (tmp_path / "mass.json").write_text('{"M": [[4]], "K": [[0]], "coordinates": ["x"]}')
    mass = carvallo.read(tmp_path / "mass.json")
    motion = mass.simulate(times=[0.0, 1.0, 3.0], forces={"x": ([0.0, 1.0, 1.0, 3.0], [2.0, 2.0, 0.0, 0.0])})
    np.testing.assert_allclose(motion["x"], [0.0, 0.25, 1.25], rtol=1e-14)
    np.testing.assert_allclose(motion["x_rate"], [0.0, 0.5, 0.5], rtol=1e-14)


def test_mistakes_are_told(benchmark):
    with pytest.raises(ValueError, match=r"`phii` is no position or rate of Whipple; did you mean `phi`\?(.|\n)*`d` is no force on Whipple"):
        benchmark.simulate(5.0, 1.0, initial={"phii": 1.0}, forces={"d": 1.0})
    with pytest.raises(ValueError, match="the force `delta`: point 2: the time 0 s comes behind 1 s"):
        benchmark.simulate(5.0, 1.0, forces={"delta": ([1.0, 0.0], [0.0, 0.0])})
    with pytest.raises(ValueError, match="either `duration` in s or `times` in s"):
        benchmark.simulate(5.0)
    with pytest.raises(ValueError, match="the first time is 1.0; it must be 0 s"):
        benchmark.simulate(5.0, times=[1.0, 2.0])


def test_a_motion_has_a_picture(benchmark):
    svg = benchmark.simulate(4.6, 2.0, initial={"phi_rate": 0.5})._repr_svg_()
    assert svg.startswith("<svg") and "benchmark" in svg


def test_messages_speak_of_python():
    bicycle = carvallo.WhippleMechanism("benchmark")
    with pytest.raises(ValueError, match=r"^`initial`, v=3.0: the speed is given by `v`$"):
        bicycle.simulate(4.6, 1, initial={"v": 3})
    with pytest.raises(ValueError, match=r"it follows from `v`$"):
        bicycle.simulate(4.6, 1, initial={"thetaR_rate": 1})
    with pytest.raises(ValueError, match=r"^`forces`, delta=5 kg: `5 kg`: `kg` is no unit for it; it is in N m$"):
        bicycle.simulate(4.6, 1, forces={"delta": "5 kg"})
    with pytest.raises(ValueError, match=r"it is a model: `carvallo.Pendulum`\n`carvallo.Whipple.sets` has the bicycles$"):
        carvallo.Whipple("pendulum")
