"""The binary interface only grows: vbgpd.h against capi/abi.txt, the table of what was promised.

Usage: check_abi.py PROJECT_DIR            every line of the table holds, and nothing of the header is missing in it
       check_abi.py PROJECT_DIR --append   appends what is new to the table; refuses when a promise is broken
       check_abi.py PROJECT_DIR --asserts  prints a C file that does not compile where a compiler lays structs out otherwise
Standard library only.
"""
import pathlib
import sys

sys.dont_write_bytecode = True
root = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(root / "tests/bindings"))
from c_header import Header  # noqa: E402

TABLE = root / "capi/abi.txt"


def lines_of(header):
    """One line per constant, struct member and function; struct members with their offsets, but not the size of a
    struct, which grows."""
    for name, value in header.constants.items():
        if name != "VBGPD_VERSION_NUMBER":
            yield f"constant {name} {value}"
    for name, members in header.structs.items():
        offsets, _ = header.layout(name)
        for member in members:
            yield f"member {name}.{member.name} {member.kind} at {offsets[member.name]}"
    for group in (header.callbacks, header.functions):
        for function in group.values():
            yield f"function {function.result} {function.name}({', '.join(p.kind for p in function.parameters)})"


def inserted(header, promised):
    """Members that stand before promised ones: they moved what older callers compiled in."""
    for name, members in header.structs.items():
        lines = [line for line in promised if line.startswith(f"member {name}.")]
        now = [line for line in lines_of(header) if line.startswith(f"member {name}.")]
        if now[:len(lines)] != lines:
            yield f"{name}: members are only ever appended"


def asserts(header):
    print("/* written by check_abi.py */\n#include <stddef.h>\n#include <vbgpd/vbgpd.h>")
    for name in header.structs:
        offsets, size = header.layout(name)
        for member, offset in offsets.items():
            print(f"typedef char {name}_{member}[offsetof({name}, {member}) == {offset} ? 1 : -1];")
        print(f"typedef char {name}_size[sizeof({name}) == {size} ? 1 : -1];")
    print("int main(void) { return 0; }")


def main():
    header = Header((root / "capi/include/vbgpd/vbgpd.h").read_text(encoding="utf-8"))
    if "--asserts" in sys.argv:
        return asserts(header)
    promised = TABLE.read_text(encoding="utf-8").splitlines() if TABLE.exists() else []
    now = list(lines_of(header))
    broken = [f"gone or changed: {line}" for line in promised if line not in now] + list(inserted(header, promised))
    new = [line for line in now if line not in promised]
    if "--append" in sys.argv and not broken:
        with TABLE.open("a", encoding="utf-8") as table:
            table.writelines(line + "\n" for line in new)
        new = []
    for line in broken:
        print(line)
    for line in new:
        print(f"not in the table yet: {line} (tests/capi/check_abi.py {root.name} --append)")
    print(f"{len(promised)} promises, {len(broken)} broken, {len(new)} to be made")
    sys.exit(1 if broken or new else 0)


main()
