#!/usr/bin/env python3
"""Derives the L-systems of counts.json and compares them with the numbers there.

A short L-system engine, independent of tractus: one-letter modules with parameters, rules in their
order, conditions, contexts of one module, and a count of what a turtle draws. Run it without
arguments to check counts.json (exit status 1 on a difference), with the names of systems to check
those, or with --write to compute the missing "after_n_steps" of systems that have a list "steps".

Rules are written left < predecessor > right : condition -> successor. A symbol that is "ignored"
is skipped in the search for contexts; where "considered" is given, all others are skipped. $ is
cpfg's @v; ~X is a module X that the turtle shows as an organ. "closed_forms" are formulas in n for
symbols, "modules", "segments" and "polygons". Parameters are kept as 32-bit numbers, as in cpfg.
"""
import hashlib
import json
import pathlib
import re
import struct
import sys


def narrow(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def split_arguments(text):
    parts, depth, start = [], 0, 0
    for i, c in enumerate(text):
        depth += (c == "(") - (c == ")")
        if c == "," and depth == 0:
            parts.append(text[start:i])
            start = i + 1
    return parts + [text[start:]]


def modules_of(text):
    """A list of (symbol, [expressions])."""
    found, i = [], 0
    while i < len(text):
        symbol, i = text[i], i + 1
        if symbol.isspace():
            continue
        arguments = []
        if i < len(text) and text[i] == "(":
            depth, end = 1, i + 1
            while depth:
                depth += (text[end] == "(") - (text[end] == ")")
                end += 1
            arguments = split_arguments(text[i + 1 : end - 1])
            i = end
        found.append((symbol, arguments))
    return found


def compiled(expression):
    text = expression.replace("&&", " and ").replace("||", " or ").replace("^", "**")
    return compile(re.sub(r"!(?!=)", " not ", text).strip(), expression, "eval")


class Rule:
    def __init__(self, text):
        head, successor = text.split("->", 1)
        head, _, condition = head.partition(" : ")
        left, _, head = head.rpartition("<")
        head, _, right = head.partition(">")
        one = lambda part: modules_of(part)[0] if part.strip() else None
        self.left, self.strict, self.right = one(left), one(head), one(right)
        self.condition = None if condition.strip() in ("", "*") else compiled(condition)
        self.successor = [(s, [compiled(e) for e in a]) for s, a in modules_of(successor)]

    def bound(self, left, module, right, constants):
        """The values of the rule's parameters, or None where the rule does not apply."""
        values = dict(constants)
        for wanted, found in ((self.left, left), (self.strict, module), (self.right, right)):
            if wanted is None:
                continue
            if not found or found[0] != wanted[0] or len(found[1]) != len(wanted[1]):
                return None
            values.update(zip((name.strip() for name in wanted[1]), found[1]))
        if self.condition is not None and not eval(self.condition, {}, values):
            return None
        return values


def contexts(string, skipped):
    """For each module, the modules that are its left and right context, or None."""
    left, before, stack = [], None, []
    for module in string:
        left.append(before)
        if module[0] == "[":
            stack.append(before)
        elif module[0] == "]":
            before = stack.pop()
        elif not skipped(module[0]):
            before = module
    right, after, stack = [], None, []
    for module in reversed(string):
        right.append(after)
        if module[0] == "]":
            stack.append(after)
            after = None
        elif module[0] == "[":
            after = stack.pop()
        elif not skipped(module[0]):
            after = module
    return left, right[::-1]


def derive(system, steps):
    constants = system.get("constants") or {}
    ignored, considered = system.get("ignore") or "", system.get("consider") or ""
    skipped = lambda symbol: symbol not in considered if considered else symbol in ignored
    by_symbol = {}
    for text in system["rules"]:
        rule = Rule(text)
        by_symbol.setdefault(rule.strict[0], []).append(rule)
    string = [(s, [narrow(eval(e, {}, dict(constants))) for e in a])
              for s, a in modules_of(system["axiom"])]
    for _ in range(steps):
        left, right = contexts(string, skipped)
        after = []
        for i, module in enumerate(string):
            for rule in by_symbol.get(module[0], ()):
                values = rule.bound(left[i], module, right[i], constants)
                if values is not None:
                    after.extend((s, [narrow(eval(e, {}, values)) for e in a])
                                 for s, a in rule.successor)
                    break
            else:
                after.append(module)
        string = after
    return string


def measure(string, draws):
    """Counts of the symbols and of what the turtle draws; letters in `draws` are drawn as F.

    Within { }, the symbols . f and F set vertices; polygons of less than three are not drawn.
    """
    counts, segments, polygons, vertices, organ = {}, 0, 0, [], ""
    for symbol, arguments in string:
        if symbol == "~":
            organ = "~"
            continue
        counts[organ + symbol] = counts.get(organ + symbol, 0) + 1
        if symbol == "{":
            vertices.append(0)
        elif symbol == "}":
            polygons += vertices.pop() > 2
        elif vertices:
            vertices[-1] += symbol in ".fF"
        elif not organ and symbol in "FG" + draws:
            segments += not arguments or arguments[0] != 0
        organ = ""
    return {"modules": sum(counts.values()), "counts": dict(sorted(counts.items())),
            "segments": segments, "polygons": polygons}


def text_of(string):
    return "".join(s + ("(" + ",".join(f"{x:g}" for x in a) + ")" if a else "") for s, a in string)


def fibonacci(n):
    a, b = 0, 1
    for _ in range(n):
        a, b = b, a + b
    return a


def rabbits(n, delays):
    """How many there are after n steps where each lives on as one after each of the delays."""
    return 1 if n <= 0 else sum(rabbits(n - delay, delays) for delay in delays)


def expected_of(system, steps):
    string = derive(system, steps)
    result = measure(string, system.get("draws", ""))
    text = text_of(string)
    if any(arguments for _, arguments in string):
        if len(text) <= 300:
            result["string"] = text
        lengths = [a[0] for s, a in string if s == "F" and a]
        if lengths and len(lengths) == result["counts"]["F"]:
            result["sum_F_length"] = float(f"{sum(lengths):.9g}")
    else:
        result["sha256"] = hashlib.sha256(text.encode()).hexdigest()
    return result


def differences(system):
    """Sentences about numbers that are not as counts.json has them."""
    for steps, listed in system["after_n_steps"].items():
        where = f"{system['id']} after {steps}"
        found = expected_of(system, int(steps))
        for key in ("modules", "counts", "segments", "polygons", "sha256"):
            if key in listed and found.get(key) != listed[key]:
                yield f"{where}: {key} is {found.get(key)}, listed {listed[key]}"
        names = {"n": int(steps), "fibonacci": fibonacci, "rabbits": rabbits, "min": min, "max": max, "sum": sum,
                 "range": range}
        for symbol, formula in (system.get("closed_forms") or {}).items():
            value = eval(formula, names)
            counted = found[symbol] if symbol in found else found["counts"].get(symbol, 0)
            if value != counted:
                yield f"{where}: {symbol} is {counted}, by {formula} {value}"


def main():
    path = pathlib.Path(__file__).with_name("counts.json")
    listed = json.loads(path.read_text())
    if sys.argv[1:2] == ["--write"]:
        for system in listed["systems"]:
            if "steps" in system and not system.get("after_n_steps"):
                system["after_n_steps"] = {str(n): expected_of(system, n) for n in system["steps"]}
        path.write_text(json.dumps(listed, indent=0) + "\n")
        return 0
    names = sys.argv[1:]
    found = [text for system in listed["systems"] if not names or system["id"] in names
             for text in differences(system)]
    print("\n".join(found) or f"{len(listed['systems'])} systems are as listed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
