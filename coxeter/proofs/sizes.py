"""The longest edges and the volumes of A~, B~, C~, D~ for every d. Paper: Section 6, items 5 and 7."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from math import prod

from ..exact import Exact, Surd
from ..families import Piece, closed_form
from ..symbolic.cases import case
from ..symbolic.runs import inner, runs, squared_distance
from .classical import FAMILIES, Classical, Pair, vector, vertex
from .proof import Proof, Step, argument, formulas, identity, in_dimension, inequality, join
from .simplices import form, node, roots_squared, the_simplex, the_triangulation

# -- longest edge (item 5) ----------------------------------------------------------------------------


def longest_edge(letter: str, claimed: tuple[Piece, ...] | None = None) -> Proof:
    """No edge is longer than L, and one is as long."""
    pieces = claimed or closed_form(letter, "longest_edge").pieces
    return join(
        rf"the longest edge of $\tilde{{{letter}}}_d$ has length $L$",
        (step for piece in pieces for part in parts(letter, piece) for step in _on(letter, part)),
    )


def parts(letter: str, piece: Piece) -> Iterator[Piece]:
    """A piece cut where the formula for the longest edge changes."""
    for own in closed_form(letter, "longest_edge").pieces:
        if part := own.meet(piece):
            yield replace(part, text=piece.text)


def _on(letter: str, part: Piece) -> Iterator[Step]:
    if part.high is not None:
        for d in range(part.low, part.high + 1):
            core = partial(_longest_edge, letter)
            yield in_dimension("the longest edge, computed", "L", str(core(d)), part.text, d, core)
    elif letter == "A":
        yield from _longest_a(part.text, part.parity or "")
    else:
        yield from _longest(FAMILIES[letter], part.text, part.low)


def _longest_edge(letter: str, d: int) -> Surd:
    return the_simplex(letter, d).longest_edge


def _longest(family: Classical, text: str, low: int) -> Iterator[Step]:
    """B~, C~, D~: every edge against d/4, from the first d in which that is the maximum."""
    for pair in family.pairs():
        if pair.same or pair.range.text.endswith("k < j <= " + pair.first.high):
            continue
        if family.nodes.index(pair.first) > family.nodes.index(pair.second):
            continue
        yield _no_longer(family, pair, low)
    last = family.nodes[-1]
    whole = case(f"{low} <= d", low)
    distance = squared_distance(vertex(family.nodes[0]), vertex(last), whole)

    def core(d: int) -> Exact:
        return the_simplex(family.letter, d).squared_edge_lengths[0, d]

    yield identity("the edge from $u_0$ to $u_d$", r"\|u_d - u_0\|^2", distance, "d/4", whole, core)
    yield formulas("so the longest edge", "L", "sqrt(d/4)", text, low,
                   core=lambda d: the_simplex(family.letter, d).longest_edge)  # fmt: skip


def _no_longer(family: Classical, pair: Pair, low: int) -> Step:
    range_ = pair.range
    if not range_.nonnegative(f"d - {low}"):  # an exceptional first d: cut it off, also for the replay
        range_ = case(range_.text.replace(f"{family.first} <= d", f"{low} <= d"), low)
    value = range_("d/4") - squared_distance(*pair.vertices(), range_)

    def core(**letters: int) -> Exact:
        squares = the_simplex(family.letter, letters["d"]).squared_edge_lengths
        j, k = node(pair.j, **letters), node(pair.k, **letters)
        return squares[0, letters["d"]] - squares[j, k]

    return inequality(
        f"the edge from $u_{{{pair.j}}}$ to $u_{{{pair.k}}}$ is no longer",
        rf"\tfrac d4 - \|u_{{{pair.j}}} - u_{{{pair.k}}}\|^2", value, range_, core=core,
    )  # fmt: skip


def _longest_a(text: str, parity: str) -> Iterator[Step]:
    """A~: the squared edge is t(d + 1 - t)/(d + 1) with t = k - j, largest for t nearest to (d + 1)/2."""
    family = FAMILIES["A"]
    edge = "(k - j)*(d + 1 - k + j)/(d + 1)"
    inside = case("1 <= j < k <= d", 2)
    nodes = family.nodes[1]
    pair = Pair("j", "k", nodes, nodes, inside)

    def core(**letters: int) -> Exact:
        return the_simplex("A", letters["d"]).squared_edge_lengths[letters.get("j", 0), letters["k"]]

    yield identity(
        "an edge", r"\|u_k - u_j\|^2", squared_distance(*pair.vertices(), inside), edge, inside, core
    )
    outer = case("1 <= k <= d", 2)
    zero = squared_distance(vertex(family.nodes[0]), vertex(nodes), outer)
    yield identity("an edge at $u_0$", r"\|u_k - u_0\|^2", zero, "k*(d + 1 - k)/(d + 1)", outer, core)
    square = "(d + 1)/4" if parity == "odd" else "d*(d + 2)/(4*(d + 1))"
    d = "2*m + 1" if parity == "odd" else "2*m"
    middle = "m + 1" if parity == "odd" else "m"
    below, above = case("1 <= k <= m", d=d), case("1 <= m < k", d=d)
    for range_, words in ((below, "up to the middle"), (above, "beyond the middle")):
        yield inequality(
            f"with $t = k - j$ written as $k$, {words}",
            r"L^2 - \frac{t(d+1-t)}{d+1}", f"{square} - k*(d + 1 - k)/(d + 1)", range_,
        )  # fmt: skip
    yield identity(
        f"and the middle edge, with $m = {'(d-1)/2' if parity == 'odd' else 'd/2'}$, is as long",
        rf"\|u_{{{middle}}} - u_0\|^2",
        f"({middle})*(d + 1 - ({middle}))/(d + 1)".replace("m", "(d - 1)/2" if parity == "odd" else "d/2"),
        square, case("2 <= d", 2),
    )  # fmt: skip
    yield formulas("so the longest edge", "L", f"sqrt({square})", text, 3 if parity == "odd" else 2, parity,
                   core=lambda d: the_simplex("A", d).longest_edge)  # fmt: skip


# -- volume (item 7) ----------------------------------------------------------------------------------


def volume(letter: str, claimed: str | None = None) -> Proof:
    """The volume 1/(d! · Π m_k · √det), the determinant by recurrence along the diagram."""
    family = FAMILIES[letter]
    claimed = claimed or form(letter, "volume")
    determinant = _ENDS[letter][3]
    powers = "*".join(f"{n.mark}**({n.high} - ({n.low}) + 1)" for n in family.nodes)
    return join(
        rf"the volume of the simplex of $\tilde{{{letter}}}_d$, for every $d \geq {family.first}$",
        roots_squared(letter),
        determinants(letter),
        argument(
            "The vertices are the fundamental coweights over the marks, and the coweights are dual to the "
            r"simple roots, so $\operatorname{vol} = \frac{1}{d!\,\prod m_k\sqrt{\det G}}$"
        ),
        formulas("the product of the marks, class by class", r"\prod m_k", powers, _PRODUCTS[letter],
                 family.first, core=lambda d: Surd(prod(the_triangulation(letter, d).marks))),
        formulas("the volume", r"\operatorname{vol}", f"1/(factorial(d)*({powers})*sqrt({determinant}))",
                 claimed, family.first, core=lambda d: the_simplex(letter, d).volume),
    )  # fmt: skip


_PRODUCTS = {"A": "1", "B": "2**(d - 1)", "C": "2**(d - 1)", "D": "2**(d - 3)"}


def determinants(letter: str) -> Iterator[Step]:
    """The determinant of the Gram matrix of the simple roots, by expansion at the end of the diagram."""
    family = FAMILIES[letter]
    yield from _path(letter)
    yield argument(
        "A path of $n$ roots of squared length 2 with neighbours at $-1$, expanded at its end, has "
        "$D_n = 2D_{n-1} - D_{n-2}$, with $D_0 = 1$ and $D_1 = 2$"
    )
    yield identity("so $D_n = n + 1$, by induction", "2D_{d-1} - D_{d-2}", "2*d - (d - 1)", "d + 1",
                   case("2 <= d", 2), lambda d: the_triangulation("A", d).roots.gram_determinant)  # fmt: skip
    if letter != "A":
        words, name, value, determinant = _ENDS[letter]
        yield identity(words, name, value, determinant, case(f"{family.first} <= d", family.first),
                       lambda d: the_triangulation(letter, d).roots.gram_determinant)  # fmt: skip


def _path(letter: str) -> Iterator[Step]:
    """The inner products of simple roots: the path, and what hangs at its end."""
    step = FAMILIES["A"].nodes[1].root if letter == "A" else FAMILIES["C"].nodes[1].root
    before_last, last = ("d - 1", "d") if letter == "A" else ("d - 2", "d - 1")
    first, second, third = (vector(step, index) for index in ("j", "k", "(k + 1)"))
    near, far = case(f"1 <= k <= {before_last}", 3), case(f"1 <= j < m < k <= {last}", 3)
    yield identity(
        "neighbours on the path", r"\langle s_k, s_{k+1}\rangle", inner(second, third, near), "-1", near
    )
    yield identity("others are orthogonal", r"\langle s_j, s_k\rangle", inner(first, second, far), "0", far)
    if letter == "A":
        return
    end = FAMILIES[letter].nodes[-1].root
    joined, expected = {"B": ("d - 1", "-1"), "C": ("d - 1", "-2"), "D": ("d - 2", "-1")}[letter]
    whole = case("4 <= d", 4)
    value = inner(vector(step, f"({joined})"), runs(*end), whole)
    yield identity("the root at the end", rf"\langle s_{{{joined}}}, s_d\rangle", value, expected, whole)
    if letter == "D":
        value = inner(vector(step, "(d - 1)"), runs(*end), whole)
        yield identity("and its twin", r"\langle s_{d-1}, s_d\rangle", value, "0", whole)
    rest = case(f"1 <= k < m <= {joined}", 3)
    yield identity(
        "the others are orthogonal to it",
        r"\langle s_k, s_d\rangle",
        inner(second, runs(*end), rest),
        "0",
        rest,
    )


_ENDS = {
    "A": ("", "", "", "d + 1"),
    "B": (
        r"the short root at the end: $\|s_d\|^2 = 1$, $\langle s_{d-1}, s_d\rangle = -1$",
        r"\det G = D_{d-1} - D_{d-2}", "d - (d - 1)", "1",
    ),
    "C": (
        r"the long root at the end: $\|s_d\|^2 = 4$, $\langle s_{d-1}, s_d\rangle = -2$",
        r"\det G = 4D_{d-1} - 4D_{d-2}", "4*d - 4*(d - 1)", "4",
    ),
    "D": (
        "the fork: $s_d$ is joined to $s_{d-2}$; without both there remain a path and $s_{d-1}$",
        r"\det G = 2D_{d-1} - 2D_{d-3}", "2*d - 2*(d - 2)", "4",
    ),
}  # fmt: skip
"""The last expansion of the determinant: words, formula, its value, the determinant."""
