"""A scene as HTML: the drawing, the numbers as text, and the data that a script makes a picture to turn of.

The drawing and the numbers need no script. The book's script, ``space.js``, looks for elements of the
class ``cx-scene``, reads the data, and puts the picture and its controls in the place of the drawing.
"""

from __future__ import annotations

import html
import json
import re
from collections.abc import Iterable, Sequence
from typing import Any

from ..exact import Exact
from .drawing import direction, floats
from .scene import Scene
from .stars import Mirror
from .words import filled, of_star, reflection, rows, told, verdict

_DIGITS = 6
_ROW = "display:flex;flex-wrap:wrap;justify-content:center;align-items:center;gap:1rem 2rem"


def figure_html(scene: Scene) -> str:
    """The whole element."""
    drawings = "\n".join(part.svg for part in scene.figure.parts)
    data = json.dumps(as_data(scene), separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    return (
        f'<figure class="cx-scene">\n<div class="cx-still" style="{_ROW}">\n{drawings}\n</div>\n'
        f"<figcaption>{_set(verdict(scene))}</figcaption>\n{_numbers(scene)}\n{_reflections(scene)}\n"
        f'<script type="application/json">{data}</script>\n</figure>'
    )


# -- the numbers as text ----------------------------------------------------------------------------------


def _numbers(scene: Scene) -> str:
    body = "".join(
        f'<tr><th scope="row">{_set(row.what)}</th><td>{_set(row.exact)}</td><td>{_set(row.remark)}</td></tr>'
        for row in rows(scene)
    )
    head = '<th scope="col">What</th><th scope="col">Exact</th><th scope="col">Remark, or decimals</th>'
    name = f"The numbers of {scene.name}"
    return (
        f'<details class="cx-numbers"><summary>{_set(name)}</summary>'
        f'<div class="table-box cx-scroll" role="region" tabindex="0" aria-label="{html.escape(name)}">'
        f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div></details>"
    )


def _reflections(scene: Scene) -> str:
    star = scene.star
    steps = "".join(f"<li>{_set(reflection(star, i))}</li>" for i in range(len(star.steps)))
    return (
        f'<details class="cx-steps"><summary>{_set(filled(star))}, reflection by reflection</summary>'
        f"<p>{_set(of_star(star))}</p><ul>{steps}</ul></details>"
    )


def _set(text: str) -> str:
    """Text as HTML, with ``B~3`` as one writes it."""
    return re.sub(r"\b([A-G])~(\d)", "\\1\N{COMBINING TILDE}<sub>\\2</sub>", html.escape(text, quote=False))


# -- the data ---------------------------------------------------------------------------------------------


def as_data(scene: Scene) -> dict[str, Any]:
    """What the script needs, in the coordinates of the picture, rounded; points go by their numbers."""
    alcoves = list(dict.fromkeys(alcove.vertices for star in scene.stars for alcove in star.alcoves))
    points = list(dict.fromkeys(v for alcove in alcoves for v in alcove))
    mirrors = list(dict.fromkeys(m for star in scene.stars for m in star.mirrors))
    number = {point: i for i, point in enumerate(points)}
    return {
        "name": re.sub("~", "\N{COMBINING TILDE}", scene.name),
        "title": scene.title,
        "towards": _rounded(direction(scene)),
        "points": [_rounded(floats(scene, point)) for point in points],
        "alcoves": [[number[vertex] for vertex in alcove] for alcove in alcoves],
        "stars": [
            {
                "centre": number[star.centre],
                "about": filled(star),
                "alcoves": [alcoves.index(alcove.vertices) for alcove in star.alcoves],
                "odd": [alcove.parity for alcove in star.alcoves],
                "steps": [[step.parent, step.facet, mirrors.index(step.mirror)] for step in star.steps],
                "told": [reflection(star, i) for i in range(len(star.steps))],
            }
            for star in scene.stars
        ],
        "around": scene.around,
        "mirrors": [_plane(scene, mirror) for mirror in mirrors],
        "walls": [_plane(scene, wall) for wall in scene.star.alcoves[0].walls],
        "normals": [_exact(scene, facet.normal) for facet in scene.facets],
        "circumcentre": _exact(scene, scene.circumcentre),
        "circumradius": round(float(scene.circumradius), _DIGITS),
        "incentre": _exact(scene, scene.incentre),
        "inradius": round(float(scene.inradius), _DIGITS),
        "apexes": [
            {"at": _exact(scene, apex.point), "label": apex.label, "where": apex.where.value}
            for apex in scene.apexes
        ],
        "told": told(scene),
    }


def _exact(scene: Scene, vector: Sequence[Exact]) -> list[float]:
    return _rounded(floats(scene, vector))


def _plane(scene: Scene, mirror: Mirror) -> list[float]:
    """The unit normal of a hyperplane, and its distance from the origin, with a sign."""
    normal = floats(scene, mirror.root)
    length = sum(x * x for x in normal) ** 0.5
    return _rounded([x / length for x in (*normal, float(mirror.k))])


def _rounded(numbers: Iterable[float]) -> list[float]:
    return [round(x, _DIGITS) + 0.0 for x in numbers]
