"""Reads the declarations of vbgpd_c.f90: parameters, bind(C) types and interfaces. Standard library only."""
import re


class FortranError(Exception):
    """The module holds something this reader would otherwise pass over in silence."""


def _statements(text):
    lines = (re.sub(r"!.*", "", line).strip() for line in text.splitlines())
    joined = re.sub(r"&\s*\n\s*", " ", "\n".join(lines))
    return [" ".join(line.split()) for line in joined.splitlines() if line.strip()]


def _declaration(statement):
    """'integer(c_int64_t), value :: stride' as ('stride', 'integer(c_int64_t), value')."""
    match = re.fullmatch(r"(.+?) :: (\w+(?:\(\*\))?)(?: = (.+))?", statement)
    if not match:
        raise FortranError(f"declaration not understood: {statement}")
    kind, name, value = match.groups()
    if name.endswith("(*)"):
        kind, name = kind + ", dimension(*)", name[:-3]
    return name, kind, value


class Module:
    """What is declared, by name.

    constants: name -> (kind, value); types: name -> [(member, kind, value)];
    functions: name -> ([(dummy, kind)], result)
    """

    def __init__(self, text):
        self.constants, self.types, self.functions = {}, {}, {}
        statements = iter(_statements(text))
        for statement in statements:
            if ", parameter ::" in statement:
                name, kind, value = _declaration(statement)
                self.constants[name] = (kind, int(re.sub(r"_c_int64_t$", "", value)))
            elif match := re.fullmatch(r"type, bind\(C\) :: (\w+)", statement):
                self.types[match[1]] = [_declaration(s) for s in self._until(statements, f"end type {match[1]}")]
            elif match := re.fullmatch(r"function (\w+)\((.*?)\) result\(outcome\) bind\(C\)", statement):
                self.functions[match[1]] = self._function(match[1], match[2], statements)
            elif match := re.fullmatch(r"subroutine (\w+)\((.*?)\) bind\(C\)", statement):
                self.functions[match[1]] = self._function(match[1], match[2], statements, "subroutine")
            elif re.search(r"\b(function|subroutine|type)\b", statement) and not statement.startswith("end"):
                raise FortranError(f"statement not understood: {statement}")

    @staticmethod
    def _until(statements, end):
        for statement in statements:
            if statement == end:
                return
            yield statement
        raise FortranError(f"'{end}' is missing")

    def _function(self, name, dummies, statements, kind="function"):
        body = [s for s in self._until(statements, f"end {kind} {name}") if s != "import"]
        declared = {n: kind for n, kind, _ in map(_declaration, body)}
        order = [d.strip() for d in dummies.split(",") if d.strip()]
        if set(order) | ({"outcome"} if kind == "function" else set()) != set(declared):
            raise FortranError(f"{name}: the arguments {order} are declared as {sorted(declared)}")
        return [(dummy, declared[dummy]) for dummy in order], declared.get("outcome")
