"""Candidates of one's own: what they may be, and may return."""

import lyapunov as ly
import numpy as np
import pytest

PERIOD = 1e-3

MAKERS = [lambda it, axes: ly.Stabilizer("lolc", limit=1.0, candidate=it, axes=axes), lambda it, axes: ly.Observer(candidate=it)]


class Mine:
    """A candidate that returns whatever it was made with."""

    def __init__(self, told):
        self.told = told

    def decrease(self, sample):
        return self.told


@pytest.mark.parametrize("make", MAKERS)
@pytest.mark.parametrize(
    "told, kind",
    [(None, "NoneType"), ("1", "str"), (np.zeros(3), r"an array of float64 of shape \[3\]")],
)
def test_what_is_no_number_is_told_as_such(make, told, kind):
    block = make(Mine(told), 3)
    sample = ly.Sample(PERIOD, *np.zeros((4, 3)), axes=3)
    with pytest.raises(TypeError, match=rf"^decrease\(sample\) of Mine returned {kind}; return a number, in J, such as numpy.sum"):
        block.observe(sample) if isinstance(block, ly.Observer) else block.stabilize(sample, np.zeros(3))


@pytest.mark.parametrize("make", MAKERS)
def test_what_is_no_candidate_is_refused_at_once(make):
    with pytest.raises(TypeError, match=r"^candidate is int; give an object with a method decrease\(sample\)"):
        make(3, 1)
    with pytest.raises(TypeError, match="^candidate is the class Mine; give an object of it"):
        make(Mine, 1)


def test_an_error_of_the_candidate_is_its_own():
    class Broken:
        def decrease(self, sample):
            raise TypeError("mine")

    with pytest.raises(TypeError, match="^mine$"):
        ly.Observer(candidate=Broken()).observe(ly.Sample(PERIOD, 0.0, 0.0, 0.0, 0.0))
