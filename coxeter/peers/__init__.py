"""Other triangulations of space, to compare with on equal terms: exact simplices, measured like ours.

>>> from coxeter.peers import find_peer
>>> [simplex.volume for simplex in find_peer("five").classes(3)]
[1/3, 1/6]
"""

from .peer import DEFAULT, PEERS, Peer, find_peer

__all__ = ["DEFAULT", "PEERS", "Peer", "find_peer"]
