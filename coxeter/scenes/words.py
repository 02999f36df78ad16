"""A scene in words: for those who cannot see it, for those who want its numbers, for each reflection."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from math import gcd
from typing import NamedTuple

from ..exact import Exact, Surd, surd
from ..simplex import Position
from .scene import Apex, Scene
from .solids import solid
from .stars import Alcove, Mirror, Star

_SUBSCRIPTS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_MINUS = "\N{MINUS SIGN}"
_DIGITS = 4
_WHERE = {
    Position.INSIDE: "inside the simplex",
    Position.BOUNDARY: "on the boundary of the simplex",
    Position.OUTSIDE: "outside the simplex",
}


class Row(NamedTuple):
    """A row of the table of numbers: what it is, its exact value, and a remark or decimals."""

    what: str
    exact: str
    remark: str = ""


# -- signs ------------------------------------------------------------------------------------------------


def number(x: Exact | int) -> str:
    """An exact number as one writes it.

    >>> from coxeter import surd
    >>> number(surd("1/(2 + 4*sqrt(2))"))
    '1/(2 + 4√2)'
    """
    return re.sub(r"\*?sqrt\((\d+)\)", r"√\1", str(x)).replace("-", _MINUS)


def point(x: Iterable[Exact]) -> str:
    """A point as one writes it: ``(1/2, 0, −1/2)``."""
    return "(" + ", ".join(map(number, x)) + ")"


def sub(letter: str, k: int) -> str:
    """A letter with an index: ``u₂``."""
    return letter + str(k).translate(_SUBSCRIPTS)


def equation(mirror: Mirror) -> str:
    """The equation of a mirror, in lowest terms.

    >>> from coxeter.scenes import scene
    >>> equation(scene("A~3").star.alcoves[0].walls[0])
    'x₁ − x₄ = 1'
    """
    terms, common = "", gcd(*(x.numerator for x in (*mirror.root, mirror.k)))
    for i, x in enumerate((x / common for x in mirror.root), 1):
        if x:
            sign = (_MINUS if x < 0 else "+") if terms or x < 0 else ""
            factor = "" if abs(x) == 1 else number(abs(x))
            terms += f" {sign} {factor}{sub('x', i)}" if terms else f"{sign}{factor}{sub('x', i)}"
    return f"{terms} = {number(mirror.k / common)}"


def word(alcove: Alcove) -> str:
    """A simplex by its reflections: ``s₁s₂``."""
    return "".join(sub("s", k) for k in alcove.word) or "the fundamental simplex"


def decimal(x: Exact) -> str:
    """A number in decimals."""
    return surd(x).decimal(_DIGITS).replace("-", _MINUS)


def decimals(x: Sequence[Exact]) -> str:
    """A point in decimals, if a coordinate is irrational."""
    return "" if all(surd(c).is_rational for c in x) else "(" + ", ".join(map(decimal, x)) + ")"


# -- sentences ----------------------------------------------------------------------------------------------


def named(scene: Scene) -> str:
    """The name of the triangulation as one writes it: ``Ã₃``."""
    return scene.name.replace("~", "\N{COMBINING TILDE}").translate(_SUBSCRIPTS)


def verdict(scene: Scene) -> str:
    """Whether the triangulation is Delaunay, and by what one sees it."""
    where = f"The circumcentre lies {_WHERE[scene.position]}: {named(scene)} is {_delaunay(scene)}."
    return f"{where} {in_the_ball(scene)}"


def in_the_ball(scene: Scene) -> str:
    parts = []
    for where in (Position.INSIDE, Position.BOUNDARY, Position.OUTSIDE):
        names = [_apex(apex) for apex in scene.apexes if apex.where is where]
        if len(names) == len(scene.apexes):
            return f"The apexes of all four neighbours lie {_side(where)}."
        if names:
            parts.append(f"{joined(names)} {'lies' if len(names) == 1 else 'lie'} {_side(where)}")
    return f"Of the apexes of the four neighbours, {', '.join(parts)}."


def _apex(apex: Apex) -> str:
    return f"{sub('s', apex.label)}({sub('u', apex.label)})"


def joined(parts: Sequence[str]) -> str:
    """Parts as a list in a sentence."""
    return parts[0] if len(parts) == 1 else f"{', '.join(parts[:-1])} and {parts[-1]}"


def filled(star: Star) -> str:
    """How many simplices there are around a vertex, and what they fill."""
    return f"{len(star.alcoves)} simplices around {sub('u', star.label)}: {solid(star).name}"


def summary(scene: Scene) -> str:
    """The alternative text."""
    return f"{of_simplex(scene)} {of_star(scene.star)}"


def of_simplex(scene: Scene) -> str:
    """The fundamental simplex and its spheres in words."""
    corners = joined([f"{sub('u', k)} = {point(u)}" for k, u in enumerate(scene.vertices)])
    return (
        f"Fundamental simplex of {named(scene)} with the vertices {corners}. Its circumsphere has the centre "
        f"{point(scene.circumcentre)} and the radius {number(scene.circumradius)}, its insphere the centre "
        f"{point(scene.incentre)} and the radius {number(scene.inradius)}. {verdict(scene)}"
    )


def of_star(star: Star) -> str:
    """The simplices around a vertex in words."""
    return (
        f"The {len(star.alcoves)} simplices around {sub('u', star.label)}, moved apart; together they fill "
        f"{solid(star).name}. The fundamental simplex is green; of the others those that an even number of "
        "reflections makes are blue, the rest yellow."
    )


def reflection(star: Star, i: int) -> str:
    """What step i adds, by its mirror."""
    step, new = star.steps[i], star.alcoves[i + 1]
    old = star.alcoves[step.parent]
    return (
        f"Reflection {i + 1} of {len(star.steps)}: in the mirror {equation(step.mirror)} of its facet "
        f"{step.facet}, {word(old)} becomes {word(new)}. Vertex {step.facet} moves from "
        f"{point(old.vertices[step.facet])} to {point(new.vertices[step.facet])}."
    )


def told(scene: Scene) -> dict[str, str]:
    """A sentence or two for each thing that can be shown."""
    simplex = scene.triangulation.simplex
    normals = [f"{sub('n', f.index)} = {point(f.normal)}" for f in scene.facets]
    walls = [f"{equation(wall)} of facet {k}" for k, wall in enumerate(scene.star.alcoves[0].walls)]
    corners = [f"{sub('u', k)} = {point(u)}" for k, u in enumerate(scene.vertices)]
    squares = [f"{number(apex.squared_distance)} for {_apex(apex)}" for apex in scene.apexes]
    in_decimals = decimals(scene.incentre)
    return {
        "simplex": f"Fundamental simplex: {joined(corners)}.",
        "circumsphere": f"Circumsphere: radius {approximately(scene.circumradius)}. {in_the_ball(scene)}",
        "circumcentre": f"Circumcentre: {point(scene.circumcentre)}. It lies {_WHERE[scene.position]}: "
        f"{named(scene)} is {_delaunay(scene)}.",
        "incentre": f"Incentre: {point(scene.incentre)}{in_decimals and f' ≈ {in_decimals}'}. "
        f"Inradius: {approximately(scene.inradius)}.",
        "normals": f"Inward normals: {joined(normals)}.",
        "mirrors": f"Mirrors: {joined(walls)}.",
        "apexes": f"{in_the_ball(scene)} Squared distances from the circumcentre: {joined(squares)}; "
        f"of the vertices, {number(simplex.squared_circumradius)}.",
    }


def _delaunay(scene: Scene) -> str:
    return "Delaunay" if scene.delaunay else "not Delaunay"


def approximately(x: Surd) -> str:
    """A number, and its decimals."""
    return f"{number(x)} ≈ {decimal(x)}"


# -- the table ---------------------------------------------------------------------------------------------


def rows(scene: Scene) -> list[Row]:
    """The numbers of a scene."""
    simplex = scene.triangulation.simplex
    walls = scene.star.alcoves[0].walls
    weights = [f"{number(x)}" for x in simplex.circumcentre_coordinates]
    found = [Row(f"Vertex {sub('u', k)}", point(u), decimals(u)) for k, u in enumerate(scene.vertices)]
    found += [
        Row("Circumcentre", point(scene.circumcentre), decimals(scene.circumcentre)),
        Row("Its barycentric coordinates", f"({', '.join(weights)})", _WHERE[scene.position]),
        Row("Circumradius", number(scene.circumradius), decimal(scene.circumradius)),
        Row("Incentre", point(scene.incentre), decimals(scene.incentre)),
        Row("Inradius", number(scene.inradius), decimal(scene.inradius)),
    ]
    found += [
        Row(f"Facet {f.index}: inward normal, mirror", point(f.normal), equation(wall))
        for f, wall in zip(scene.facets, walls, strict=True)
    ]
    found += [
        Row(f"Angle between facets {i} and {j}", f"π/{angle.denominator}", f"{180 * angle}°")
        for (i, j), angle in scene.dihedral_angles.items()
    ]
    found += [
        Row(
            f"Neighbour’s apex {_apex(apex)}",
            f"{point(apex.point)}, squared distance {number(apex.squared_distance)} from the circumcentre",
            _side(apex.where),
        )
        for apex in scene.apexes
    ]
    found += [
        Row(f"Around {sub('u', star.label)}", f"{len(star.alcoves)} simplices", solid(star).name)
        for star in scene.stars
    ]
    return found


def _side(where: Position) -> str:
    return f"{'on' if where is Position.BOUNDARY else where.value} the circumsphere"
