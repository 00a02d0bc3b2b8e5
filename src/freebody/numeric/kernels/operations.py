"""The operations of programs (`engine.programs`), which enclosures evaluate."""

# operations; functions of one number are those of `FUNCTIONS`, in this order
CONSTANT, TIME, INPUT, ADD, SUBTRACT, MULTIPLY, DIVIDE, POWER, ARGUMENT = range(9)
SQRT, SIN, COS, TAN, ASIN, ACOS, ATAN, EXP, LOG, SINH, COSH, TANH, ABS, SIGN = range(9, 23)
FRESNEL_C, FRESNEL_S = 23, 24
FUNCTIONS = (
    *("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "log", "sinh", "cosh", "tanh", "abs", "sign"),
    *("fresnel_c", "fresnel_s"),
)
