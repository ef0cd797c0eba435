# SPDX-License-Identifier: GPL-2.0-or-later
"""Expressions of sums and products as trees: parsing, values, derivatives."""

import ast

ARGUMENTS = {"sign": 1, "sqrt": 1, "fma": 3}
ALLOWED = (ast.Name, ast.BinOp, ast.UnaryOp, ast.Add, ast.Sub, ast.Mult, ast.USub, ast.Load)

def parsed(text):
    """An expression of sums and products as a tree; sign(), sqrt() and fma() are calls."""
    tree = ast.parse(" ".join(text.split()), mode="eval").body
    for node in ast.walk(tree):
        is_call = isinstance(node, ast.Call) and ARGUMENTS.get(ast.unparse(node.func)) == len(node.args)
        if not is_call and not isinstance(node, ALLOWED):
            raise ValueError(f"\"{text}\" is no sum or product of names")
    return tree


def names_in(tree):
    return {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}


def is_product(tree):
    return isinstance(tree, ast.BinOp) and isinstance(tree.op, ast.Mult)


def value_of(tree, values, arithmetic):
    if isinstance(tree, ast.Name):
        return values[tree.id]
    if isinstance(tree, ast.UnaryOp):
        return -value_of(tree.operand, values, arithmetic)
    if isinstance(tree, ast.Call) and tree.func.id == "fma":
        return arithmetic.fused(*(value_of(each, values, arithmetic) for each in tree.args))
    if isinstance(tree, ast.Call):
        x = value_of(tree.args[0], values, arithmetic)
        return (x > 0) - (x < 0)
    if arithmetic.fused_in_sums and isinstance(tree.op, ast.Add) and is_product(tree.left):
        factors = (value_of(each, values, arithmetic) for each in (tree.left.left, tree.left.right, tree.right))
        return arithmetic.fused(*factors)
    a, b = value_of(tree.left, values, arithmetic), value_of(tree.right, values, arithmetic)
    is_sum, is_difference = isinstance(tree.op, ast.Add), isinstance(tree.op, ast.Sub)
    return arithmetic.each(a + b if is_sum else a - b if is_difference else a * b)


def backwards(tree, derivative, values, by, arithmetic):
    if isinstance(tree, ast.Name):
        by[tree.id] = arithmetic.each(by.get(tree.id, 0) + derivative)
    elif isinstance(tree, ast.UnaryOp):
        backwards(tree.operand, -derivative, values, by, arithmetic)
    elif isinstance(tree.op, ast.Mult):
        a, b = value_of(tree.left, values, arithmetic), value_of(tree.right, values, arithmetic)
        backwards(tree.left, derivative * b, values, by, arithmetic)
        backwards(tree.right, derivative * a, values, by, arithmetic)
    else:
        backwards(tree.left, derivative, values, by, arithmetic)
        backwards(tree.right, derivative if isinstance(tree.op, ast.Add) else -derivative, values, by, arithmetic)


def summands(tree):
    parts = []
    while isinstance(tree, ast.BinOp) and isinstance(tree.op, ast.Add):
        parts.append(tree.right)
        tree = tree.left
    return [tree] + parts[::-1]
