"""vbgpd for Python: factor of safety, slip surface and particle fields of soil slopes.

    import vbgpd
    with vbgpd.Context() as context, vbgpd.Profile(context) as slope:
        slope.set_exterior([(0, 0), (32, 0), (12, 10), (0, 10)])
        clay = slope.add_material("clay", unit_weight=20e3, cohesion=10e3, friction_angle=20)
        slope.add_layer(clay)
        slope.set("spacing", 0.5)
        with vbgpd.Model(context, slope) as model, vbgpd.Job.strength_reduction(model) as job:
            job.run(lambda progress: print(f"{progress.fraction:.0%}"))
            print(job.get("factor_of_safety"), job.slip_surface())

Everything is SI (m, N, Pa, kg, s), angles in degrees, x right, y up, stress positive in tension. A call that fails
raises Error with the engine's sentence and where the fault is. Objects may be closed in any order, by `with`, by
close() or by the garbage collector. The package needs numpy and, without being built, the library: see Library.load.
"""
import ctypes
import time

import numpy

from . import _raw
from ._arrays import Selection, View, values_in
from ._engine import (Boundary, Error, Event, FieldInfo, Issue, Kind, Library, Location, LogLevel, LogLine, Property, Status, Verdict, address,
                      build_info, bytes_from, field, fields, fitting, points_from, points_in, properties, raise_failure, status_name,
                      text_from, version, version_number, whole)

__all__ = ["Boundary", "Context", "Error", "Event", "FieldInfo", "Issue", "Job", "Kind", "Library", "Location", "LogLevel", "LogLine",
           "Model", "Profile", "Property", "Selection", "State", "Status", "Verdict", "View", "build_info", "field",
           "fields", "properties", "status_name", "version", "version_number"]


class _Object:
    """A handle that is destroyed once: at the end of `with`, by close(), or when nobody holds the object any more."""

    _name = None  # of its functions in the C face: vbgpd_<name>_destroy ...
    _handle = None

    def __init__(self, library, create, *arguments, owner=None):
        self._library, self._c = library, library.c
        handle = getattr(_raw, f"vbgpd_{self._name}")()
        function = getattr(self._c, create)
        status = function(*fitting(function, (*arguments, ctypes.byref(handle))))
        if owner is None:  # a context: what it is made from tells
            raise_failure(status, self._c.vbgpd_context_desc_check, *arguments)
        else:
            owner._check(status)
        self._handle = handle

    @property
    def handle(self):
        """The handle for calls of the functions of `Library.c`; NULL once closed."""
        return self._handle

    def _check(self, status):
        return raise_failure(status, getattr(self._c, f"vbgpd_{self._name}_error"), self._handle)

    def _call(self, function, *arguments):
        call = getattr(self._c, f"vbgpd_{self._name}_{function}")
        return self._check(call(*fitting(call, (self._handle, *arguments))))

    def _get(self, *arguments):
        """The last argument is a name; get_f64 of the object."""
        *before, name = arguments
        value, key = ctypes.c_double(), name.encode()
        self._call("get_f64", *before, key, len(key), ctypes.byref(value))
        return value.value

    def _get_text(self, *arguments):
        *before, name = arguments
        key = name.encode()
        return text_from(lambda *buffer: self._call("get_text", *before, key, len(key), *buffer))

    def _records(self, function, kind):
        listed = []
        while True:
            record = kind()
            if self._call(function, len(listed), ctypes.byref(record)) == Status.END_OF_DATA:
                return listed
            listed.append(record)

    def close(self):
        """Destroys the object; closing twice is allowed."""
        if self._handle:
            self._call("destroy")
            self._handle = type(self._handle)()

    def __enter__(self):
        return self

    def __exit__(self, *exception):
        self.close()

    def __del__(self):
        if self._handle:
            getattr(self._c, f"vbgpd_{self._name}_destroy")(self._handle)


class Context(_Object):
    """Threads and limits of the models made in it.

    threads: workers per model, 0 = all cores; results do not depend on it. max_particles, max_bytes (of one model): 0 = no
    limit.
    library: path of libvbgpd.so.1; by default that beside this package, or the system's.
    """

    _name = "context"

    def __init__(self, threads=1, max_particles=0, library=None, max_bytes=0):
        loaded = Library.load(library)
        desc = _raw.vbgpd_context_desc()
        raise_failure(loaded.c.vbgpd_context_desc_init(ctypes.byref(desc), ctypes.sizeof(desc)))
        desc.threads = whole(threads, ctypes.c_int32, "threads")
        desc.max_particles = whole(max_particles, ctypes.c_int64, "max_particles")
        desc.max_bytes = whole(max_bytes, ctypes.c_int64, "max_bytes")
        super().__init__(loaded, "vbgpd_context_create", ctypes.byref(desc))

    def log(self, after=0):
        """What the engine had to say, oldest first: a list of LogLine with a sequence above `after`."""
        lines, record, text = [], _raw.vbgpd_log_line(), ctypes.create_string_buffer(248)
        while self._call("log_next", after, ctypes.byref(record), text, len(text), None) != Status.END_OF_DATA:
            after = record.sequence
            lines.append(LogLine(LogLevel(record.level), after, record.seconds, text.value.decode()))
        return lines

    def set_log(self, hear, level=LogLevel.INFO):
        """Calls hear(LogLine) for every line of that level and below, within the call that says it; None ends it."""
        def tell(_, line, text):
            hear(LogLine(LogLevel(line[0].level), line[0].sequence, line[0].seconds, text.decode()))
        function = _raw.vbgpd_log_fn(tell) if hear else _raw.vbgpd_log_fn()
        self._call("set_log", function, None, level)
        self._hears = function  # as long as the engine may call it


class Profile(_Object):
    """A slope profile: polygons, materials, loads and supports. Points are rows of x and y: lists or numpy arrays."""

    _name = "profile"

    def __init__(self, context):
        super().__init__(context._library, "vbgpd_profile_create", context.handle, owner=context)

    @classmethod
    def from_flatbuffer(cls, context, data):
        """A profile from the bytes of a scene as a flatbuffer (file identifier VBGP)."""
        self = cls.__new__(cls)
        _Object.__init__(self, context._library, "vbgpd_profile_create_from_flatbuffer", context.handle, bytes(data),
                         len(data), owner=context)
        return self

    def to_flatbuffer(self):
        """The profile as the bytes of a scene flatbuffer."""
        return bytes_from(lambda *buffer: self._call("to_flatbuffer", *buffer))

    def set_exterior(self, xy):
        """The outline of the section, any winding."""
        array, pointer, stride, n = points_in(xy)
        self._call("set_exterior", pointer, stride, n)

    def add_material(self, name, law=None, **numbers):
        """Adds a material and gives its id; e.g. add_material("clay", unit_weight=20e3, cohesion=10e3).

        A number or law that is refused raises Error; the material stays, as the C face leaves it.
        """
        material, key = ctypes.c_int64(), name.encode()
        self._call("add_material", key, len(key), ctypes.byref(material))
        if law is not None:
            self.set("law", law, Kind.MATERIAL, material.value)
        for number, value in numbers.items():
            self.set(number, value, Kind.MATERIAL, material.value)
        return material.value

    def add_layer(self, material, xy=None):
        """Paints a polygon, or without one the whole exterior, with the material of that id; gives the layer's id."""
        layer = ctypes.c_int64()
        array, *points = points_in(xy) if xy is not None else (None, None, 16, 0)
        self._call("add_layer", *points, material, ctypes.byref(layer))
        return layer.value

    def add_boundary(self, kind, side=None, xy=None):
        """Holds a side ("base", "left", "right") or a polyline along the exterior; kind is a Boundary. Gives its id."""
        boundary = ctypes.c_int64()
        key = side.encode() if side is not None else None
        array, *points = points_in(xy) if xy is not None else (None, None, 16, 0)
        self._call("add_boundary", key, len(key or b""), *points, kind, ctypes.byref(boundary))
        return boundary.value

    def add_load(self, x0, x1, pressure, pressure_end=None):
        """Pressure (Pa, down positive) on the ground from x0 to x1, linear to pressure_end if given; gives its id."""
        load = ctypes.c_int64()
        self._call("add_load", x0, x1, pressure, pressure if pressure_end is None else pressure_end, ctypes.byref(load))
        return load.value

    def set_water_table(self, xy):
        """Ground water, hydrostatic below this line (left to right over the whole section); [] = dry. Above the ground
        the water stands there and presses on it."""
        array, *points = points_in(xy) if len(xy) else (None, None, 16, 0)
        self._call("set_water_table", *points)

    def water_table(self):
        """Points of the water table, (n, 2); none where the section is dry."""
        return points_from(lambda *points: self._call("water_table", *points))

    def set(self, name, value, kind=Kind.PROFILE, id=0):
        """A named number or text of the profile, or of the part `id` of a Kind; None takes a number back to absent."""
        key = name.encode()
        if isinstance(value, str):
            text = value.encode()
            self._call("set_text", kind, id, key, len(key), text, len(text))
        else:
            self._call("set_f64", kind, id, key, len(key), float("nan") if value is None else value)

    def get(self, name, kind=Kind.PROFILE, id=0):
        """A named number; NaN when absent. `properties(kind)` lists them."""
        return self._get(kind, id, name)

    def get_text(self, name, kind=Kind.PROFILE, id=0):
        """A named text, e.g. get_text("law", Kind.MATERIAL, clay)."""
        return self._get_text(kind, id, name)

    def count(self, kind):
        """How many materials, layers, loads or boundaries there are."""
        n = ctypes.c_int64()
        self._call("count", kind, ctypes.byref(n))
        return n.value

    def polygon(self, kind=Kind.PROFILE, id=0):
        """The exterior, the polygon of a layer or the polyline of a boundary: an array of shape (n, 2)."""
        return points_from(lambda *target: self._call("polygon", kind, id, *target))

    def validate(self):
        """Every fault, not the first: a list of Issue; those with is_error forbid a model."""
        self._call("validate", None, None)
        issues, info = [], _raw.vbgpd_error_info()
        while True:
            i = len(issues)
            if self._call("issue", i, ctypes.byref(info), None, 0, None) == Status.END_OF_DATA:
                return issues
            issues.append(Issue(info, text_from(lambda *buffer: self._call("issue", i, None, *buffer))))


class Model(_Object):
    """Particles and virtual bonds of a profile. A faulty profile raises Error with every error in its text."""

    _name = "model"

    def __init__(self, context, profile):
        super().__init__(context._library, "vbgpd_model_create", context.handle, profile.handle, owner=context)

    @classmethod
    def runout_of(cls, model):
        """A model that goes on from the present state of another one in updated-Lagrangian form: large motion, to rest."""
        made = cls.__new__(cls)
        _Object.__init__(made, model._library, "vbgpd_model_create_runout", model.handle, owner=model)
        return made

    def set(self, name, value):
        """"damping", "strength_reduction_factor", "kh", "kv" or (not of a run-out) "time_step_factor" of step()."""
        key = name.encode()
        self._call("set_f64", key, len(key), value)

    def get(self, name):
        """A named number: time, particles, bonds, kinetic_energy ...; vbgpd.h lists them at vbgpd_model_get_f64."""
        return self._get(name)

    def step(self, steps):
        """Explicit dynamic steps; gives (Status, record) with the members of vbgpd_advance_result."""
        record = _raw.vbgpd_advance_result()
        return self._call("step", steps, ctypes.byref(record)), record

    def advance_to(self, time, callback=None, slice_seconds=0.1):
        """Dynamic steps that end exactly at `time`; gives (Status, record) as step() does.

        In slices: Ctrl-C is heard between two of them (KeyboardInterrupt; call again with the same time to go on), and
        callback is given the record of the slice; a true answer stops as CANCELLED.
        """
        record, steps = _raw.vbgpd_advance_result(), 0
        while True:
            status = self._call("advance_to", time, slice_seconds, _raw.vbgpd_progress_fn(), None, ctypes.byref(record))
            steps += record.steps
            record.steps = steps
            stop = callback is not None and callback(record)
            if status != Status.LIMIT_REACHED:
                return status, record
            if stop:
                return Status.CANCELLED, record

    def cancel(self):
        """Stops a step() or advance_to() of another thread, or the next one, between two steps."""
        self._call("cancel")

    @property
    def epoch(self):
        """Grows whenever particles are added, removed or stored in another order."""
        n = ctypes.c_int64()
        self._call("epoch", ctypes.byref(n))
        return n.value

    def save(self, state=None):
        """A State to restore() later; writes over one that is given."""
        return State(self) if state is None else state.save(self)

    def restore(self, state):
        """Takes the model back to a State of its own: everything, also what was set from outside."""
        self._call("restore_state", state.handle)

    def checkpoint(self):
        """The model with its profile as bytes, for a file or another process."""
        return bytes_from(lambda *buffer: self._call("checkpoint", *buffer))

    @classmethod
    def from_checkpoint(cls, context, data):
        """A model from the bytes of checkpoint()."""
        self = cls.__new__(cls)
        _Object.__init__(self, context._library, "vbgpd_model_create_from_checkpoint", context.handle, bytes(data),
                         len(data), owner=context)
        return self

    def restore_checkpoint(self, data):
        """Takes a model of the same profile back to a checkpoint; one of another profile raises Error (E_FORMAT)."""
        self._call("restore_checkpoint", bytes(data), len(data))

    def snapshot(self):
        """What can be seen of the model, as the bytes of a flatbuffer (snapshot.fbs) for other programs."""
        return bytes_from(lambda *buffer: self._call("snapshot", *buffer))

    def item_count(self, location):
        """How many particles or bonds there are."""
        n = ctypes.c_int64()
        self._call("item_count", location, ctypes.byref(n))
        return n.value

    def events(self, after=0):
        """What happened, oldest first: records with the members of vbgpd_event and a sequence above `after`."""
        n = ctypes.c_int64()
        self._call("events_read", after, None, 0, 0, ctypes.byref(n), None)
        records = (_raw.vbgpd_event * max(n.value, 1))()
        records[0].struct_size = size = ctypes.sizeof(_raw.vbgpd_event)
        if n.value:
            self._call("events_read", after, records, size, n.value, ctypes.byref(n), None)
        return list(records[:n.value])

    def select(self, where):
        """The ids of the particles of a Selection."""
        n = ctypes.c_int64()
        self._call("select", where.pointer, None, 8, 0, ctypes.byref(n))
        ids = numpy.empty(n.value, numpy.int64)
        if n.value:
            self._call("select", where.pointer, address(ids, ctypes.c_int64), 8, n.value, None)
        return ids

    def field(self, name, out=None, where=None):
        """A field as an array of shape (items,) or (items, components); `fields()` lists them.

        where: a Selection, for some of the particles. out: an array of that shape, float64 or, for whole numbers,
        int64; any view of a larger one is written in place.
        """
        info = field(name, self._library)
        items = self.item_count(info.location) if where is None else len(self.select(where))
        shape = (items,) if info.components == 1 else (items, info.components)
        if out is None:
            out = numpy.empty(shape, info.dtype)
        kinds = (numpy.float64, numpy.int64)
        if out.shape != shape or out.dtype not in kinds or not out.flags.writeable or 0 in out.strides:
            raise ValueError(f'the field "{name}" needs a writeable array of shape {shape} and float64 or int64, '
                             f"not {out.shape} and {out.dtype}")
        whole = out.dtype == numpy.int64
        target = (address(out, ctypes.c_int64 if whole else ctypes.c_double), out.strides[0] if out.ndim else 0,
                  out.strides[1] if out.ndim == 2 else 0, items, None)
        if where is None:
            self._call("read_i64" if whole else "read_f64", info.index, *target)
        else:
            self._call("read_selected_i64" if whole else "read_selected_f64", info.index, where.pointer, *target)
        return out

    def plan(self):
        """Every feature of the engine, used or left out, and its bytes: records with the members of vbgpd_feature."""
        return self._records("plan", _raw.vbgpd_feature)

    def memory(self):
        """The bytes of the model by what they are for: a record with the members of vbgpd_memory."""
        record = _raw.vbgpd_memory()
        self._call("memory", ctypes.byref(record))
        return record

    def _sampled(self, function, name, shape, *places):
        info = field(name, self._library)
        count = int(numpy.prod(shape))
        values, inside = numpy.empty((count, info.components)), numpy.empty(count, numpy.int64)
        self._call(function, info.index, *places, address(values), 0, 0, address(inside, ctypes.c_int64), 0)
        return values.reshape(shape if info.components == 1 else (*shape, info.components))

    def sample(self, name, xy):
        """A field at places, rows of x and y in the present shape; NaN where no soil is."""
        array, *places = points_in(xy)
        return self._sampled("sample_points", name, (len(array),), *places)

    def sample_line(self, name, start, end, n):
        """A field at n places at equal distances from start to end, both included."""
        return self._sampled("sample_line", name, (n,), *start, *end, n)

    def sample_grid(self, name, x0, y0, dx, dy, nx, ny):
        """A field on a raster: an array of shape (ny, nx) or (ny, nx, components)."""
        return self._sampled("sample_grid", name, (ny, nx), x0, y0, dx, dy, nx, ny)

    def ground_surface(self):
        """The ground surface in its present shape, left to right: an array of shape (n, 2)."""
        return points_from(lambda *target: self._call("ground_surface", *target))

    def view(self, name):
        """A View of a field where it is stored, without a copy; the model does not change while it is held."""
        return View(self, field(name, self._library), self._library)

    def _call(self, function, *arguments):
        for lease in self.__dict__.pop("_late", ()):
            self._end(lease)
        return super()._call(function, *arguments)

    def _end(self, lease):
        """Ends the lease of a view now, or before the next call where another thread is in one."""
        if self._c.vbgpd_model_view_release(self._handle, lease) in (Status.E_BUSY, Status.E_REENTRANT):
            self.__dict__.setdefault("_late", []).append(lease)

    def close(self):
        """Destroys the model; refused (E_LEASED) while arrays of its views are held."""
        if self._handle and any(lease.alive for lease in self.__dict__.get("_leases", ())):
            raise Error(Status.E_LEASED, "Arrays of this model are still held: drop them, then close it.")
        super().close()

    def write(self, name, values, where=None):
        """Sets a writable field of all particles by id, or of a Selection: "pore_pressure", "external_force" ..."""
        info = field(name, self._library)
        array, pointer, *strides = values_in(values, info.components)
        self._call("write_f64", info.index, where.pointer if where else None, pointer, *strides,
                   len(array))

    def write_points(self, name, xy, values):
        """Sets a writable field from values at places, e.g. nodes of a seepage mesh."""
        places, *points = points_in(xy)
        info = field(name, self._library)
        array, pointer, *strides = values_in(values, info.components)
        if len(array) != len(places):
            raise ValueError(f"there are values for {len(array)} places; there are {len(places)} places")
        self._call("write_points", info.index, *points[:2], pointer, *strides, len(array))

    def write_grid(self, name, x0, y0, dx, dy, values):
        """Sets a writable field from a raster: values of shape (ny, nx); NaN = no value."""
        array = numpy.ascontiguousarray(values, dtype=numpy.float64)
        ny, nx = array.shape
        self._call("write_grid", field(name, self._library).index, x0, y0, dx, dy, nx, ny, address(array), 8)

    def set_load(self, load, pressure, pressure_end=None):
        """New pressures of a load of the profile."""
        self._call("set_load", load, pressure, pressure if pressure_end is None else pressure_end)

    def set_boundary_velocity(self, boundary, vx, vy):
        """Of a boundary of kind VELOCITY."""
        self._call("set_boundary_velocity", boundary, vx, vy)

    def set_layer_active(self, layer, active):
        """Takes the soil of a layer away (excavation) or places it (fill)."""
        self._call("set_layer_active", layer, 1 if active else 0)

    def boundary_reaction(self, boundary):
        """The force (x, y) of a boundary on the soil, N per metre run."""
        fx, fy = ctypes.c_double(), ctypes.c_double()
        self._call("boundary_reaction", boundary, ctypes.byref(fx), ctypes.byref(fy))
        return fx.value, fy.value

    @property
    def state_hash(self):
        """64-bit hash of the soil's state (not of what acts on it): same run = same hash, at any thread count."""
        value = ctypes.c_uint64()
        self._call("state_hash", ctypes.byref(value))
        return value.value


class State(_Object):
    """A saved instant of a model, in memory: for trying a step and taking it back."""

    _name = "state"

    def __init__(self, model):
        super().__init__(model._library, "vbgpd_model_save_state", model.handle, owner=model)

    def save(self, model):
        """Writes over this state."""
        model._call("save_state", ctypes.byref(self._handle))
        return self

    def _check(self, status):
        return raise_failure(status)


class Job(_Object):
    """A long analysis: Job.equilibrium(model), Job.strength_reduction(model, ...) or Job.runout(model, ...)."""

    _name = "job"

    def __init__(self, model, create):
        super().__init__(model._library, create, model.handle, owner=model)
        self._model = model  # it cannot be destroyed while the job runs

    @classmethod
    def equilibrium(cls, model):
        """Settles the slope under its weight and loads."""
        return cls(model, "vbgpd_job_create_equilibrium")

    @classmethod
    def strength_reduction(cls, model, **options):
        """Finds the factor of safety. Options: srf_min, srf_max, srf_tolerance, levels, target_error, budget, careful, step_limit,
        stiffness_contrast."""
        job = cls(model, "vbgpd_job_create_strength_reduction")
        for name, value in options.items():
            job.set(name, value)
        return job

    @classmethod
    def runout(cls, model, **options):
        """Lets a run-out model (Model.runout_of) move to rest, or to the option end_time in seconds."""
        job = cls(model, "vbgpd_job_create_runout")
        for name, value in options.items():
            job.set(name, value)
        return job

    def set(self, name, value):
        """An option by name, before the first run()."""
        key = name.encode()
        self._call("set_f64", key, len(key), value)

    def run(self, callback=None, seconds=None, slice_seconds=0.1):
        """Runs to the end, or for `seconds` of wall-clock time, in slices; gives the Status.

        OK, NOT_CONVERGED and UNSTABLE are ends; LIMIT_REACHED (the seconds are over) and CANCELLED can be continued by
        another run(). Between slices Ctrl-C is heard (KeyboardInterrupt, the job can be continued), and callback is
        given the progress, a record with the members of vbgpd_progress; a true answer stops the run as CANCELLED.
        """
        progress = _raw.vbgpd_progress()
        end = float("inf") if seconds is None else time.monotonic() + seconds
        while True:
            slice_end = min(slice_seconds, max(end - time.monotonic(), 1e-3))
            status = self._call("run", slice_end, _raw.vbgpd_progress_fn(), None, ctypes.byref(progress))
            stop = callback is not None and callback(progress)
            if status != Status.LIMIT_REACHED:
                return status
            if stop:
                return Status.CANCELLED
            if time.monotonic() >= end:
                return status

    def cancel(self):
        """Stops the run() of another thread, or the next one; from any thread and from a signal handler."""
        self._call("cancel")

    def get(self, name):
        """A result by name: factor_of_safety, error_estimate ...; vbgpd.h lists them at vbgpd_job_get_f64."""
        return self._get(name)

    def get_text(self, name):
        """"status", "reason", "scheme", "reduced" or "flow_rule"."""
        return self._get_text(name)

    def trials(self):
        """Every strength reduction factor tried, with its evidence: records with the members of vbgpd_trial."""
        return self._records("trial", _raw.vbgpd_trial)

    def levels(self):
        """The grids, coarsest first: records with the members of vbgpd_level."""
        return self._records("level", _raw.vbgpd_level)

    def slip_surface(self):
        """The critical slip surface from left to right: an array of shape (n, 2), empty when there is none."""
        return points_from(lambda *target: self._call("slip_surface", *target))
