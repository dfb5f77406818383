"""A coin that rolls: a model of one's own, with all that the models of carvallo have."""

from carvallo import Model

from . import _coin

Coin = Model(_coin.Coin, __name__)
