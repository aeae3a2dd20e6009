"""Drawn paths from pivots that stand somewhere, and the map of such places."""

import linkwright as lw
import numpy as np

BEAN = [(90, 18), (83, 31), (64, 34), (34, 32), (0, 30), (-34, 32), (-64, 34), (-83, 31),
        (-90, 18), (-83, -6), (-64, -34), (-34, -57), (0, -66), (34, -57), (64, -34), (83, -6)]


def test_a_pivot_is_bolted():
    found = lw.fit_path(BEAN, closed=True, effort="quick", ground_pivots={"input": [10, 270]})
    assert found.linkages
    for linkage in found.linkages:
        assert np.allclose(linkage["input"]["center_point"], [10, 270], atol=1e-3)


def test_places_of_the_pivot_are_mapped():
    found = lw.fit_path(BEAN, closed=True, effort="quick", map="pivots", best=1)
    assert found.region.shape == (48, 48)
    anywhere = lw.fit_path(BEAN, closed=True, effort="quick", best=1).linkages[0]
    error = found.linkages[0]["fit"]["error"]["rms"]
    assert error <= 1.001 * anywhere["fit"]["error"]["rms"]
    errors = np.asarray(found.region["path_error"])
    known = errors[found.region.meets]
    assert known.size > 300
    assert known.min() >= 0.999 * error
