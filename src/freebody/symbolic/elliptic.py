"""The time of a way by energy where it is an elliptic integral of the first kind: dt = dq/sqrt(W), u^2 = W(q).

Two forms of W, with psi = n q - delta so that W is largest at psi = 0:

    W = a + r cos(psi)
      swings, a < r       k^2 = (a + r)/(2 r),  sin(phi) = sin(psi/2)/k,  t = sqrt(2/r)/n F(phi, k)
      turns over, a > r   k^2 = 2 r/(a + r),  phi = psi/2,  t = 2/(n sqrt(a + r)) F(phi, k)

    W = A + B y^2 + C y^4, in y = q or, with dq = 2/n dy/(1 + y^2), W (1 + y^2)^2 in y = tan(psi/2)
      C (y^2 - a^2)(y^2 + b^2)   C < 0 < A:  k^2 = a^2/(a^2 + b^2),  phi = arccos(y/a),
                                 t = -F(phi, k)/sqrt(-C (a^2 + b^2))
      C (a^2 - y^2)(b^2 - y^2)   C, A > 0 > B, a < b:  k = a/b,  phi = arcsin(y/a),  t = F(phi, k)/(b sqrt(C))
      C (y^2 - a^2)(y^2 - b^2)   C, A < 0, b < |y| < a:  k^2 = 1 - b^2/a^2,  sin^2(phi) = (a^2 - y^2)/(a^2 - b^2),
                                 t = -F(phi, k)/(a sqrt(-C))

    W = P(u)/sin^2(psi) in u = cos(psi), with the cubic P of leading coefficient p > 0 and its roots
    u_1 < u_2 <= 1 <= u_3, by which a spherical pendulum and a heavy top nod between u_1 and u_2:
    du = -sin(psi) dpsi, so u'^2 = n^2 P(u),
                                 k^2 = (u_2 - u_1)/(u_3 - u_1),  sin^2(phi) = (u - u_1)/(u_2 - u_1),
                                 t = -2 F(phi, k)/(n sqrt(p (u_3 - u_1)))          (from rest at one of the two)

(up to a constant; the last two for y > 0 and sin(psi) > 0). K and F have the modulus k, not the parameter m = k^2.
Source: Byrd & Friedman, Handbook of Elliptic Integrals, 2nd ed. 1971, 213, 218, 219, 233, 291; Landau & Lifshitz,
Mechanics, 3rd ed. 1976, sec. 11 and 14.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

from freebody.symbolic.functions import atan2, cos_sin, functions
from freebody.symbolic.model import SymbolicModel
from freebody.symbolic.ratio import Ratio
from freebody.symbolic.signs import Sign, sign_of
from freebody.symbolic.unknowns import Coordinate

Need = tuple[Ratio, str]


@dataclass(frozen=True)
class EllipticTime:
    """t(q) = scale F(phi(q), k) up to a constant, growing with q. lowest, highest: where phi is at the two places at
    which it turns, None where it turns over; halves: by how many pi phi grows when q has made a whole turn then."""

    scale: Ratio
    modulus: Ratio
    amplitude: Callable[[Ratio], Ratio]
    lowest: Ratio | None
    highest: Ratio | None
    needs: tuple[Need, ...]
    halves: int | None = None
    integral: Callable[[Ratio, Ratio], Ratio] | None = None

    def told(self, place: Ratio) -> tuple[str, dict[str, Ratio]]:
        """The key of the sentence that tells it, and what stands in it."""
        return "course.elliptic", {"phi": self.amplitude(place), "k": self.modulus, "scale": self.scale}

    def at(self, place: Ratio) -> Ratio:
        return self._of(self.amplitude(place))

    def at_turn(self, way: int) -> Ratio | None:
        """At the place at which it turns, above (way > 0) or below."""
        phi = self.highest if way > 0 else self.lowest
        return None if phi is None else self._of(phi)

    @property
    def period(self) -> Ratio | None:
        """There and back, or once over; None where no whole turn brings it back to where it was."""
        if self.lowest is not None and self.highest is not None:
            return 2 * (self._of(self.highest) - self._of(self.lowest))
        if self.halves is None:
            return None
        assert self.integral is not None
        return 2 * self.halves * self.scale * self.integral(self.scale.field.pi / 2, self.modulus)

    def _of(self, phi: Ratio) -> Ratio:
        assert self.integral is not None
        return self.scale * self.integral(phi, self.modulus)


class _Finder:
    """Of which form a square of the speed is. q0, u0: at the start."""

    def __init__(self, model: SymbolicModel, c: Coordinate, square: Ratio, q0: Ratio, u0: Ratio) -> None:
        self.model, self.c, self.square, self.q0 = model, c, square, q0
        self.starts_at_rest = u0.is_zero()
        self.field = model.field
        self.of = functions(model.field, model.samples.is_negative)
        self.needs: list[Need] = []

    def find(self) -> EllipticTime | None:
        f, index = self.field, self.c.index
        if index in f.ingredients(self.square.denominator()):
            return self._nodding()
        moving = {g for g in self.square.generators() if index in f.ingredients(f.variable(g))}
        if moving == {index}:
            parts = [part / self.square.denominator() for part in self.square.numerator().coefficients(index)]
            even = self._even(parts, self.q0)
            return None if even is None else self._quartic(even, lambda place: place, f.one, self.q0)
        pairs = [pair for pair in f.pairs(moving) if moving <= set(pair)]
        return self._trigonometric(*pairs[0]) if len(pairs) == 1 else None

    # -- signs --------------------------------------------------------------------------------
    def _sign(self, x: Ratio) -> int:
        """Of what depends on parameters: where it is open, as at the first sample that has it, and that is needed."""
        known = sign_of(x)
        if known is Sign.ZERO or x.is_zero():
            return 0
        if known.is_strict:
            return 1 if known is Sign.POSITIVE else -1
        values = (v for v in self.model.samples.at_starts(x) if not math.isnan(v))
        first = next(values, 0.0)
        sign = (first > 0) - (first < 0)
        self.needs.append((sign * x, ">"))
        return sign

    def _root(self, x: Ratio) -> Ratio:
        return self.field.sqrt(self.field.lowest_terms(x), self.model.samples.is_negative)

    def _time(
        self,
        scale: Ratio,
        modulus: Ratio,
        amplitude: Callable[[Ratio], Ratio],
        ends: tuple[Ratio, Ratio] | None,
        halves: int | None = None,
    ) -> EllipticTime:
        lowest, highest = (None, None) if ends is None else ends
        needs, integral = tuple(self.needs), self.of["elliptic_F"]
        return EllipticTime(scale, modulus, amplitude, lowest, highest, needs, halves, integral)

    # -- sines and cosines --------------------------------------------------------------------
    def _trigonometric(self, cos: int, sin: int) -> EllipticTime | None:
        f, index = self.field, self.c.index
        angle = f.angles[cos]
        n = f.lowest_terms(f.derivative(angle, index))
        if not n.is_constant():
            return None
        parts = [part / self.square.denominator() for part in self.square.numerator().coefficients(cos)]
        parts += [f.zero] * (3 - len(parts))
        if len(parts) != 3:
            return None
        sines = f.partial(parts[0], sin)
        constant = f.lowest_terms(parts[0] - sines * f.variable(sin))
        if any(not x.is_constant() for x in (*parts[1:], sines, constant)):
            return None
        if parts[2].is_zero():
            return self._wave(angle, n, constant, parts[1], sines)
        if sines.is_zero():
            return self._in_tangents(angle, n, constant, parts[1], parts[2])
        if parts[1].is_zero():  # counted from a quarter turn on: sin = cos', cos^2 = 1 - cos'^2
            return self._in_tangents(angle - f.pi / 2, n, constant + parts[2], sines, -parts[2])
        return None

    def _nodding(self) -> EllipticTime | None:
        """P(u)/sin^2 with a cubic P in the cosine, from rest at one of its roots."""
        f, index = self.field, self.c.index
        inside = f.pairs({g for g in self.square.generators() if index in f.ingredients(f.variable(g))})
        if len(inside) != 1 or not self.starts_at_rest:
            return None
        cos, sin = inside[0]
        n = f.lowest_terms(f.derivative(f.angles[cos], index))
        whole = f.lowest_terms(self.square * (1 - f.variable(cos) ** 2))
        if not n.is_constant() or {index, cos, sin} & f.ingredients(whole.denominator()):
            return None
        parts = [part / whole.denominator() for part in whole.numerator().coefficients(cos)]
        if len(parts) != 4 or any(index in f.ingredients(part) for part in parts):
            return None
        # in u = way cos, in which the leading coefficient is positive
        way = self._sign(parts[3])
        d, c, b, a = (f.lowest_terms(part * way**k) for k, part in enumerate(parts))
        at = self._placed(f.angles[cos])
        first, sine = cos_sin(f, at(self.q0))
        first, side = f.lowest_terms(way * first), way * self._sign(sine)
        if not side or not (d + first * (c + first * (b + first * a))).is_zero():
            return None
        # the other two roots, of a u^2 + (b + a u_0) u + c + (b + a u_0) u_0
        linear = f.lowest_terms(b + a * first)
        root = self._root(linear * linear - 4 * a * (c + linear * first))
        other, last = (f.lowest_terms((sign * root - linear) / (2 * a)) for sign in (-1, 1))
        order = self._sign(f.lowest_terms(first - other))
        if not order:
            return None
        low, high = (other, first) if order > 0 else (first, other)
        k = self._root((high - low) / (last - low))

        def amplitude(place: Ratio) -> Ratio:
            u = way * cos_sin(f, at(place))[0]
            return self._arc("asin", self._root((u - low) / (high - low)))

        half = f.pi / 2
        ends = (half, f.zero) if side * self._sign(n) > 0 else (f.zero, half)
        return self._time(-side * 2 / (n * self._root(a * (last - low))), k, amplitude, ends)

    def _wave(self, angle: Ratio, n: Ratio, a: Ratio, cosines: Ratio, sines: Ratio) -> EllipticTime | None:
        """a + b cos(angle) + c sin(angle) = a + r cos(psi)."""
        f = self.field
        if sines.is_zero():
            sign = self._sign(cosines)
            if not sign:
                return None
            r, delta = sign * cosines, f.zero if sign > 0 else f.pi
        elif cosines.is_zero():
            sign = self._sign(sines)
            if not sign:
                return None
            r, delta = sign * sines, sign * f.pi / 2
        else:
            r = self._root(cosines * cosines + sines * sines)
            delta = atan2(f, sines, cosines, r)
        psi = self._near(angle - delta)
        if psi is None:
            return None
        at = self._placed(psi)
        k: Ratio | None = None
        if self.starts_at_rest:
            first = at(self.q0)
            sides = {(v > 0) - (v < 0) for v in self.model.samples.at_starts(first)}
            if len(sides) != 1 or 0 in sides:
                return None
            k, kind = sides.pop() * self.of["sin"](first / 2), -1
        else:
            kind = self._sign(f.lowest_terms(a - r))
        if kind < 0:
            k = self._root((a + r) / (2 * r)) if k is None else k
            modulus = k
            half = f.pi / 2

            def swung(place: Ratio) -> Ratio:
                return self._arc("asin", f.lowest_terms(self.of["sin"](at(place) / 2) / modulus))

            scale = self._root(2 / r) / n
            ends = (-half, half) if self._sign(n) > 0 else (half, -half)
            return self._time(scale, modulus, swung, ends)
        if kind > 0:
            over = self._root(a + r)
            turns = n.fraction()
            is_whole = turns is not None and turns.denominator == 1
            halves = int(turns) if turns is not None and is_whole else None
            return self._time(2 / (n * over), self._root(2 * r / (a + r)), lambda p: at(p) / 2, None, halves)
        return None

    def _in_tangents(self, angle: Ratio, n: Ratio, a: Ratio, b: Ratio, c: Ratio) -> EllipticTime | None:
        """a + b cos + c cos^2 in the tangent of half the angle, counted from where it is largest at 0 or pi."""
        f = self.field
        psi = self._near(angle)
        if psi is None:
            return None
        at = self._placed(psi)
        first = at(self.q0)
        if any(abs(v) > math.pi / 2 for v in self.model.samples.at_starts(first)):
            psi = self._near(angle - f.pi)
            if psi is None:
                return None
            at, b = self._placed(psi), -b

        def tangent(place: Ratio) -> Ratio:
            c, s = cos_sin(f, at(place))
            return f.lowest_terms(s / (1 + c))

        if self.starts_at_rest:
            found = self._from_rest(b, c, cos_sin(f, at(self.q0))[0], tangent, 2 / n)
            if found is not None:
                return found
        parts = (a + b + c, 2 * a - 2 * c, a - b + c)
        return self._quartic(parts, tangent, 2 / n, tangent(self.q0))

    def _from_rest(
        self, b: Ratio, c: Ratio, first: Ratio, y: Callable[[Ratio], Ratio], per: Ratio
    ) -> EllipticTime | None:
        """W = (cos(psi) - C)(b + c C + c cos(psi)) with C = cos(psi_0): in y the product of 1 - C - (1 + C) y^2 and
        p + m y^2 with p, m = b + c C +- c, and a^2 = (1 - C)/(1 + C)."""
        f, half = self.field, self.field.pi / 2
        plus, minus = (f.lowest_terms(b + c * first + sign * c) for sign in (1, -1))
        begin = y(self.q0)
        if self._sign(plus) <= 0 or not self._sign(begin):
            return None
        top = self._sign(begin) * begin
        side = self._sign(minus)
        if side > 0:
            square = f.lowest_terms(2 * (b + 2 * c * first))
            k = self._root((1 - first) * minus / square)
            ends = (f.pi, f.zero)
            return self._time(
                -per / self._root(square), k, lambda p: self._arc("acos", f.lowest_terms(y(p) / top)), ends
            )
        if side < 0:
            square = f.lowest_terms((1 + first) * plus)
            k = self._root(-(1 - first) * minus / square)
            if not self._sign(f.lowest_terms(1 - k * k)) > 0:
                return None
            ends = (-half, half)
            return self._time(
                per / self._root(square), k, lambda p: self._arc("asin", f.lowest_terms(y(p) / top)), ends
            )
        return None

    def _near(self, angle: Ratio) -> Ratio | None:
        """An angle without whole turns, so that it is within half a turn of zero at the start; where it is so at some
        samples only, that is needed."""
        f = self.field
        begin = f.lowest_terms(f.follow(angle, {self.c.index: self.q0}))
        turns = [round(v / (2 * math.pi)) for v in self.model.samples.at_starts(begin) if not math.isnan(v)]
        whole = 2 * f.pi * turns[0] if turns else f.zero
        for way in sorted({(n > turns[0]) - (n < turns[0]) for n in turns} - {0}):
            self.needs.append((f.lowest_terms(f.pi - way * (begin - whole)), ">"))
        return angle - whole if turns else None

    def _placed(self, angle: Ratio) -> Callable[[Ratio], Ratio]:
        f = self.field
        return lambda place: f.lowest_terms(f.follow(angle, {self.c.index: place}))

    def _arc(self, name: str, x: Ratio) -> Ratio:
        """An arc, odd in its argument where it is a sine's."""
        leading = next(iter(self.field.terms(x.num).values()), 1)
        if name == "asin" and leading < 0:
            return -self.of["asin"](-x)
        return self.of[name](x)

    # -- even polynomials ---------------------------------------------------------------------
    def _even(self, parts: list[Ratio], q0: Ratio) -> tuple[Ratio, Ratio, Ratio] | None:
        """(A, B, C) of A + B q^2 + C q^4."""
        if len(parts) != 5 or not (parts[1].is_zero() and parts[3].is_zero()):
            return None
        a, b, c = (self.field.lowest_terms(x) for x in parts[::2])
        return (a, b, c) if all(x.is_constant() for x in (a, b, c)) else None

    def _quartic(
        self, parts: tuple[Ratio, Ratio, Ratio], y: Callable[[Ratio], Ratio], per: Ratio, first: Ratio
    ) -> EllipticTime | None:
        """A + B y^2 + C y^4. per: dq by dy/(the square root of that); first: y at the start."""
        f = self.field
        A, B, C = (f.lowest_terms(x) for x in parts)
        sides = tuple(map(self._sign, (A, C)))
        rest = self.starts_at_rest
        if sides == (1, -1):
            if rest:
                root = f.lowest_terms(B + 2 * C * first * first)  # -C (a^2 + b^2) = -(B + 2 C a^2)
                root, largest = -root, self._size(first)
            else:
                root = self._root(B * B - 4 * A * C)
                largest = self._root((B + root) / (-2 * C))
            if largest is None:
                return None
            top = largest
            k = self._root(-C * top * top / root)
            return self._time(
                -per / self._root(root), k, lambda p: self._arc("acos", f.lowest_terms(y(p) / top)), (f.pi, f.zero)
            )
        if sides == (1, 1) and self._sign(B) < 0:
            root = self._root(B * B - 4 * A * C)
            near = self._size(first) if rest else self._root((-B - root) / (2 * C))
            if near is None:
                return None
            far = self._root(A / C) / near
            if not self._sign(f.lowest_terms(far * far - near * near)) > 0:
                return None
            half, inner = f.pi / 2, near
            scale = per * inner / self._root(A)
            k = f.lowest_terms(inner * inner * self._root(C / A))
            return self._time(scale, k, lambda p: self._arc("asin", f.lowest_terms(y(p) / inner)), (-half, half))
        return self._one_side((A, B, C), y, per, first) if sides == (-1, -1) else None

    def _one_side(
        self, parts: tuple[Ratio, Ratio, Ratio], y: Callable[[Ratio], Ratio], per: Ratio, first: Ratio
    ) -> EllipticTime | None:
        """C (y^2 - a^2)(y^2 - b^2) between b and a, where y keeps its sign."""
        f = self.field
        A, B, C = parts
        side = self._sign(first)
        if self.starts_at_rest:
            own = f.lowest_terms(first * first)
            other = f.lowest_terms(A / (C * own))
            order = self._sign(f.lowest_terms(own - other))
            if not order:
                return None
            outer, inner = (own, other) if order > 0 else (other, own)
        else:
            root = self._root(B * B - 4 * A * C)
            outer, inner = (f.lowest_terms(x / (-2 * C)) for x in (B + root, B - root))
        if not side:
            return None
        k = self._root(1 - inner / outer)
        ends = (f.pi / 2, f.zero) if side > 0 else (f.zero, f.pi / 2)

        def amplitude(place: Ratio) -> Ratio:
            return self._arc("asin", self._root((outer - y(place) ** 2) / (outer - inner)))

        return self._time(-side * per / self._root(-C * outer), k, amplitude, ends)

    def _size(self, x: Ratio) -> Ratio | None:
        """|x|, by its sign at the start."""
        sign = self._sign(x)
        return sign * x if sign else None


def elliptic_time(model: SymbolicModel, c: Coordinate, square: Ratio, q0: Ratio, u0: Ratio) -> EllipticTime | None:
    """The time of the way of a coordinate by u^2 = square, where it is an elliptic integral of these forms."""
    with model.samples.taking() as taken:  # signs of what the place that is reached does not depend on
        found = _Finder(model, c, model.field.lowest_terms(square), q0, u0).find()
    return None if found is None else replace(found, needs=(*found.needs, *((x, ">") for x in taken)))
