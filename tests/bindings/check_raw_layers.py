"""The raw layers of Python and Fortran say what vbgpd.h says: constants, struct members, functions, in type and order.

Usage: check_raw_layers.py PROJECT_DIR [--self-test]. With --self-test it changes the header in memory in many ways,
each of which must be noticed: so a function added to the header without its bindings fails. Standard library only.
"""
import ctypes
import importlib.util
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from c_header import Header  # noqa: E402
from fortran_module import Module  # noqa: E402

root = pathlib.Path(sys.argv[1]).resolve()
HEADER = (root / "capi/include/vbgpd/vbgpd.h").read_text(encoding="utf-8")
FORTRAN = Module((root / "bindings/fortran/vbgpd_c.f90").read_text(encoding="utf-8"))
FACES = {"Fortran": "".join(p.read_text(encoding="utf-8") for p in sorted((root / "bindings/fortran").glob("*.f90"))
                            if p.name != "vbgpd_c.f90"),
         "Python": "".join(p.read_text(encoding="utf-8") for p in sorted((root / "bindings/python/vbgpd").glob("*.py"))
                           if p.name != "_raw.py")}


def load_raw():
    """_raw.py alone: neither numpy nor the library is needed to read declarations."""
    spec = importlib.util.spec_from_file_location("vbgpd_raw", root / "bindings/python/vbgpd/_raw.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


PYTHON = load_raw()

# ---- what a C type is called in each language

PYTHON_SCALARS = {"int32_t": ctypes.c_int32, "uint32_t": ctypes.c_uint32, "int64_t": ctypes.c_int64,
                  "uint64_t": ctypes.c_uint64, "double": ctypes.c_double, "vbgpd_status": ctypes.c_int32,
                  "const char*": ctypes.c_char_p, "void*": ctypes.c_void_p, "const void*": ctypes.c_void_p,
                  "char*": ctypes.POINTER(ctypes.c_char), "void": None}
FORTRAN_SCALARS = {"int32_t": "integer(c_int32_t)", "uint32_t": "integer(c_int32_t)", "int64_t": "integer(c_int64_t)",
                   "uint64_t": "integer(c_int64_t)", "double": "real(c_double)", "vbgpd_status": "integer(c_int32_t)"}
# Fortran does not tell capitals apart.
FORTRAN_NAMES = {"VBGPD_VERSION_NUMBER": "VBGPD_HEADER_VERSION_NUMBER", "VBGPD_ABI_VERSION": "VBGPD_HEADER_ABI_VERSION"}


def python_type(header, kind):
    if kind in PYTHON_SCALARS:
        return PYTHON_SCALARS[kind]
    base = kind.replace("const ", "").rstrip("*")
    stars = kind.count("*")
    named = PYTHON_SCALARS.get(base) or getattr(PYTHON, base, None)
    if base in header.handles:
        stars -= 1  # a handle is a pointer type of its own
    for _ in range(stars):
        named = ctypes.POINTER(named)
    return named


def fortran_type(header, function, position):
    kind = function.parameters[position].kind
    base = kind.replace("const ", "").rstrip("*")
    if kind in FORTRAN_SCALARS:
        return FORTRAN_SCALARS[kind] + ", value"
    if base in header.callbacks:
        return "type(c_funptr), value"
    intent = f"intent({'in' if kind.startswith('const') else 'inout'})"
    if base == "char":
        return f"character(kind=c_char), {intent}, optional, dimension(*)"
    if base in header.handles and kind.count("*") == 2:
        return "type(c_ptr), intent(inout)"
    if base in header.handles or base == "void" or header.is_array(function, position):
        return "type(c_ptr), value"
    if base in header.structs:
        required = "" if function.name in header.callbacks else ", optional"
        return f"type({base}), {intent}{required}"
    return FORTRAN_SCALARS[base] + ", intent(inout), optional"


def python_signature(header, function):
    return python_type(header, function.result), tuple(python_type(header, p.kind) for p in function.parameters)


def parameter_name(parameter):
    """A parameter without a name is called by its type in the bindings."""
    return parameter.name or re.sub(r"^(const )?vbgpd_|\*", "", parameter.kind)


# ---- the comparison

def differences(header_text):
    """Every difference between a header and the raw layers, as sentences."""
    header, found = Header(header_text), []

    def expect(what, wanted, seen):
        if wanted != seen:
            found.append(f"{what}: the header has {wanted}, the binding {seen}")

    check_python(header, expect)
    check_fortran(header, expect)
    check_faces(header, expect)
    return found


def check_python(header, expect):
    constants = {n: v for n, v in vars(PYTHON).items() if n.startswith("VBGPD_")}
    expect("Python constants", list(header.constants.items()), list(constants.items()))
    for name in header.handles:
        expect(f"Python handle {name}", True, issubclass(getattr(PYTHON, name, int), ctypes.c_void_p))
    structs = [n for n, v in vars(PYTHON).items()
               if isinstance(v, type) and issubclass(v, ctypes.Structure) and v is not PYTHON.Record]
    expect("Python structs", list(header.structs), structs)
    for name in set(header.structs) & set(structs):
        struct = getattr(PYTHON, name)
        members = [(f.name, python_type(header, f.kind)) for f in header.structs[name]]
        expect(f"Python {name}", members, struct._fields_)
        offsets, size = header.layout(name)
        expect(f"Python size of {name}", size, ctypes.sizeof(struct))
        expect(f"Python offsets of {name}", offsets, {n: getattr(struct, n).offset for n, _ in struct._fields_})
    for name, callback in header.callbacks.items():
        seen = getattr(PYTHON, name)
        expect(f"Python {name}", python_signature(header, callback), (seen._restype_, seen._argtypes_))
    expect("Python functions", list(header.functions), list(PYTHON.FUNCTIONS))
    for name in set(header.functions) & set(PYTHON.FUNCTIONS):
        expect(f"Python {name}", python_signature(header, header.functions[name]), PYTHON.FUNCTIONS[name])


def check_fortran(header, expect):
    wanted = {FORTRAN_NAMES.get(n, n): ("integer(c_int32_t), parameter", v) for n, v in header.constants.items()}
    wanted["VBGPD_STRLEN"] = ("integer(c_int64_t), parameter", header.constants.get("VBGPD_STRLEN"))
    expect("Fortran constants", list(wanted.items()), list(FORTRAN.constants.items()))
    members = {**FORTRAN_SCALARS, **{name: "type(c_funptr)" for name in header.callbacks}}
    expect("Fortran types", list(header.structs), list(FORTRAN.types))
    for name in set(header.structs) & set(FORTRAN.types):
        expect(f"Fortran {name}", [(f.name, members.get(f.kind, "type(c_ptr)")) for f in header.structs[name]],
               [(member, kind) for member, kind, _ in FORTRAN.types[name]])
        expect(f"Fortran size of {name}", str(header.layout(name)[1]), FORTRAN.types[name][0][2])
    functions = {**header.callbacks, **header.functions}
    expect("Fortran functions", list(functions), list(FORTRAN.functions))
    for name in set(functions) & set(FORTRAN.functions):
        function = functions[name]
        parameters = [(parameter_name(p), fortran_type(header, function, i)) for i, p in enumerate(function.parameters)]
        result = None if function.result == "void" else FORTRAN_SCALARS.get(function.result, "type(c_ptr)")
        expect(f"Fortran {name}", (parameters, result), FORTRAN.functions[name])


def check_faces(header, expect):
    """The faces reach every function of an object; Fortran takes the others from the raw module as they are."""
    for name, function in header.functions.items():
        handle = next((h for h in header.handles if any(h in p.kind for p in function.parameters)), None)
        if handle:
            expect(f"Fortran face uses {name}", True, re.search(rf"\b{name}\b", FACES["Fortran"]) is not None)
        # The face of Python calls most functions by the end of their name, as a text.
        end = name.removeprefix(handle) if handle else name
        used = re.search(rf'\b{name}\b|"{end.lstrip("_")}"|{end}"', FACES["Python"])
        expect(f"Python face uses {name}", True, used is not None)


# ---- the check checked

BOTH = {"Python", "Fortran"}
CHANGES = [
    ("a new function", r"(#ifdef __cplusplus\n\}\n)",
     r"VBGPD_API vbgpd_status VBGPD_CALL vbgpd_melt(vbgpd_model*);\n\1", BOTH),
    ("a removed function", r"VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_cancel[^\n]*\n", "", BOTH),
    ("a new constant", r"(#define VBGPD_TYPE_I64 2)", r"\1\n#define VBGPD_TYPE_F32 3", BOTH),
    ("another value", r"#define VBGPD_E_RANGE -11", "#define VBGPD_E_RANGE -12", BOTH),
    ("a new struct", r"(typedef struct vbgpd_level \{)",
     r"typedef struct vbgpd_heat { uint32_t struct_size; int32_t kind; } vbgpd_heat;\n\1", BOTH),
    ("an appended member", r"(double wall_seconds;\n)(\} vbgpd_trial;)", r"\1  double heat;\n\2", BOTH),
    ("members in another order", r"double time, time_step;", "double time_step, time;", BOTH),
    ("a member of another type", r"int64_t plastic_bonds;", "double plastic_bonds;", BOTH),
    ("a narrower member", r"int64_t max_particles;", "int32_t max_particles;", BOTH),
    ("a parameter of another type", r"(vbgpd_model_step\(vbgpd_model\*), int64_t", r"\1, int32_t", BOTH),
    ("parameters in another order", r"int32_t location, int64_t\* n", "int64_t* n, int32_t location", BOTH),
    ("an array for a single value", r"double\* value\);", "double* value, int64_t stride);", BOTH),
    ("another result", r"int32_t VBGPD_CALL vbgpd_abi_version", "int64_t VBGPD_CALL vbgpd_abi_version", BOTH),
    ("another callback", r"\(void\* user, const vbgpd_progress\*\)", "(const vbgpd_progress*, void* user)", BOTH),
    # What a language cannot tell: Python's raw layer has no names of parameters, handles are all c_ptr in Fortran.
    ("renamed parameters", r"double x0, double x1,", "double x1, double x0,", {"Fortran"}),
    ("another handle", r"vbgpd_model_set_f64\(vbgpd_model\*", "vbgpd_model_set_f64(vbgpd_profile* model", {"Python"}),
]


def self_test():
    missed = []
    for what, pattern, replacement, languages in CHANGES:
        changed, times = re.subn(pattern, replacement, HEADER, count=1)
        noticed = {line.split()[0] for line in differences(changed)}
        if times == 0:
            missed.append(f"{what}: the header has nothing like it to change")
        elif not languages <= noticed:
            missed.append(f"{what}: noticed by {sorted(noticed) or 'nobody'}, not by all of {sorted(languages)}")
    return missed


testing = "--self-test" in sys.argv
complaints = self_test() if testing else differences(HEADER)
for complaint in complaints:
    print(complaint)
header = Header(HEADER)
print(f"{len(header.functions)} functions, {len(header.constants)} constants, {len(header.structs)} structs with "
      f"{sum(map(len, header.structs.values()))} members" + (f"; {len(CHANGES)} changes tried" if testing else ""))
sys.exit(1 if complaints else 0)
