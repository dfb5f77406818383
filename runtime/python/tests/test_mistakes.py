"""Arguments of the wrong kind are told, with what was expected."""

import numpy as np
import pytest

import carvallo


@pytest.mark.parametrize("call, error, message", [
    (lambda b: b.transfer_function(5.0, ["Tdelta"], "phi"), TypeError, "is \\['Tdelta'\\]; expected a text such as 'Tdelta'"),
    (lambda b: b.transfer_function(5.0, "Tdelta", "phi", units=["deg"]), TypeError, "`units` is \\['deg'\\]; expected a text"),
    (lambda b: b.bode(5.0, omega=(1.0, 2.0, 3.0)), ValueError, "`omega` is \\(1.0, 2.0, 3.0\\); expected a pair"),
    (lambda b: b.bode(5.0, omega="0.1:10"), ValueError, "`omega` is '0.1:10'; expected a pair"),
    (lambda b: b.initial_response(5.0, ["phi"]), TypeError, "`initial` is \\['phi'\\]; expected a mapping"),
    (lambda b: b.lqr(5.0, weights=["phi"]), TypeError, "`weights` is \\['phi'\\]; expected a mapping"),
    (lambda b: b.simulate(5.0, 1.0, initial="phi=1"), TypeError, "`initial` is 'phi=1'; expected a mapping"),
    (lambda b: b.simulate(5.0, 1.0, forces=[("delta", 1.0)]), TypeError, "`forces` is .*; expected a mapping"),
    (lambda b: b.with_feedback(["Tdelta = phi"]), TypeError, "a law is \\['Tdelta = phi'\\]; expected a text"),
    (lambda b: carvallo.compare(["benchmark", "pista"]), TypeError, "one of the designs is 'benchmark'; expected a design"),
    (lambda b: carvallo.optimize(b, [("w", (1, 2))], minimize="w"), TypeError, "`vary` is .*; expected a mapping"),
    (lambda b: carvallo.optimize(b, {"w": 1.0}, minimize="w"), ValueError, "`vary\\['w'\\]` is 1.0; expected a pair"),
    (lambda b: carvallo.optimize(b, {"w": (1, 2)}, minimize="w", speeds=5), ValueError, "`speeds` is 5; expected a pair"),
    (lambda b: carvallo.optimize(b, {"w": (1, 2)}, minimize="w", starts="8"), ValueError, "`starts` is '8'; it must be a whole"),
    (lambda b: b.singular_values(5.0, omega=[-1.0]), ValueError, "`omega` has -1 rad/s; it must be finite and above 0"),
])
def test_arguments_of_other_kinds(benchmark, call, error, message):
    with pytest.raises(error, match=message):
        call(benchmark)


def test_one_constraint_needs_no_list(benchmark):
    found = [carvallo.optimize(benchmark, {"w": (1.0, 1.2)}, minimize="w", keep=keep, starts=1).value for keep in ("w >= 1.1", ["w >= 1.1"])]
    assert found[0] == found[1] == pytest.approx(1.1) and not np.isnan(found[0])
