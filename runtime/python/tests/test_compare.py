"""Designs beside each other, and the best within ranges; the numbers come from where the tests of the command line say."""

import carvallo
import pytest


def test_contributions_are_those_of_forty_digits():
    differences = carvallo.compare([carvallo.Whipple("benchmark"), carvallo.Whipple("pista")])
    weave, capsize = differences.changes[0]
    assert (weave.kind, capsize.kind) == ("weave", "capsize")
    assert weave.contributions["mB"] == pytest.approx(-3.01594392603725, abs=1e-12)
    assert capsize.contributions["IFyy"] == pytest.approx(3.23952226430997, abs=1e-12)
    assert sum(weave.contributions.values()) == pytest.approx(weave.after - weave.before, abs=1e-11)
    assert "g" not in differences.parameters
    assert "pista" in differences.plot()._repr_svg_()
    assert "85 to 4.49 kg" in differences.contributions()._repr_svg_()
    assert "trail 0.062 m" in differences.side_view()._repr_svg_()


def test_what_vanishes_on_the_way():
    benchmark = carvallo.Whipple("benchmark")
    differences = carvallo.compare([benchmark, benchmark.replace(c=-0.2)], ["before", "after"])
    assert differences.labels == ("before", "after")
    capsize = next(change for change in differences.changes[0] if change.kind == "capsize")
    assert capsize.after is None and capsize.event == "it is at rest"
    assert capsize.place == pytest.approx(0.397961580322403, abs=1e-8)


def test_the_best_keeps_everything():
    pista = carvallo.Whipple("pista")
    best = carvallo.optimize(
        pista, {"w": (0.6, 1.3), "c": ("1 cm", "10 cm")}, minimize="w", keep=["rR + rF <= 0.7*w", "stable_range >= 1"]
    )
    w = best.design["w"]
    assert pista["rR"] + pista["rF"] <= 0.7 * w == pytest.approx(0.7 * best.value)
    stability = best.design.stability()
    start, end = float(stability.stable_from), float(stability.stable_to)
    assert end - start >= 1
    assert best.before == 0.989 and best.at["w"] is None
    assert best.tight == ("rR + rF <= 0.7*w",)


def test_mistakes_are_told():
    pista = carvallo.Whipple("pista")
    with pytest.raises(ValueError, match="expected two or more"):
        carvallo.compare([pista])
    with pytest.raises(ValueError, match="one measure"):
        carvallo.optimize(pista, {"w": (1, 1.2)})
    with pytest.raises(ValueError, match="must ascend"):
        carvallo.optimize(pista, {"w": (1.2, 1)}, minimize="w")
