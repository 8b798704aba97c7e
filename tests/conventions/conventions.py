#!/usr/bin/env python3
"""The rules of the house, checked on the source text: folders, who may include whom, where libraries may appear, names, sizes.

Usage: conventions.py PROJECT_DIR. Standard library only. Prints every breach and exits 1, or a summary and exits 0.
"""
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(sys.argv[1]).resolve()
breaches = []


def breach(path, text):
    breaches.append(f"{path.relative_to(root) if path != root else '.'}: {text}")


tracked = subprocess.run(["git", "-C", str(root), "ls-files"], capture_output=True, text=True)
if tracked.returncode == 0 and tracked.stdout:
    files = [root / line for line in tracked.stdout.splitlines() if (root / line).is_file()]
else:  # a source archive without git
    files = [p for p in root.rglob("*") if p.is_file() and "build" not in p.relative_to(root).parts[0]]

# 1. top level
FOLDERS = {"core", "capi", "bindings", "samples", "tests"}
BESIDE = {"CMakeLists.txt", "README.md", "LICENSE", "CMakePresets.json"}
for name in sorted({p.relative_to(root).parts[0] for p in files}):
    if name not in FOLDERS | BESIDE and not name.startswith("."):
        breach(root / name, "only CMakeLists.txt, core, capi, bindings, samples, tests and repository files belong at the top")

# 2. who may include whom inside core; every folder may include itself
MAY = {
    "base": set(),
    "smoothing": {"base"},
    "material": {"base"},
    "bond": {"base"},
    "boundary": {"base"},
    "scene": {"base", "smoothing", "material", "bond"},
    "geometry": {"base", "scene"},
    "exchange": {"base", "scene"},
    "state": {"base", "scene", "geometry", "smoothing", "material", "bond", "boundary"},
    "step": {"base", "material", "state"},
    "simulation": {"base", "scene", "geometry", "smoothing", "material", "bond", "boundary", "state", "step"},
    "analysis": {"base", "scene", "geometry", "simulation"},
}
CODE = {".h", ".hpp", ".cpp", ".c"}
include = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
for path in files:
    if path.suffix not in CODE:
        continue
    parts = path.relative_to(root).parts
    text = path.read_text(encoding="utf-8")
    includes = include.findall(text)
    if parts[0] == "core" and len(parts) > 2:
        folder = parts[1]
        for kind, name in includes:
            target = name.split("/")[0]
            if kind == '"' and target in MAY and target != folder and target not in MAY[folder]:
                breach(path, f'core/{folder} must not include "{name}"')
            if kind == '"' and target == "vbgpd":
                breach(path, "core must not include the C face")
    for kind, name in includes:
        if name.startswith("CGAL/") and parts[:2] != ("core", "geometry"):
            breach(path, "CGAL lives in core/geometry only")
        if name.startswith("flatbuffers/") and parts[:2] != ("core", "exchange") and parts[0] != "tests":
            breach(path, "flatbuffers lives in core/exchange only")
        if parts[0] in {"samples", "bindings"} and kind == '"' and name.split("/")[0] in MAY and name != "exchange/scene_text.h":
            breach(path, f'samples and bindings go through vbgpd.h, not "{name}"')
    if parts[0] in {"core", "capi"}:
        if re.search(r"std::c(out|err)\b|\b(f?printf|puts|exit|abort|getenv|setlocale)\s*\(", text):
            breach(path, "the library never prints, exits or reads the environment")
        if re.search(r"^\s*using namespace", text, re.M) and path.suffix == ".h":
            breach(path, "no using namespace in a header")

# 3. CGAL in sources only
for path in files:
    if path.suffix == ".h" and path.relative_to(root).parts[0] == "core" and "CGAL" in path.read_text(encoding="utf-8"):
        if re.search(r"CGAL::|#\s*include\s*<CGAL", path.read_text(encoding="utf-8")):
            breach(path, "no CGAL type in a header")

# 4. instances of the step: choices add, they never multiply
BUDGET = 8  # bond laws x ledger, per instruction set
kernels = root / "core/step/kernels_isa.cpp"
instances = len(re.findall(r"&step<", kernels.read_text(encoding="utf-8")))
if instances > BUDGET:
    breach(kernels, f"{instances} instances of the step; the written budget is {BUDGET}")

# 5. one idea per file: long files are reported, not failed; endless ones fail
long_files = []
for path in files:
    if path.suffix in CODE and path.relative_to(root).parts[0] in {"core", "capi", "samples"}:
        lines = len(path.read_text(encoding="utf-8").splitlines())
        # the public header is the whole manual in one place, one declaration per line: it may be longer
        if lines > (600 if path.name == "vbgpd.h" else 500):
            breach(path, f"{lines} lines: is that one idea?")
        elif lines > 300:
            long_files.append(f"{path.relative_to(root)} ({lines})")

# 6. every soil law and kernel is in the typed tests (they run over the variants themselves)
for listed, test, variant in [("core/material/any_law.h", "tests/unit/material", "AnyLaw"),
                              ("core/smoothing/any_kernel.h", "tests/unit/smoothing", "AnyKernel")]:
    texts = "".join(p.read_text(encoding="utf-8") for p in (root / test).rglob("*_test.cpp")) if (root / test).exists() else ""
    if variant not in texts:
        breach(root / test, f"the tests must run over {variant} of {listed}")

# 7. test names are sentences
name_pattern = re.compile(r"^\s*(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)", re.M)
tests = 0
for path in files:
    if path.name.endswith("_test.cpp"):
        for suite, name in name_pattern.findall(path.read_text(encoding="utf-8")):
            tests += 1
            if not re.match(r"[A-Z]", name) or len(re.findall(r"[A-Z][a-z0-9]*", name)) < 2:
                breach(path, f"TEST({suite}, {name}) does not read as a sentence")

# 8. unfinished work and private places
for path in files:
    parts = path.relative_to(root).parts
    if path.suffix in CODE | {".py", ".cmake", ".f90", ".json", ".md", ".sh", ".txt", ".fbs"} and parts != ("tests", "conventions", "conventions.py"):
        text = path.read_text(encoding="utf-8", errors="replace")
        for word in ("TODO", "FIXME", "/home/", "/root/"):
            if word in text:
                breach(path, f"contains '{word}'")

for line in breaches:
    print(line)
print(f"{len(files)} files, {tests} tests, {instances} step instances; longest: {', '.join(long_files) or 'none over 300 lines'}")
sys.exit(1 if breaches else 0)
