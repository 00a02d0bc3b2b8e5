import math
import subprocess
import sys
from fractions import Fraction

import pint
import pytest

import freebody as fb
from freebody.errors import UnitError
from freebody.language.parser import parse
from freebody.language.units import (
    ACCELERATION,
    ANGULAR_VELOCITY,
    DIMENSIONLESS,
    FORCE,
    INERTIA,
    LENGTH,
    MASS,
    PRESSURE,
    STIFFNESS,
    TIME,
    TORQUE,
    VELOCITY,
    Dimension,
    dimension_of,
    parse_quantity,
    parse_unit,
)
from freebody.language.units.table import PREFIXED as _PREFIXED
from freebody.language.units.table import PREFIXES as _PREFIXES
from freebody.language.units.table import UNITS as _UNITS

REGISTRY = pint.UnitRegistry()


@pytest.mark.parametrize(
    ("text", "value", "dimension"),
    [
        ("3 kg", 3.0, MASS),
        ("0.1 m", 0.1, LENGTH),
        ("9.81 m/s^2", 9.81, ACCELERATION),
        ("9.81 m/s²", 9.81, ACCELERATION),
        ("9.81 m s^-2", 9.81, ACCELERATION),
        ("9.81 m s⁻²", 9.81, ACCELERATION),
        ("30 deg", math.radians(30), DIMENSIONLESS),
        ("30°", math.radians(30), DIMENSIONLESS),
        ("2 rad", 2.0, DIMENSIONLESS),
        ("1500 rpm", 50 * math.pi, ANGULAR_VELOCITY),
        ("5 kN", 5000.0, FORCE),
        ("3", 3.0, DIMENSIONLESS),
        (3, 3.0, DIMENSIONLESS),
        (0.1, 0.1, DIMENSIONLESS),
        (Fraction(1, 4), 0.25, DIMENSIONLESS),
        ("2.5e-3 kg m^2", 0.0025, INERTIA),
        ("2.5e-3 kg*m**2", 0.0025, INERTIA),
        ("2.5e-3 kg·m²", 0.0025, INERTIA),
        ("4 N/m", 4.0, STIFFNESS),
        ("2 N/mm", 2000.0, STIFFNESS),
        ("7 1/s", 7.0, ANGULAR_VELOCITY),
        ("7/s", 7.0, ANGULAR_VELOCITY),
        ("-2 m/s", -2.0, VELOCITY),
        ("−2 m/s", -2.0, VELOCITY),
        ("3 N m/(rad)", 3.0, TORQUE),
        ("1 MPa", 1e6, PRESSURE),
        ("1 inch", 0.0254, LENGTH),
        ("2 ms", 0.002, TIME),
        ("2 min", 120.0, TIME),
        ("0 kg", 0.0, MASS),
        ("1 m/s/s", 1.0, ACCELERATION),
        ("1/4 m", 0.25, LENGTH),
        ("-3 / 8 kg", -0.375, MASS),
        ("1/2 1/s", 0.5, ANGULAR_VELOCITY),
    ],
)
def test_quantities_are_read_into_si(text, value, dimension):
    quantity = parse_quantity(text)
    assert quantity.value == pytest.approx(value, rel=1e-15)
    assert quantity.dimension == dimension


def test_values_stay_exact_where_they_can():
    assert parse_quantity("0.1 m").exact == Fraction(1, 10)
    assert parse_quantity(0.1).exact == Fraction(1, 10)
    assert parse_quantity("1 inch").exact == Fraction(254, 10000)
    angle = parse_quantity("30 deg")
    assert (angle.exact, angle.degrees, angle.is_angle) == (None, 30, True)
    assert parse_quantity("0.5 rev").degrees == 180
    assert parse_quantity("2 rad").exact == 2
    assert not parse_quantity("10 deg/s").is_angle
    speed = parse_quantity("300 rpm")
    assert (speed.exact, speed.of_pi, speed.degrees) == (None, 10, None)


@pytest.mark.parametrize("name", sorted(_UNITS))
def test_every_unit_of_the_table_agrees_with_pint(name):
    unit = _UNITS[name]
    theirs = REGISTRY.Quantity(1.0, {"rev": "revolution"}.get(name, name)).to_base_units()
    assert float(unit.factor) * math.pi**unit.pi_power == pytest.approx(theirs.magnitude, rel=1e-12)
    dimension = {f"[{base}]": getattr(unit.dimension, base) for base in ("mass", "length", "time")}
    assert dict(theirs.dimensionality) == {base: n for base, n in dimension.items() if n}
    assert unit.is_angle == (dict(theirs.unit_items()) == {"radian": 1})


def test_prefixed_units_agree_with_pint():
    for prefix in _PREFIXES:
        for symbol in _PREFIXED:
            if prefix + symbol not in (*_UNITS, "Grad"):  # a German degree, which is refused
                theirs = REGISTRY.Quantity(1.0, prefix + symbol).to_base_units().magnitude
                assert parse_quantity(f"1 {prefix}{symbol}").value == pytest.approx(theirs, rel=1e-12)


def test_rare_units_are_asked_of_pint():
    assert parse_quantity("1 fathom").value == pytest.approx(1.8288, rel=1e-4)
    assert parse_quantity("1 fathom").exact is None


def test_usual_units_do_not_import_pint():
    code = (
        "import sys; from freebody.language.units import parse_quantity; parse_quantity('5 kN/mm');"
        "sys.exit('pint' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("65 Grad", "write deg for degrees"),
        ("3 A", "current"),
        ("3 K", "temperature"),
        ("3 degC", "temperature"),
        ("3 mol", "substance"),
        ("3 cd", "luminosity"),
        ("3 kgg", "perhaps kg is meant"),
        ("3 newtn", "perhaps newton is meant"),
        ("3 Ns", "write N, or N s"),
        ("3 ftlb", "write ft lb"),
        ("3 N m/rad s", "two ways"),
        ("3 m^99", "number up to 12"),
        ("3 m^", "a power is a number"),
        ("3 m^(1/0)", "divided by zero"),
        ("3 m/", "at its end"),
        ("3 (m", "never closed"),
        ("3 m)", "not expected"),
        ("3 m$", r"'\$' cannot be used"),
        ("3 " + "(" * 50, "too many brackets"),
        ("3 " + "m " * 500, "at most 200"),
        ("kg", "write a number and a unit"),
        ("", "write a number and a unit"),
        ("nan", "not a quantity"),
        ("inf kg", "not a quantity"),
        ("3 nan", "must be finite"),
        (".inf", "not a quantity"),
        ("1e400", "too large"),
        ("1e300 Tm^3", "too large"),
        ("1e-300 pm^3", "too small"),
        (float("nan"), "nan"),
        (float("inf"), "inf"),
        (10**400, "too large"),
        (True, "'true' is not a number"),
        ("__import__('os')", "not a quantity"),
        ("3 m.__class__", "cannot be used"),
        ("9,81 m/s^2", "decimals stand after a point"),
        ("1/4/m", "a unit is needed before '4'"),
        ("1/0 m", "a unit is needed before '0'"),
    ],
)
def test_what_is_no_mechanical_quantity_is_refused_with_a_reason(text, part):
    with pytest.raises(UnitError, match=part):
        parse_quantity(text)


@pytest.mark.parametrize(
    ("written", "meant"),
    [
        ("3 Nm", "3 N m"),
        ("3 kNm", "3 kN m"),
        ("2 kgm^2", "2 kg m^2"),
        ("5 Nmm/rad", "5 N mm/rad"),
        ("2 Nms", "2 N m s"),
    ],
)
def test_units_that_are_written_together_are_read_where_they_mean_one_thing(written: str, meant: str) -> None:
    assert parse_quantity(written).value == parse_quantity(meant).value
    assert parse_quantity(written).dimension == parse_quantity(meant).dimension


@pytest.mark.parametrize(
    ("dimension", "text"),
    [
        (FORCE, "N"),
        (VELOCITY, "m/s"),
        (ACCELERATION, "m/s^2"),
        (INERTIA, "kg m^2"),
        (TORQUE, "N m"),
        (STIFFNESS, "N/m"),
        (ANGULAR_VELOCITY, "1/s"),
        (DIMENSIONLESS, "1"),
        (MASS / LENGTH / TIME, "kg/(m s)"),
        (LENGTH ** Fraction(1, 2), "m^(1/2)"),
    ],
)
def test_dimensions_print_as_the_usual_unit(dimension, text):
    assert str(dimension) == text


@pytest.mark.parametrize("exponents", [(m, n, t) for m in (-1, 0, 1) for n in (-2, 0, 3) for t in (-3, 0, 2)])
def test_a_printed_dimension_reads_back_as_itself(exponents):
    dimension = Dimension(*map(Fraction, exponents))
    assert parse_unit(str(dimension)).dimension == dimension


SYMBOLS = {
    "m": MASS,
    "m1": MASS,
    "m2": MASS,
    "g": ACCELERATION,
    "R": LENGTH,
    "x": LENGTH,
    "mu": DIMENSIONLESS,
    "radius": LENGTH,
    "v": VELOCITY,
}


@pytest.mark.parametrize(
    ("text", "dimension"),
    [
        ("2*m1*g/(m1 + m2)", ACCELERATION),
        ("m1 g R (1 - cos(x/R))", TORQUE),
        ("sqrt(2 g R)", VELOCITY),
        ("(g R)^(3/2)", VELOCITY**3),
        ("x'", VELOCITY),
        ("x'' + g", ACCELERATION),
        ("abs(x) + R", LENGTH),
        ("sign(x) mu^mu", DIMENSIONLESS),
        ("3 pi", DIMENSIONLESS),
        ("0", DIMENSIONLESS),
        ("x + sin(0)*R", LENGTH),
    ],
)
def test_the_dimension_of_an_expression_follows_from_its_symbols(text, dimension):
    assert dimension_of(parse(text), SYMBOLS) == dimension


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("m1 + R", "m1 [kg] + R [m]: unlike units cannot be added"),
        ("m1 - R", "m1 [kg] - R [m]: unlike units cannot be added"),
        ("1 + x", "1 [1] + x [m]: unlike units cannot be added"),
        (
            "x - 2 * m",
            "x [m] - 2*m [kg]: unlike units cannot be added; m is a name of this model here, not the unit: give the "
            "quantity a name of its own",
        ),
        ("sin(x)", "sin of x [m]: its argument must be without a unit"),
        ("2^x", "the exponent x [m] must be without a unit"),
        ("x^mu", "x [m] has a unit, so its exponent mu must be a number"),
        ("2 radiu", "'radiu' is not defined: did you mean radius?"),
    ],
)
def test_dimensions_that_do_not_fit_are_named_in_the_users_terms(text, message):
    with pytest.raises(UnitError) as caught:
        dimension_of(parse(text), SYMBOLS)
    assert str(caught.value) == message


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("180 deg - alpha", "pi - alpha"),
        ("L/2 + 5 cm", "L/2 + 0.05 m"),
        ("2*(b - 30 mm)", "2*b - 6 cm"),
        ("1/4 m + 3 cm", "0.28 m"),
        ("L - m", None),  # a mass, whatever else its letter may mean
        ("L + 2 kg", None),
        ("L/2 m", None),  # can be read in two ways
    ],
)
def test_quantities_stand_within_expressions(text: str, same: str | None) -> None:
    def read(length: str) -> str:
        place = f"angle: {length}" if "alpha" in length else f"points: {{Q: [{length}, 0]}}"
        asked = "x of rod.end at start" if "alpha" in length else "distance from rod.center to rod.Q"
        return f"""
parameters: {{L: 2 m, b: 50 cm, m: 3 kg, alpha: 70 deg}}
bodies: {{rod: {{rod: {{mass: m, length: L}}, {place}}}}}
connections: {{pin: {{pin: [ground.O, rod.start]}}}}
questions: [{asked}]
"""

    if same is None:
        with pytest.raises(fb.errors.InputError):
            fb.System.from_text(read(text))
        return
    first, second = (fb.System.from_text(read(t)).solve()["q1"].value for t in (text, same))
    assert first == pytest.approx(second, rel=1e-14)


@pytest.mark.parametrize(
    ("printed", "meant"),
    [
        (repr(20.0 / 0.3), Fraction(200, 3)),
        (repr(-20.0 / 0.37), Fraction(-2000, 37)),
        ("0.333333333333333", Fraction(1, 3)),
    ],
)
def test_a_printed_binary_number_is_the_simple_fraction_it_rounds(printed: str, meant: Fraction) -> None:
    """A wheel started with v/r in 16 digits would slip by 1e-15 m/s, and be pushed the wrong way at the start."""
    assert parse_quantity(f"{printed} rad/s").exact == parse_quantity(float(printed)).exact == meant


@pytest.mark.parametrize("written", ["66.667", "0.30000000000000004", "3.141592653589793", "1.000000000000001"])
def test_any_other_decimal_is_taken_as_it_stands(written: str) -> None:
    assert parse_quantity(written).exact == Fraction(written)


@pytest.mark.parametrize(
    ("text", "value", "dimension"),
    [
        ("2 kg/(m s)^(1/2)", 2.0, MASS / (LENGTH * TIME) ** Fraction(1, 2)),
        ("4 N/(km)^(1/2)", 4 / math.sqrt(1000), FORCE / LENGTH ** Fraction(1, 2)),
        ("3 mm^(-3/2)", 3 * 1000**1.5, LENGTH ** Fraction(-3, 2)),
        ("5 kg m^-0.5", 5.0, MASS / LENGTH ** Fraction(1, 2)),
    ],
)
def test_a_unit_may_have_a_broken_power_as_of_a_drag_with_the_speed_to_the_power_of_three_halves(
    text: str, value: float, dimension: Dimension
) -> None:
    quantity = parse_quantity(text)
    assert quantity.value == pytest.approx(value, rel=1e-14)
    assert quantity.dimension == dimension
    assert parse_unit(str(dimension)).dimension == dimension  # a dimension is read as it is written
