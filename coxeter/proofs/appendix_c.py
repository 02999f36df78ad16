"""Appendix C for every d: how far the vertices of A~ are from the circumcentre; Lemmas 12, 13, Remark 5.

The vertices are the points z with coordinates n_i + k/(d+1), i = 0 … d, where k and the n_i are integers and
Σ n_i = -k. The proof differs from the paper's: it finds all distances at once.
"""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache
from itertools import takewhile

from ..affine import triangulation
from ..delaunay import mirror_vertices, protection, vertices_by_distance
from ..exact import Exact
from ..families import closed_form
from ..symbolic.cases import case
from ..symbolic.runs import runs, square
from .proof import Proof, ReplayFailed, argument, formulas, identity, inequality, join, tested

DISTANCE = r"\|z - c\|^2 = R^2 + \frac{1}{d+1}\sum_{j=0}^d g_j(t_j), \quad g_j(t) = (d+1)t^2 + (2j - d)t"


@lru_cache(maxsize=1)
def distances() -> Proof:
    """The squared distance of a vertex from the circumcentre, by integers t_0 … t_d with sum 0."""
    whole = case("2 <= d", 2)
    centred = runs(("(i - 1 - d/2)/(d + 1)", "d + 1"))
    return join(
        rf"for each vertex $z$ of $\tilde A_d$ there are integers $t_j$ with $\sum t_j = 0$, ${DISTANCE}$",
        argument(
            r"By Proposition 7 the vertices are the points with coordinates $n_i + \frac{k}{d+1}$, "
            r"$i = 0, \dots, d$, with integers $k$, $n_i$ and $\sum n_i = -k$"
        ),
        argument(
            r"With $p_i = i - k - (d+1)n_i$ the coordinates of $(d+1)(z - c)$ are $\frac d2 - p_i$. The "
            r"integers $p_i$ leave all remainders $0, \dots, d$ on division by $d+1$, each once, and add up "
            r"to $\sum i - (d+1)k - (d+1)\sum n_i = \sum i$"
        ),
        argument(
            r"Number them by their remainder $j$: $p = j + (d+1)t_j$, where $\sum t_j = 0$. Conversely such "
            r"$t_j$ and a remainder $k$ determine one vertex; $t = 0$ gives the vertices $u_k$ of the simplex"
        ),
        identity(
            "for $t = 0$ the squared distance is $R^2$", r"\frac{1}{(d+1)^2}\sum_{j=0}^d (j - \tfrac d2)^2",
            square(centred, whole), "d*(d + 2)/(12*(d + 1))", whole,
            lambda d: triangulation(("A", d)).simplex.squared_circumradius,
        ),
        identity(
            "what a summand adds", r"\left(j - \tfrac d2 + (d+1)t\right)^2 - \left(j - \tfrac d2\right)^2",
            "(j - d/2 + (d + 1)*t)**2 - (j - d/2)**2", "(d + 1)*((d + 1)*t**2 + (2*j - d)*t)",
            case("0 <= j <= d", t="c"),
        ),
    )  # fmt: skip


@lru_cache(maxsize=1)
def lemma_13() -> Proof:
    """Squared distances from c differ by integer multiples of 2/(d+1)."""
    return join(
        r"for all vertices $z, z'$ of $\tilde A_d$, $\|z - c\|^2 - \|z' - c\|^2$ is an integer times "
        r"$\frac{2}{d+1}$",
        distances().steps,
        argument(
            r"As $\sum t_j = 0$, the sum of the $g_j(t_j)$ is $(d+1)\sum t_j^2 + 2\sum j\,t_j$; and "
            r"$\sum t_j^2$ is even, because $t^2$ and $t$ have the same parity"
        ),
        tested(
            "the distances of all mirror vertices from the circumcentre",
            r"\tfrac{d+1}{2}\left(\|z - c\|^2 - R^2\right) \in \mathbb{Z}", 12, _replay_multiples,
        ),
    )  # fmt: skip


@lru_cache(maxsize=1)
def second_closest() -> Proof:
    """The Claim and Remark 5: after the simplex's own vertices come d + 1 others, one in each class."""
    unit = case("0 <= j <= d", 2)
    return join(
        r"the vertices of $\tilde A_d$ that are second closest to $c$ are $d+1$ points, one of each "
        r"remainder $k$, at squared distance $R^2 + \frac{2}{d+1}$; there are no others",
        distances().steps,
        identity("a summand with $t = 1$", "g_j(1)", "(d + 1) + (2*j - d)", "2*j + 1", unit),
        identity("a summand with $t = -1$", "g_j(-1)", "(d + 1) - (2*j - d)", "2*(d - j) + 1", unit),
        inequality(
            "a summand with $t$ at least 2", "g_j(t) - 2", "(d + 1)*t**2 + (2*j - d)*t - 2",
            case("0 <= j <= d", t="c + 2"), strict=True,
        ),
        inequality(
            "a summand with $t$ at most -2", "g_j(t) - 2", "(d + 1)*t**2 + (2*j - d)*t - 2",
            case("0 <= j <= d", t="-c - 2"), strict=True,
        ),
        argument(
            r"So $g_j(t) \geq 1$ for $t \neq 0$, with equality only for $g_0(1)$ and $g_d(-1)$. If not all "
            r"$t_j$ vanish, two do not, as their sum is 0: $\sum g_j(t_j) \geq 2$, with equality only for "
            r"$t_0 = 1,\ t_d = -1$ and all others 0. With each remainder $k$ this is one vertex"
        ),
        tested(
            "the nearest vertices that the core finds", r"\#\{z : \|z-c\|^2 = R^2 + \tfrac{2}{d+1}\} = d + 1",
            6, _replay_nearest,
        ),
    )  # fmt: skip


def relative_protection(claimed: str | None = None) -> Proof:
    """Lemma 12: the relative protection of A~ for every d."""
    claimed = claimed or closed_form("A", "relative_protection").pieces[0].text

    def core(d: int) -> Exact:
        return protection(triangulation(("A", d))).relative

    return join(
        r"the relative protection $\hat\delta = R'/R - 1$ of $\tilde A_d$",
        second_closest().steps,
        argument("The affine Weyl group carries each simplex to every other: one simplex tells the infimum"),
        formulas(
            r"with $R'^2 = R^2 + \frac{2}{d+1}$", r"\hat\delta",
            "sqrt((d*(d + 2)/(12*(d + 1)) + 2/(d + 1))/(d*(d + 2)/(12*(d + 1)))) - 1", claimed, 2, core=core,
        ),
    )  # fmt: skip


def _replay_multiples(largest: int) -> int:
    count = 0
    for d in range(2, largest + 1):
        t = triangulation(("A", d))
        for mirror in mirror_vertices(t):
            difference = mirror.squared_distance - t.simplex.squared_circumradius
            if (difference * (d + 1) / 2).denominator != 1:
                raise ReplayFailed(f"a mirror vertex of A~{d} is at squared distance R^2 + {difference}")
            count += 1
    return count


def _replay_nearest(largest: int) -> int:
    """By enumeration of vertices in dimensions that allow it, else by the mirror vertices."""
    count = 0
    for d in range(2, min(largest, 6) + 1):
        t = triangulation(("A", d))
        bound = t.simplex.squared_circumradius + Fraction(2, d + 1)
        squares = (square for square, _ in vertices_by_distance(t))
        found = list(takewhile(bound.__ge__, squares))
        if found != [t.simplex.squared_circumradius] * (d + 1) + [bound] * (d + 1):
            raise ReplayFailed(f"A~{d} has the squared distances {found}")
        count += len(found)
    return count
