"""A report with every block in it, for the tests of the writers."""

from dataclasses import dataclass

from freebody.language.expression import Expr, Number, Symbol
from freebody.language.parser import parse
from freebody.present.report.blocks import (
    Bullets,
    Choices,
    Columns,
    Derivative,
    Difference,
    Emphasis,
    Equation,
    Equations,
    Figure,
    Figures,
    Formula,
    Paragraph,
    Reference,
    Remark,
    Report,
    Room,
    Section,
    Side,
    Step,
    Table,
    Unbroken,
    text,
)

HOSTILE = "<script>alert(1)</script> $x$ 100 % a_b \\input{x} #1 \"q\" 'p' *b* `c` [l](u) {d} ~ ^ & | @ // = - +"


@dataclass(frozen=True)
class Drawing:
    """A block on a slope."""

    title: str = "Block on a slope"
    description: str = "A block on an incline with its weight and the normal force."

    def svg(self, *, dark: bool | None = None, is_marked: bool = False) -> str:
        return (
            '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 240 130" width="240" height="130">'
            "<style>.ink{stroke:#1f2328;fill:none;stroke-width:1.5}.body{fill:#0072b2;fill-opacity:.3;stroke:#0072b2}"
            "@media (prefers-color-scheme: dark){.ink{stroke:#e6e9ec}.body{fill:#56b4e9;stroke:#56b4e9}}</style>"
            '<path class="ink" d="M10 120 L230 120 L230 20 Z"/>'
            '<rect class="body" x="100" y="35" width="50" height="30" transform="rotate(-24 125 50)"/>'
            '<path class="ink" d="M125 50 L125 105 M120 97 L125 105 L130 97"/></svg>'
        )

    def tikz(self) -> str:
        strokes = r"\draw (0,0) -- (4,0) -- (4,2) -- cycle; \draw[->] (2,1.4) -- (2,0.4);"
        return rf"\begin{{tikzpicture}}{strokes}\end{{tikzpicture}}"

    def png(self, *, dark: bool = False) -> bytes:
        import base64

        return base64.b64decode(
            "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
        )

    def text(self) -> str:
        return "   ◢\n ◢██\n◢███"


@dataclass(frozen=True)
class Silent(Drawing):
    """A picture that has no text form."""

    def text(self) -> str:
        return ""


def formula(*parts: str | Side, unit: str = "") -> Formula:
    """Sides and relations in turn; a text is parsed."""
    sides = tuple(_side(part) for part in parts[::2])
    return Formula(sides, tuple(parts[1::2]), unit)  # type: ignore[arg-type]


def _side(part: str | Side) -> Side:
    return parse(part) if isinstance(part, str) else part


def vector(*entries: str) -> tuple[Expr, ...]:
    return tuple(parse(entry) for entry in entries)


L, T = Symbol("L"), Symbol("t")
RATE = parse("theta1'")
LAGRANGE = Difference(Derivative(Derivative(L, RATE, True), T), Derivative(L, Symbol("theta1"), True))
LONG = " + ".join(f"m_{k}*L_{k}^2*(theta_{k}'' + {k}*cos(theta_{k} - theta_1)*omega_{k}^2)" for k in range(1, 7))


def sample(language: str = "en") -> Report:
    picture = Drawing()
    newton = Equations(
        (
            Equation(formula("m*a_S", "=", "m*g*sin(alpha) - F_r"), 1, "along the slope, ↘:", text("Newton")),
            Equation(formula("0", "=", "N - m*g*cos(alpha)"), 2, "across, ↖:"),
            Equation(formula("J_S*theta1''", "=", "F_r*r"), 3, "about S, ↶:"),
        )
    )
    result = Equations((Equation(formula("a_S", "=", "g*sin(alpha)/(1 + J_S/(m*r^2))", "≈", "3.27", unit="m/s^2"), 4),))
    left = (
        Paragraph(text("By the second law, with ", Reference(1), " and ", Reference(3), ":")),
        newton,
    )
    right = (
        Paragraph(text("By Lagrange, in one line:")),
        Equations(
            (
                Equation(formula("L", "=", "1/2*m*x'^2 + 1/2*J_S*theta1'^2 - m*g*x*sin(alpha)"), 5),
                Equation(formula(LAGRANGE, "=", "0"), 6),
            )
        ),
    )
    steps = (
        Step(
            text("Cut the disk free"),
            text("Which forces act where the disk touches the slope? Think of ", formula("F_r"), "."),
            (
                Paragraph(
                    text(
                        "The body ",
                        Emphasis("disk", "code"),
                        " is ",
                        Emphasis("cut free"),
                        "; see ",
                        Reference(1, "figure"),
                        ".",
                    )
                ),
                newton,
                Remark(text("The disk is taken not to slip: ", formula("F_r", "≤", "mu_0*N"), "."), "warning"),
            ),
        ),
        Step(
            text("Solve for ", formula("a_S")),
            text("Eliminate ", formula("F_r"), " with ", formula("x'", "=", "r*theta1'"), "."),
            (
                Paragraph(text("From ", Reference(1), " and ", Reference(3), " it follows that")),
                result,
                Equations((Equation(formula("T", "=", LONG, "=", "m*x''^2*x'''/2"), 7, "", text("a long line")),)),
            ),
        ),
    )
    table = Table(
        (text("option"), text("formula"), text("why")),
        (
            (text("A"), text(formula("g*sin(alpha)")), text("the disk would have no inertia")),
            (text("B"), text(formula("2*g*sin(alpha)/3")), text("as derived in ", Reference(4))),
            (text("C"), text(formula("-(a + b)/c", "<", "abs(x)")), text(Emphasis("a | b", "code"))),
        ),
        ("wrong", "right", ""),
    )
    blocks = (
        Paragraph(
            text(
                "A homogeneous disk of mass ",
                formula("m"),
                " and radius ",
                formula("r"),
                " rolls down a slope of inclination ",
                formula("alpha", "=", "30", unit="°"),
                ". How large is the acceleration ",
                formula("a_S"),
                " of its centre? The answer is short; the way to it is worth a look, because the friction ",
                formula("F_r"),
                " does no work and yet cannot be left out. ",
                Emphasis("All values are exact until the last line.", "soft"),
            )
        ),
        Figure(picture, text("The disk and its ", Emphasis("free body"), " with ", formula("F_r", "→", "0")), 1),
        Section(
            text("Derivation"),
            (
                *steps,
                Remark(text(formula("a_S", "=", "2*g*sin(alpha)/3", "≈", "3.27", unit="m/s^2")), "result"),
                Remark(text("Five random draws agree with the numeric route to 1e-12."), "evidence"),
            ),
        ),
        Section(text("Two ways"), (Columns(left, right),)),
        Section(
            text("Options"),
            (
                table,
                Bullets((text("first, ", formula("r_OS", "=", vector("x", "-r*cos(phi)", "0"))), text("second"))),
                Bullets((text("one"), text("two")), is_numbered=True),
                Unbroken((Choices((("(a)", text(formula("g/2"))), ("(b)", text("none, ", formula("g"))))), Room(2.5))),
                Section(text("Inner section"), (Paragraph(text("Deeper.")),), level=3),
                Figures(
                    (
                        Figure(picture, text("Before"), 2),
                        Figure(Silent(), text("After: ", formula("omega_max", "=", "12.5", unit="rad/s")), 3),
                    )
                ),
                Equations(
                    (
                        Equation(formula(vector("F_x", "F_y/2"), "=", vector("m*x''", "0"), unit="N"), 8),
                        Equation(formula("x_1_2*crank", "≠", "1e-20*m_rod*Omega", "⇒", "x", ">", "0")),
                        Equation(formula(Difference(L, Number(-parse("3").value)))),  # type: ignore[union-attr]
                    )
                ),
            ),
        ),
        Section(text("Names"), (Paragraph(text(HOSTILE, " ", Emphasis(HOSTILE, "code"), " ä ß é μ² 30° √2 − ≥")),)),
    )
    words = (
        {"hint": "Hinweis", "show the step": "Schritt zeigen", "figure": "Bild", "babel": "ngerman"}
        if language == "de"
        else {}
    )
    return Report("A disk rolls down a slope", language, "Worked solution of disk.yaml", blocks, words)


def hostile() -> Report:
    """Texts that would be markup in some format, in every place where a text can stand."""
    words = text(HOSTILE)
    picture = Drawing(HOSTILE, HOSTILE)
    equation = Equation(formula("a", "=", "b", unit="m/s^2"), 1, HOSTILE, text(HOSTILE, Emphasis(HOSTILE, "code")))
    blocks = (
        Paragraph((*words, Emphasis(HOSTILE, "code"), Emphasis(HOSTILE), Emphasis(HOSTILE, "soft"))),
        Equations((equation, equation)),
        Bullets((words, words)),
        Unbroken((Choices(((HOSTILE, words),)), Room(1.0))),
        Table((words, words), ((words, words),), ("right",)),
        Figure(picture, words, 1),
        Figures((Figure(picture, words, 2),)),
        Section(words, (Step(words, words, (Paragraph(words),)), Columns((Paragraph(words),), (Paragraph(words),)))),
        *(Remark(words, kind) for kind in ("result", "evidence", "warning")),
    )
    return Report(HOSTILE, "en", HOSTILE, blocks, {"hint": HOSTILE, "figure": HOSTILE, "show the step": HOSTILE})
