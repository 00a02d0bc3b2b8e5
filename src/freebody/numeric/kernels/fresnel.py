"""Fresnel's integrals: C(x) + i S(x) = int_0^x exp(i pi t^2/2) dt.

Near zero by their power series, in z = pi x^2/2:  sum_n (i z)^n/n! x/(2 n + 1); farther by the continued fraction of
the error function, with which C + i S = (1 + i)/2 erf(sqrt(pi) (1 - i) x/2). Source: Press, Teukolsky, Vetterling &
Flannery, Numerical Recipes, 3rd ed. 2007, sec. 6.8.
"""

# pyright: basic

import math

from freebody.numeric.kernels.declaring import leaf

_NEAR = 1.5
_MOST = 200  # terms
_TINY, _CLOSE = 1e-300, 1e-16


@leaf
def fresnel(x, is_of_sine):
    """That of the cosine, or of the sine."""
    size = abs(x)
    if not size < 1e16:  # there it is 1/2 to rounding
        return x if size != size else (0.5 if x > 0.0 else -0.5)
    if size < _NEAR:
        z = 0.5 * math.pi * size * size
        term = size
        c, s = size, 0.0
        for n in range(1, _MOST):
            term *= z / n
            part = term / (2 * n + 1)
            if n & 1:
                s += part if n & 2 == 0 else -part
            else:
                c += part if n & 2 == 0 else -part
            if part < 1e-18 * size:
                break
    else:  # Lentz's method, in steps of two
        square = math.pi * size * size
        b = complex(1.0, -square)
        ahead = complex(1.0 / _TINY, 0.0)
        d = 1.0 / b
        h = d
        n = -1
        for _k in range(_MOST):
            n += 2
            a = -n * (n + 1.0)
            b += 4.0
            d = 1.0 / (a * d + b)
            ahead = b + a / ahead
            factor = ahead * d
            h *= factor
            if abs(factor.real - 1.0) + abs(factor.imag) < _CLOSE:
                break
        h *= complex(size, -size)
        turn = complex(math.cos(0.5 * square), math.sin(0.5 * square))
        found = complex(0.5, 0.5) * (1.0 - turn * h)
        c, s = found.real, found.imag
    value = s if is_of_sine else c
    return value if x > 0.0 else -value
