"""Texts as LaTeX in plain ASCII, which any LaTeX can compile without packages for letters."""

from __future__ import annotations

from .wording import pieces

SPECIAL = {
    "\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "|": r"\textbar{}",
    "–": "--", "—": "---", "…": r"\dots{}", "‘": "`", "’": "'", "“": "``", "”": "''",
    "\N{NO-BREAK SPACE}": "~", "é": r"\'e", "è": r"\`e", "ö": r'\"o', "ü": r'\"u', "ä": r'\"a',
    "\N{COMBINING TILDE}": "", "∎": "",
    **{x: f"\\{x}" for x in "{}$&#%_"},
}  # fmt: skip
"""Letters that mean something to LaTeX, or that it does not know."""

SIGNS = {
    "<": "<", ">": ">", "·": r"\cdot", "×": r"\times", "±": r"\pm", "≤": r"\leq", "≥": r"\geq", "≠": r"\neq",
    "∞": r"\infty", "′": "'", "²": "^2", "³": "^3", "½": r"\frac12", "√": r"\surd", "−": "-", "→": r"\to",
    "∈": r"\in", "⊂": r"\subset", "∪": r"\cup", "°": r"^\circ", "∑": r"\sum",
    "⟨": r"\langle", "⟩": r"\rangle",
    "∨": r"\vee", "∅": r"\emptyset", "≈": r"\approx", "∼": r"\sim",
}  # fmt: skip
"""Signs of formulas that stand among words."""

GREEK = (
    "αalpha βbeta γgamma δdelta εvarepsilon ζzeta ηeta θtheta ιiota κkappa λlambda μmu νnu ξxi πpi ρrho "
    "σsigma τtau υupsilon φvarphi χchi ψpsi ωomega "
    "ΓGamma ΔDelta ΘTheta ΛLambda ΞXi ΠPi ΣSigma ΦPhi ΨPsi ΩOmega"
)
SIGNS |= {name[0]: f"\\{name[1:]}" for name in GREEK.split()}


def to_latex(text: str) -> str:
    """A text as LaTeX in plain ASCII.

    >>> print(to_latex("For A~3, 5 % of R^d: sqrt(2)/6"))
    For $\\tilde{A}_{3}$, 5 \\% of $\\mathbb{R}^{d}$: $\\frac{\\sqrt{2}}{6}$
    """
    return "".join(escape(p.text) if p.kind == "words" else f"${maths(p.text)}$" for p in pieces(text))


def escape(text: str) -> str:
    """Words as LaTeX."""
    return "".join(_letter(x) for x in text)


def maths(text: str) -> str:
    """A formula in ASCII: what LaTeX has a command for is written with it."""
    return "".join(x if x.isascii() else f"{{{SIGNS[x]}}}" if x in SIGNS else _letter(x) for x in text)


def _letter(x: str) -> str:
    if x in SIGNS:
        return rf"\ensuremath{{{SIGNS[x]}}}"
    if x in SPECIAL:
        return SPECIAL[x]
    return x if x.isascii() else f"[U+{ord(x):04X}]"
