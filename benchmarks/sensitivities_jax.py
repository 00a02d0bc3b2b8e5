"""The models of `sensitivities.py` by hand in JAX, with derivatives forward through diffrax's solver of order 8.

    python sensitivities_jax.py NAME          (needs `pip install jax diffrax`)

Prints the derivatives of the final value, seconds of the processor when compiled (the least of five), and what
compiling took.
"""

# pyright: basic

import json
import sys
import time

import diffrax
import jax
import jax.numpy as jnp

jax.config.update("jax_enable_x64", True)


def solved(rhs, y0, until, args):
    found = diffrax.diffeqsolve(
        diffrax.ODETerm(rhs),
        diffrax.Dopri8(),
        t0=0.0,
        t1=until,
        dt0=None,
        y0=y0,
        args=args,
        stepsize_controller=diffrax.PIDController(rtol=1e-10, atol=1e-10),
        adjoint=diffrax.ForwardMode(),
        max_steps=100_000,
    )
    return found.ys[-1]


def double_pendulum(p):
    """Two rods, by their angles against the horizontal: M(a, b) (a'', b'') = what gravity and the rates give."""

    def rhs(_t, y, p):
        m1, m2, l1, l2, g = p
        a, b, u, w = y
        c, s = jnp.cos(a - b), jnp.sin(a - b)
        M = jnp.array([[(m1 / 3 + m2) * l1 * l1, m2 * l1 * l2 * c / 2], [m2 * l1 * l2 * c / 2, m2 * l2 * l2 / 3]])
        f = jnp.array(
            [
                -m2 * l1 * l2 * s * w * w / 2 - (m1 / 2 + m2) * g * l1 * jnp.cos(a),
                m2 * l1 * l2 * s * u * u / 2 - m2 * g * l2 * jnp.cos(b) / 2,
            ]
        )
        return jnp.concatenate((y[2:], jnp.linalg.solve(M, f)))

    return solved(rhs, jnp.array([0.3, -0.5, 0.0, 1.0]), 2.0, p)[1]


def four_bar(p):
    """By the angle of the crank alone: the others from the loop, I(q) q'' + I'(q) q'^2/2 = T."""

    def rates(q, p):
        """Kinetic energy of a unit crank speed, doubled; the loop is closed in closed form."""
        a, b, c, d, _T = p

        def angles(q):
            x, y = d - a * jnp.cos(q), -a * jnp.sin(q)
            r = jnp.sqrt(x * x + y * y)
            turn = jnp.arccos((b * b + r * r - c * c) / (2 * b * r))
            coupler = jnp.arctan2(y, x) + turn
            bx, by = a * jnp.cos(q) + b * jnp.cos(coupler), a * jnp.sin(q) + b * jnp.sin(coupler)
            return jnp.array([coupler, jnp.arctan2(by, bx - d)])

        k, o = jax.jvp(angles, (q,), (1.0,))[1]
        coupler = angles(q)[0]
        vx = -a * jnp.sin(q) - b / 2 * jnp.sin(coupler) * k
        vy = a * jnp.cos(q) + b / 2 * jnp.cos(coupler) * k
        return a * a / 3 + vx * vx + vy * vy + b * b * k * k / 12 + c * c * o * o / 3

    def rhs(_t, y, p):
        inertia, slope = jax.value_and_grad(rates)(y[0], p)
        return jnp.array([y[1], (p[4] - slope * y[1] ** 2 / 2) / inertia])

    return solved(rhs, jnp.array([0.8, 5.0]), 1.0, p)[0]


MODELS = {
    "double pendulum": (double_pendulum, [1.0, 2.0, 1.0, 0.7, 9.81]),
    "four-bar": (four_bar, [0.1, 0.3, 0.25, 0.35, 0.02]),
}

if __name__ == "__main__":
    if sys.argv[1] not in MODELS:
        sys.exit(1)
    model, at = MODELS[sys.argv[1]]
    derivative = jax.jit(jax.jacfwd(model))
    began = time.process_time()
    found = derivative(jnp.array(at)).block_until_ready()
    first = time.process_time() - began
    times = []
    for _ in range(5):
        began = time.process_time()
        found = derivative(jnp.array(at)).block_until_ready()
        times.append(time.process_time() - began)
    print(json.dumps({"derivatives": found.tolist(), "seconds": min(times), "compiled": first - min(times)}))
