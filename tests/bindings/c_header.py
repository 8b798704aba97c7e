"""Reads vbgpd.h: its constants, structs (with layout), handles, callback types and functions. Standard library only."""
import re
from dataclasses import dataclass

SCALARS = {"int32_t": 4, "uint32_t": 4, "int64_t": 8, "uint64_t": 8, "double": 8}
POINTER_SIZE = 8


@dataclass(frozen=True)
class Field:
    """A member of a struct or a parameter of a function; kind is the C type without blanks around its stars."""

    name: str
    kind: str


@dataclass(frozen=True)
class Function:
    name: str
    result: str
    parameters: tuple


class HeaderError(Exception):
    """The header holds something this reader would otherwise pass over in silence."""


def _without_comments(text):
    return re.sub(r"/\*.*?\*/", " ", text, flags=re.S)


DECLARATION = re.compile(r"((?:const )?\w+)\s*(\**)\s*(\w*)")


def _declaration(text):
    """'const double* xy' as its name and kind; a parameter may be without a name."""
    match = DECLARATION.fullmatch(" ".join(text.split()))
    if not match:
        raise HeaderError(f"declaration not understood: {text.strip()}")
    base, stars, name = match.groups()
    return Field(name, base + stars)


def _members(body):
    """'double x, y;' and 'const char *name, *unit;' declare several members at once."""
    for declaration in filter(None, (d.strip() for d in body.split(";"))):
        first, *others = declaration.split(",")
        base = DECLARATION.fullmatch(" ".join(first.split()))[1]
        yield _declaration(first)
        yield from (_declaration(f"{base} {other}") for other in others)


class Header:
    """The declarations of vbgpd.h by name, in order."""

    def __init__(self, text):
        code = _without_comments(text)
        self.constants = {}
        for name, value in re.findall(r"^#define (VBGPD_\w+) (.+)$", code, flags=re.M):
            value = value.strip()
            number = re.fullmatch(r"(?:\(\(int64_t\))?(-?\d+)\)?", value)
            if number:
                self.constants[name] = int(number[1])
            elif name not in {"VBGPD_CALL", "VBGPD_API"}:
                raise HeaderError(f"the value of {name} is not a whole number: {value}")
        self.handles = [a for a, b in re.findall(r"typedef struct (\w+) (\w+);", code)]
        self.structs = {name: list(_members(body)) for name, body in
                        re.findall(r"typedef struct (\w+) \{(.*?)\} \1;", code, flags=re.S)}
        self.callbacks = {name: Function(name, result, self._parameters(inner)) for result, name, inner in
                          re.findall(r"typedef (\w+\**)\(VBGPD_CALL\* (\w+)\)\((.*?)\);", code, flags=re.S)}
        self.functions = {name: Function(name, result, self._parameters(inner)) for result, name, inner in
                          re.findall(r"VBGPD_API ([^;(]*?) VBGPD_CALL (\w+)\((.*?)\);", code, flags=re.S)}
        self._expect("typedefs", len(re.findall(r"^typedef ", code, flags=re.M)),
                     len(self.handles) + len(self.structs) + len(self.callbacks) + 1)  # 1: vbgpd_status
        declared = re.findall(r"^\s*VBGPD_API\b", code, flags=re.M)
        self._expect("functions", len(declared), len(self.functions))

    @staticmethod
    def _expect(what, seen, read):
        if seen != read:
            raise HeaderError(f"the header declares {seen} {what}, but only {read} were understood")

    @staticmethod
    def _parameters(inner):
        return () if inner.strip() == "void" else tuple(_declaration(p) for p in inner.split(","))

    def layout(self, struct):
        """Offsets of the members and the size of a struct under natural alignment."""
        offsets, at, widest = {}, 0, 1
        for field in self.structs[struct]:
            pointer = field.kind.endswith("*") or field.kind in self.callbacks
            size = POINTER_SIZE if pointer else SCALARS[field.kind]
            at = -(-at // size) * size
            offsets[field.name] = at
            at += size
            widest = max(widest, size)
        return offsets, -(-at // widest) * widest

    def is_array(self, function, position):
        """A pointer followed by a stride is an array; without one it receives a single value."""
        after = function.parameters[position + 1:position + 2]
        return bool(after) and after[0].name.startswith("stride")
