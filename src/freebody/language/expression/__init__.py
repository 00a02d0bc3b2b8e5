"""Immutable expression trees: the one form in which freebody keeps the user's mathematics.

tree         the nodes, and how they are put together
inspection   the names in a tree, its depth and length
calculus     substitution and derivatives
evaluation   values in any arithmetic
"""

from __future__ import annotations

from freebody.language.expression.calculus import differentiate, substitute
from freebody.language.expression.evaluation import FLOAT_FUNCTIONS, evaluate, rate_key, value_of_given
from freebody.language.expression.inspection import (
    depth,
    domain,
    free_symbols,
    has_jump,
    in_one_order,
    n_operations,
    stands_in,
)
from freebody.language.expression.rates import replace_rates
from freebody.language.expression.tree import (
    ELEMENTARY,
    ELLIPTIC,
    FRESNEL,
    FUNCTIONS,
    LAMBERT,
    MAX_EXPONENT,
    MINUS_ONE,
    ONE,
    PI,
    PLACE,
    ZERO,
    Call,
    Expr,
    GivenCall,
    Number,
    Operand,
    PowerOf,
    ProductOf,
    Sum,
    Symbol,
    VectorSymbol,
    add,
    children,
    divide,
    multiply,
    name_problem,
    negate,
    number,
    power,
    symbol,
    whole_exponent,
)

__all__ = [
    "ELEMENTARY",
    "ELLIPTIC",
    "FLOAT_FUNCTIONS",
    "FRESNEL",
    "FUNCTIONS",
    "LAMBERT",
    "MAX_EXPONENT",
    "MINUS_ONE",
    "ONE",
    "PI",
    "PLACE",
    "ZERO",
    "Call",
    "Expr",
    "GivenCall",
    "Number",
    "Operand",
    "PowerOf",
    "ProductOf",
    "Sum",
    "Symbol",
    "VectorSymbol",
    "add",
    "children",
    "depth",
    "differentiate",
    "divide",
    "domain",
    "evaluate",
    "free_symbols",
    "has_jump",
    "in_one_order",
    "multiply",
    "n_operations",
    "name_problem",
    "negate",
    "number",
    "power",
    "rate_key",
    "replace_rates",
    "stands_in",
    "substitute",
    "symbol",
    "value_of_given",
    "whole_exponent",
]
