"""Texts as LaTeX in plain ASCII, which any LaTeX can compile without packages for letters."""

from __future__ import annotations

from .wording import pieces

SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%",
    "_": r"\_", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\ensuremath{<}",
    ">": r"\ensuremath{>}", "|": r"\textbar{}", "–": "--", "—": "---", "…": r"\dots{}", "‘": "`", "’": "'",
    "“": "``", "”": "''", "·": r"\ensuremath{\cdot}", "×": r"\ensuremath{\times}", "±": r"\ensuremath{\pm}",
    "≤": r"\ensuremath{\leq}", "≥": r"\ensuremath{\geq}", "≠": r"\ensuremath{\neq}", "∞": r"\ensuremath{\infty}",
    "′": r"\ensuremath{'}", "²": r"\ensuremath{^2}", "³": r"\ensuremath{^3}", "½": r"\ensuremath{\frac12}",
    "√": r"\ensuremath{\surd}", "−": r"\ensuremath{-}", "→": r"\ensuremath{\to}", "∈": r"\ensuremath{\in}",
    "⊂": r"\ensuremath{\subset}", "∪": r"\ensuremath{\cup}", "°": r"\ensuremath{^\circ}", "\N{NO-BREAK SPACE}": "~",
    "é": r"\'e", "è": r"\`e", "ö": r'\"o', "ü": r'\"u', "ä": r'\"a', "\N{COMBINING TILDE}": "",
    "∎": "", "∑": r"\ensuremath{\sum}", "⟨": r"\ensuremath{\langle}", "⟩": r"\ensuremath{\rangle}",
    "∨": r"\ensuremath{\vee}", "∅": r"\ensuremath{\emptyset}", "≈": r"\ensuremath{\approx}", "∼": r"\ensuremath{\sim}",
}  # fmt: skip
GREEK = dict(zip(
    "αβγδεζηθικλμνξπρστυφχψω", "alpha beta gamma delta varepsilon zeta eta theta iota kappa lambda mu nu xi pi rho "
    "sigma tau upsilon varphi chi psi omega".split(), strict=True,
)) | dict(zip("ΓΔΘΛΞΠΣΦΨΩ", "Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega".split(), strict=True))  # fmt: skip


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
    return "".join(x if x.isascii() else _letter(x).removeprefix(r"\ensuremath{").removesuffix("}") for x in text)


def _letter(x: str) -> str:
    if x in GREEK:
        return rf"\ensuremath{{\{GREEK[x]}}}"
    if x in SPECIAL:
        return SPECIAL[x]
    return x if x.isascii() else f"[U+{ord(x):04X}]"
