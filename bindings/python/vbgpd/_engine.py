"""The loaded library, and what the objects share: failures, texts, points, tables."""
import ctypes
import difflib
import enum
import math
import operator
import os
from collections import namedtuple

import numpy

from . import _raw


def _members(prefix):
    return {name[len(prefix):]: value for name, value in vars(_raw).items() if name.startswith(prefix)}


_OUTCOMES = ("OK", "CANCELLED", "LIMIT_REACHED", "NOT_CONVERGED", "UNSTABLE", "END_OF_DATA")
Status = enum.IntEnum("Status", {name: value for name, value in _members("VBGPD_").items()
                                 if name in _OUTCOMES or name.startswith("E_")})
Status.__doc__ = "How a call ended: 0 done, > 0 a named outcome, < 0 a failure (raised as Error)."
Kind = enum.IntEnum("Kind", _members("VBGPD_OBJECT_"))
Kind.__doc__ = "What a named number, an issue or an error belongs to."
Boundary = enum.IntEnum("Boundary", _members("VBGPD_BOUNDARY_"))
Boundary.__doc__ = "How a held part of the outline is held."
Verdict = enum.IntEnum("Verdict", _members("VBGPD_VERDICT_"))
Verdict.__doc__ = "What a trial showed."
Event = enum.IntEnum("Event", _members("VBGPD_EVENT_"))
Event.__doc__ = "What happened to a model."
LogLevel = enum.IntEnum("LogLevel", _members("VBGPD_LOG_"))
LogLevel.__doc__ = "How much a line of the log matters."
Location = enum.IntEnum("Location", _members("VBGPD_AT_"))
Location.__doc__ = "Where a field lives."

Property = namedtuple("Property", "name unit doc required default minimum maximum minimum_open maximum_open")
Property.__doc__ = "A named number; default is None when absent, a bound that is open is itself not allowed."
FieldInfo = namedtuple("FieldInfo", "name unit doc location components dtype index writable")
LogLine = namedtuple("LogLine", "level sequence seconds text")
LogLine.__doc__ = "A line of the log; seconds since the context was created. A gap in sequence: lines kept no longer."
FieldInfo.__doc__ = "An output field; unit in UDUNITS form, dtype float64 or int64."

_UNRECORDED = {
    Status.E_HANDLE: "This object is already destroyed.",
    Status.E_BUSY: "Another thread is inside this object.",
    Status.E_REENTRANT: "A progress function must not call back into the object it reports on.",
}


def _status_of(code):
    """A Status; the plain number where a newer library has one that this package does not know."""
    try:
        return Status(code)
    except ValueError:
        return code


class Issue:
    """A fault of a profile: a sentence for a person, and where it is for a program.

    Attributes: text; is_error (False: only a warning); status; object_kind (Kind or None), object_id, item (e.g. the
    vertex), x, y, value (the offending one): each None where it has no value.
    """

    def __init__(self, info, text):
        self.text = text
        self.status = _status_of(info.status)
        self.is_error = info.status < 0
        self.object_kind = Kind(info.object_kind) if info.object_kind else None
        self.object_id = info.object_id if info.object_id >= 0 else None
        self.item = info.item if info.item >= 0 else None
        self.x, self.y, self.value = (None if math.isnan(v) else v for v in (info.x, info.y, info.value))

    def __str__(self):
        return self.text

    def __repr__(self):
        return f"<{'error' if self.is_error else 'warning'}: {self.text}>"


class Error(Exception):
    """A call failed and changed nothing. str() is the engine's sentence.

    Attributes: status (Status), argument (1-based number in the C function, None), object_kind, object_id, item, x, y,
    value as in Issue.
    """

    def __init__(self, status, text, info=None):
        super().__init__(text)
        self.status = _status_of(status)
        where = Issue(info if info is not None else _nowhere(), text)
        self.argument = info.argument or None if info is not None else None
        self.object_kind, self.object_id, self.item = where.object_kind, where.object_id, where.item
        self.x, self.y, self.value = where.x, where.y, where.value


def _nowhere():
    return _raw.vbgpd_error_info(object_id=-1, item=-1, x=math.nan, y=math.nan, value=math.nan)


class Library:
    """A loaded libvbgpd; `c` has its functions, declared by _raw."""

    _loaded = {}

    def __init__(self, path):
        try:
            self.c = _raw.declare(ctypes.CDLL(path))
        except OSError as error:
            raise ImportError(f"The engine could not be loaded: {error}. Give the path of libvbgpd.so.1, put it into "
                              f"{os.path.dirname(__file__)} or install it for the whole system.") from error
        found = self.c.vbgpd_abi_version()
        if found != _raw.VBGPD_ABI_VERSION:
            raise ImportError(f"{path} has ABI version {found}; this package is for {_raw.VBGPD_ABI_VERSION}.")

    @classmethod
    def load(cls, path=None):
        """The library at a path; without one, from the folder of this package, or libvbgpd.so.1 of the system."""
        if isinstance(path, cls):
            return path
        if path is None:
            name = f"libvbgpd.so.{_raw.VBGPD_ABI_VERSION}"
            beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
            path = beside if os.path.exists(beside) else name
        path = os.fspath(path)
        if path not in cls._loaded:
            cls._loaded[path] = cls(path)
        return cls._loaded[path]


def raise_failure(status, error_function=None, handle=None):
    """Turns a negative status into Error, with the record of the object if it has one; gives back the others."""
    if status >= 0:
        return _status_of(status)
    if error_function is not None:
        info, text = _raw.vbgpd_error_info(), None
        needed = ctypes.c_int64()
        if error_function(handle, None, None, 0, ctypes.byref(needed)) == 0:
            text = ctypes.create_string_buffer(needed.value + 1)
            error_function(handle, ctypes.byref(info), text, len(text), None)
        if text is not None and info.status == status:
            raise Error(status, text.value.decode(), info)
    raise Error(status, _UNRECORDED.get(status, f"The call failed with {_status_of(status)!r}."))


def text_from(call):
    """The text of a call(buf, cap, needed) that gives back a status; None where there is none."""
    needed = ctypes.c_int64()
    if call(None, 0, ctypes.byref(needed)) != 0:
        return None
    buffer = ctypes.create_string_buffer(needed.value + 1)
    call(buffer, len(buffer), None)
    return buffer.value.decode()


def bytes_from(call):
    """The bytes of a call(buf, cap, needed) that gives back a status."""
    needed = ctypes.c_int64()
    call(None, 0, ctypes.byref(needed))
    buffer = ctypes.create_string_buffer(needed.value)
    call(buffer, needed.value, ctypes.byref(needed))
    return buffer.raw


def whole(value, kind, what):
    """A Python or numpy integer that fits an integer type of the C face, which by itself would take it modulo 2^32 or
    2^64."""
    try:
        value = operator.index(value)
    except TypeError:
        raise TypeError(f"{what} must be a whole number, not {value!r}") from None
    bits = 8 * ctypes.sizeof(kind)
    low, high = (0, 2**bits - 1) if kind(-1).value > 0 else (-2**(bits - 1), 2**(bits - 1) - 1)
    if not low <= value <= high:
        raise OverflowError(f"{what} is {value}; it must be between {low} and {high}")
    return value


_WHOLE = (ctypes.c_int32, ctypes.c_uint32, ctypes.c_int64, ctypes.c_uint64)


def fitting(function, arguments):
    """The arguments of a function of the C face, its integers checked to fit."""
    return [whole(value, kind, f"argument {i + 1} of {function.__name__}") if kind in _WHOLE else value
            for i, (kind, value) in enumerate(zip(function.argtypes, arguments))]


def address(array, number=ctypes.c_double):
    """The first item of a numpy array as the C face wants it."""
    return ctypes.cast(array.ctypes.data, ctypes.POINTER(number))


def points_in(xy):
    """(array, pointer, stride, n) of points, in place where y lies behind x; the caller holds on to the array."""
    array = numpy.asarray(xy, dtype=numpy.float64)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"points are rows of x and y; the array has the shape {array.shape}")
    if array.strides[1] != 8 or abs(array.strides[0]) < 16:
        array = numpy.ascontiguousarray(array)
    return array, address(array), array.strides[0] if len(array) > 1 else 16, len(array)


def points_from(call):
    """The points of a call(xy, stride, cap, n) as an array of shape (n, 2)."""
    n = ctypes.c_int64()
    call(None, 16, 0, ctypes.byref(n))
    array = numpy.empty((n.value, 2))
    if n.value:
        call(address(array), 16, n.value, ctypes.byref(n))
    return array


def version(library=None):
    """The version of the library, e.g. '1.0.0'."""
    return Library.load(library).c.vbgpd_version_string().decode()


def version_number(library=None):
    """major * 1000000 + minor * 1000 + patch of the library."""
    return Library.load(library).c.vbgpd_version_number()


def status_name(status, library=None):
    """'VBGPD_E_RANGE' of -11."""
    return Library.load(library).c.vbgpd_status_name(status).decode()


def build_info(key=None, library=None):
    """A fact of the library, e.g. build_info("compiler"); without a key all of them as a dict."""
    c, name = Library.load(library).c, (key or "").encode()
    text = text_from(lambda *buffer: raise_failure(c.vbgpd_build_info(name, len(name), *buffer)))
    return text if key else dict(line.split(" = ", 1) for line in text.splitlines())


def properties(kind, library=None):
    """Every named number of a Kind, as a list of Property."""
    c, count = Library.load(library).c, ctypes.c_int64()
    raise_failure(c.vbgpd_property_count(kind, ctypes.byref(count)))
    listed = []
    for i in range(count.value):
        p = _raw.vbgpd_property_info()
        raise_failure(c.vbgpd_property_info_at(kind, i, ctypes.byref(p)))
        default = None if math.isnan(p.default_value) else p.default_value
        listed.append(Property(p.name.decode(), p.unit.decode(), p.doc.decode(), bool(p.required), default, p.min_value,
                               p.max_value, bool(p.min_open), bool(p.max_open)))
    return listed


def fields(library=None):
    """Every output field, as a list of FieldInfo in the order of their numbers."""
    c, count = Library.load(library).c, ctypes.c_int64()
    raise_failure(c.vbgpd_field_count(ctypes.byref(count)))
    listed = []
    for i in range(count.value):
        f = _raw.vbgpd_field_info()
        raise_failure(c.vbgpd_field_info_at(i, ctypes.byref(f)))
        dtype = numpy.dtype(numpy.int64 if f.type == _raw.VBGPD_TYPE_I64 else numpy.float64)
        listed.append(FieldInfo(f.name.decode(), f.unit.decode(), f.doc.decode(), Location(f.location), f.components,
                                dtype, i, bool(f.writable)))
    return listed


def field(name, library=None):
    """The FieldInfo of a name."""
    c, index, key = Library.load(library).c, ctypes.c_int32(), name.encode()
    status = c.vbgpd_field_find(key, len(key), ctypes.byref(index))
    listed = fields(library)
    if status < 0:
        known = [f.name for f in listed]
        near = difflib.get_close_matches(name, known, 1)
        meant = f'; did you mean "{near[0]}"?' if near else "."
        raise Error(status, f'There is no field named "{name}": there are {", ".join(known)}{meant}')
    return listed[index.value]
