"""Events of the user's own, held against SciPy, and against the motions that they are in."""

import numpy as np
import pytest

import carvallo


def watched(function, terminal=False, direction=0.0):
    """As SciPy has them: with attributes."""
    function.terminal, function.direction = terminal, direction
    return function


@pytest.mark.parametrize(("terminal", "direction"), [(False, 0.0), (False, 1.0), (False, -1.0), (True, 1.0), (2, -1.0)])
def test_linear_ones_are_those_of_scipy(benchmark, terminal, direction):
    integrate = pytest.importorskip("scipy.integrate", reason="SciPy is not installed")
    a = benchmark.state_space(4.6).A
    start = {"phi": 0.05, "delta": 0.02, "phi_rate": 0.5, "delta_rate": -0.3}
    theirs = watched(lambda t, y: y[0] + 0.01 * t - 0.02, terminal, direction)
    expected = integrate.solve_ivp(lambda t, y: a @ y, (0.0, 8.0), list(start.values()), method="DOP853", rtol=1e-13, atol=1e-14,
                                   max_step=0.05, events=theirs)
    ours = watched(lambda t, state: state["phi"] + 0.01 * t - 0.02, terminal, direction)
    found = benchmark.simulate(4.6, 8.0, initial=start, events=ours, linear=True)
    assert len(expected.t_events[0]) > (0 if terminal is True else 1)
    np.testing.assert_allclose(found.t_events[0], expected.t_events[0], rtol=1e-10)
    states = np.stack([found.y_events[0][name] for name in start], axis=-1)
    np.testing.assert_allclose(states, expected.y_events[0], atol=1e-10)
    if terminal:
        assert found.t[-1] == found.t_events[0][-1] and found.end.endswith("s: the event `<lambda>`")
        assert found.t[-2] < found.t[-1] and "nan" not in found.svg().lower()
    else:
        assert found.end is None and len(found.t) == 101


def test_nonlinear_ones_are_where_they_happen(benchmark):
    def leans(t, state):
        assert set(state) >= {"phi", "phi_rate", "delta", "delta_rate", "x", "psi_rate"}
        return state["phi"] - 0.03

    def turns(t, state):
        return state["delta_rate"]

    events = [watched(leans, 4), watched(turns, direction=-1)]
    found = benchmark.simulate(4.6, 20.0, initial={"phi_rate": 0.5}, events=events)
    assert len(found.t_events[0]) == 4 and found.t[-1] == found.t_events[0][-1]
    np.testing.assert_allclose(found.y_events[0]["phi"], 0.03, rtol=1e-13)
    # Maxima of the steer: its rate is zero there, and falls.
    assert len(found.t_events[1]) >= 2
    np.testing.assert_allclose(found.y_events[1]["delta_rate"], 0.0, atol=1e-13)
    assert (found.y_events[1]["delta_acceleration"] < 0.0).all()
    # The same motion without events passes through them.
    times = np.unique(np.concatenate([[0.0], found.t_events[0], found.t_events[1]]))
    again = benchmark.simulate(4.6, times=times, initial={"phi_rate": 0.5})
    there = np.isin(times, found.t_events[0])
    np.testing.assert_allclose(again["phi"][there], 0.03, rtol=1e-9)


def test_a_fall_ends_a_motion_before_an_event():
    disc = carvallo.RollingDisc()
    never = watched(lambda t, state: state["phi"] - 2.0, terminal=True)
    found = disc.simulate(0.1, 10.0, initial={"phi": "5 deg"}, events=[never])
    assert "it falls" in found.end and found.t_events[0].size == 0
    early = watched(lambda t, state: abs(state["phi"]) - 1.0, terminal=True)
    found = disc.simulate(0.1, 10.0, initial={"phi": "5 deg"}, events=[never, early])
    assert "the event `<lambda>`" in found.end and found["phi"][-1] == pytest.approx(1.0, rel=1e-14)


@pytest.mark.parametrize("linear", [True, False])
def test_a_loop_that_is_closed_tells_its_forces(benchmark, linear):
    closed = benchmark.with_feedback("Tdelta = -3*phi_rate")
    found = closed.simulate(4.6, 2.0, initial={"phi_rate": 0.1}, linear=linear)
    ((_, force),) = found.feedback_forces.items()
    np.testing.assert_allclose(force, -3.0 * found["phi_rate"], rtol=1e-13)


@pytest.mark.parametrize("linear", [True, False])
def test_what_is_raised_comes_out(benchmark, linear):
    calls = []

    def breaks(t, state):
        calls.append(t)
        if t > 0.5:
            raise LookupError("no such thing")
        return 1.0

    with pytest.raises(LookupError, match="no such thing"):
        benchmark.simulate(4.6, 5.0, initial={"phi_rate": 0.5}, events=breaks, linear=linear)
    assert calls.count(calls[-1]) == 1 and calls[-1] > 0.5 and sum(t > 0.5 for t in calls) == 1
    with pytest.raises(TypeError, match="^the event `<lambda>` gives None; expected a number$"):
        benchmark.simulate(4.6, 1.0, events=lambda t, state: None, linear=linear)
    with pytest.raises(ValueError, match="^the event `<lambda>` gives nan at 0 s; expected a number$"):
        benchmark.simulate(4.6, 1.0, events=lambda t, state: float("nan"), linear=linear)
    with pytest.raises(TypeError, match="expected a function of the time and the state"):
        benchmark.simulate(4.6, 1.0, events=3.0, linear=linear)
    with pytest.raises(ValueError, match="`terminal` of an event is 0.5"):
        benchmark.simulate(4.6, 1.0, events=watched(lambda t, state: 1.0, 0.5), linear=linear)
