"""The conformance transcript in Python; it must print what transcript.c prints. Usage: transcript.py LIBRARY."""
import ctypes
import struct
import sys

import numpy

import vbgpd
from vbgpd import Kind, Location, Status, _raw

library = vbgpd.Library.load(sys.argv[1])
OUTLINE = numpy.array([[0, 0], [40, 0], [40, 5], [25, 5], [15, 15], [0, 15]], dtype=float)
MASK = (1 << 64) - 1


def hex_of(value):
    return struct.pack(">d", float("nan") if value is None else value).hex().upper()


def hexes(*values):
    return " ".join(hex_of(value) for value in values)


def checksum(array):
    total = 0
    for word in numpy.ascontiguousarray(array).view(numpy.uint64).ravel().tolist():
        total = ((total << 1) | (total >> 63)) & MASK ^ word
    return f"{total:016X}"


def said(what, status, fault, text):
    """An Issue or an Error as the C program prints a vbgpd_error_info."""
    absent = [-1 if v is None else v for v in (fault.object_id, fault.item)]
    return (f"{what} {status}: status {int(fault.status)} kind {fault.object_kind or 0:d} "
            f"id {absent[0]} item {absent[1]} at {hexes(fault.x, fault.y)} value {hex_of(fault.value)}: {text}")


def failure(call, *arguments):
    try:
        call(*arguments)
    except vbgpd.Error as error:
        return f"argument {error.argument or 0} of " + said("failure", int(error.status), error, str(error))
    return "no failure"


def tables():
    print(f"01 version {vbgpd.version_number(library)} {library.c.vbgpd_abi_version()} {vbgpd.version(library)}")
    built = vbgpd.build_info("compiler", library)
    print(f"   built 0 {len(built)} {built}")
    print("02 status", *(vbgpd.status_name(status, library) for status in (-11, 3, 12345)))
    for kind in range(Kind.PROFILE, Kind.JOB + 1):
        listed = vbgpd.properties(kind, library)
        print(f"03 properties of kind {kind}: {len(listed)}")
        for p in listed:
            print(f"   {p.name} [{p.unit}] {p.required:d} {hexes(p.default, p.minimum, p.maximum)} {p.minimum_open:d} "
                  f"{p.maximum_open:d} {p.doc}")
    for f in vbgpd.fields(library):
        print(f"04 field {vbgpd.field(f.name, library).index} {f.name} [{f.unit}] type {2 if f.dtype == int else 1} "
              f"at {f.location:d} of {f.components} writable {f.writable:d}: {f.doc}")


def issues(profile):
    found = profile.validate()
    errors = sum(issue.is_error for issue in found)
    print(f"validate 0 errors {errors} warnings {len(found) - errors}")
    for issue in found:
        print(said("   issue", 0, issue, issue.text))


def contexts():
    desc, other = _raw.vbgpd_context_desc(), _raw.vbgpd_context()
    library.c.vbgpd_context_desc_init(desc, ctypes.sizeof(desc))
    desc.abi_version = 99
    refused = library.c.vbgpd_context_create(desc, other)
    context = vbgpd.Context(max_particles=100000, library=library)
    print("05 context", refused, 0, library.c.vbgpd_context_error(context.handle, None, None, 0, None))
    return context


def edit(context, profile):
    profile.set("name", "Böschung 斜面")
    name = profile.get_text("name")
    print("06 name 0", len(name.encode()), name)
    bow_tie = numpy.array([[0, 0, -7], [10, 10, -7], [10, 0, -7], [0, 10, -7]], dtype=float)
    profile.set_exterior(bow_tie[:, :2])
    print("07 bow tie 0", end=" ")
    issues(profile)
    profile.set_exterior(OUTLINE[::-1])
    corners = numpy.full((7, 3), 99.0)
    corners[:6, :2] = profile.polygon()
    print(f"08 outline backwards 0: {len(profile.polygon())} points, checksum {checksum(corners)}")
    profile.set_water_table(OUTLINE[:2])
    wet = len(profile.water_table())
    profile.set_water_table([])
    print(f"08 water table 0: {wet} points, then 0: {len(profile.water_table())}")
    print(f"09 material 0 id {profile.add_material('soil')}, again:", failure(profile.add_material, "soil"))
    print("10 unknown name:", failure(profile.set, "cohesin", 1, Kind.MATERIAL, 0))
    buffer, needed = ctypes.create_string_buffer(b"untouched"), ctypes.c_int64()
    small = library.c.vbgpd_profile_get_text(profile.handle, Kind.MATERIAL, 0, b"law", 3, buffer, 3, needed)
    print(f"11 small buffer {small} needed {needed.value} {buffer.value.decode()}:", failure(profile._check, small))
    print("12 model of half a profile:", failure(vbgpd.Model, context, profile))
    for name, value in dict(unit_weight=20e3, cohesion=12e3, friction_angle=20).items():
        profile.set(name, value, Kind.MATERIAL, 0)
    profile.set("spacing", 1.25)
    profile.set("srf_tolerance", 0.05)
    print("13 numbers", hexes(profile.get("young_modulus", Kind.MATERIAL), profile.get("tension_cutoff", Kind.MATERIAL),
                              profile.get("spacing")))
    layer = profile.add_layer(0)
    line = profile.add_boundary(vbgpd.Boundary.FIXED, xy=[(0, 0), (40, 0)])
    side = profile.add_boundary(vbgpd.Boundary.ROLLER, "left")
    profile.add_boundary(vbgpd.Boundary.ROLLER, "right")
    load = profile.add_load(2, 8, 5e3)
    print("14 parts 0 0 0 0 0 ids", layer, line, side, load, "counts",
          *(profile.count(kind) for kind in (Kind.MATERIAL, Kind.LAYER, Kind.LOAD, Kind.BOUNDARY)), end=" ")
    issues(profile)


def numbers(model, *names):
    return hexes(*(model.get(name) for name in names))


def equilibrium(model):
    with vbgpd.Job.equilibrium(model) as job:
        status = job.run(slice_seconds=0.05)
        print(f"16 equilibrium 0 {status:d}",
              numbers(job, "unbalanced_force_ratio", "max_displacement", "displacement_level", "steps"),
              f"hash {model.state_hash:016X}")


def read_fields(model):
    for f in vbgpd.fields(library):
        values = model.field(f.name)
        print(f"17 {f.name} 0 {len(values)} {checksum(values)}")
    wide = numpy.full((2 * model.item_count(Location.PARTICLE), 6), 7.0)
    read = model.field("stress", wide[::2, 4:0:-1])
    print(f"18 strided stress 0 {len(read)} {checksum(wide)}")
    whole = numpy.empty(len(read), numpy.int64)
    print("19 whole numbers of a real field:", failure(model.field, "volume", whole))


def dynamics(model):
    model.set("damping", 0.25)
    status, r = model.step(5)
    print(f"20 steps {status:d} {r.steps}",
          hexes(r.time, r.time_step, r.kinetic_energy, r.unbalanced_force_ratio, r.max_displacement, r.max_velocity),
          f"{r.plastic_bonds} hash {model.state_hash:016X}")
    model.cancel()
    status, r = model.step(5)
    print(f"21 cancelled 0 {status:d} {r.steps}, minus one step:", failure(model.step, -1))


def plan(model):
    for f in model.plan():
        print("21", f.used, f.name.decode(), f.bytes, hexes(f.bytes_per_particle, f.bytes_per_bond))


def strength_reduction(model, job):
    job.set("levels", 1)
    print("22 option 0, unknown:", failure(job.set, "level", 1))
    status = job.run(slice_seconds=0.05)
    print(f"23 strength reduction {status:d}",
          numbers(job, "factor_of_safety", "srf_stable", "srf_unstable", "displacement_level", "sliding_area", "levels",
                  "trials", "steps", "particles", "bonds"), f"hash {model.state_hash:016X}")
    for name in ("status", "reason", "scheme", "reduced", "flow_rule"):
        print(f"   {name}: {job.get_text(name)}")
    for t in job.trials():
        print("24 trial", t.level, t.verdict, t.band_connected,
              hexes(t.strength_reduction_factor, t.unbalanced_force_ratio, t.unbalanced_force_slope,
                    t.displacement_level, t.displacement_growth, t.power_ratio), t.steps)
    print("   then", library.c.vbgpd_job_trial(job.handle, len(job.trials()), _raw.vbgpd_trial()))
    for level in job.levels():
        print("25 level", hexes(level.spacing_x, level.spacing_y), level.particles, level.bonds, level.steps,
              level.trials, hexes(level.srf_stable, level.srf_unstable, level.factor_of_safety))
    print("   then", library.c.vbgpd_job_level(job.handle, len(job.levels()), _raw.vbgpd_level()))
    surface = job.slip_surface()
    print(f"26 slip surface 0 {len(surface)} {checksum(surface)}")


def progress(context, profile):
    """So fine a grid takes far longer than the tenth of a second after which the function is called."""
    profile.set("spacing", 0.25)
    with vbgpd.Model(context, profile) as model, vbgpd.Job.strength_reduction(model) as job:
        calls = []
        stop_at_once = _raw.vbgpd_progress_fn(lambda user, p: calls.append(p.contents.fraction) or 1)
        stopped = library.c.vbgpd_job_run(job.handle, 0, stop_at_once, None, None)
        calls = sum(0 <= fraction <= 1 for fraction in calls)
        job.cancel()
        print(f"27 stopped by the progress function {stopped} after {calls}, cancelled {job.run():d}")


def advance(what, model, time):
    status, r = model.advance_to(time)
    print(f"{what} {status:d} {r.steps}", hexes(r.time, r.time_step), f"hash {model.state_hash:016X}")


def states(model):
    # 2 columns of 3 values, the water table at the level of the toe
    water = [[50e3, 50e3], [0, 0], [-50e3, -50e3]]
    advance("28 advanced", model, 0.03125)
    state = model.save()
    model.save(state)
    model.write_grid("pore_pressure", 0, 0, 40, 5, water)
    print("29 saved 0 again 0, water 0")
    advance("   with water", model, 0.0625)
    model.restore(state)
    print(f"   back 0 hash {model.state_hash:016X}")
    advance("   without", model, 0.0625)
    state.close()
    print(f"   epoch {model.epoch}, destroyed 0, backwards:", failure(model.advance_to, 0))


def selections(model):
    soil, part = vbgpd.Selection(soil=True), vbgpd.Selection(polygon=[(10, 2), (30, 2), (30, 8), (10, 8)])
    told = [("soil", model.select(soil)), ("polygon", model.select(part)),
            ("displacement", model.field("displacement", where=part)), ("material", model.field("material", where=part))]
    print("30", *(f"{name} 0 {len(values)} {checksum(values)}" for name, values in told))


def samples(model):
    points = model.sample("stress", [(5, 5), (20, 4), (20, 14)])
    inside = (~numpy.isnan(points[:, 0])).astype(numpy.int64)
    line = model.sample_line("stress", (2, 1), (12, 11), 6)
    grid = model.sample_grid("plastic_strain", 1, 1, 3, 1, 4, 3)
    marks = (~numpy.isnan(grid)).astype(numpy.int64)
    ground = model.ground_surface()
    print(f"31 points 0 {checksum(points[:2])} {checksum(inside)} line 0 {checksum(line)} grid 0 {checksum(grid)} "
          f"{checksum(marks)} ground 0 {len(ground)} {checksum(ground)}")
    with model.view("displacement") as view:
        print(f"   view 0 {hex_of(min(0.0, view.array.min()))}, held:", failure(model.step, 1))
    print("   released 0")


def outside(model):
    model.write_points("pore_pressure", [(0, 0), (40, 0), (0, 15)], [60e3, 20e3, -10e3])
    model.write("external_force", [(-1e3, 2e3)], vbgpd.Selection(ids=[3]))
    model.set_load(0, 7e3, 9e3)
    model.set("kh", 0.0625)
    print("32 from outside 0 0 0 0, a fixed boundary:", failure(model.set_boundary_velocity, 0, 1, 0))
    advance("   then", model, 0.09375)
    for boundary in range(3):
        print("   reaction 0", hexes(*model.boundary_reaction(boundary)))
    model.set_layer_active(0, True)
    print("   layer on 0, the only one off:", failure(model.set_layer_active, 0, False))


def events(model):
    print("   events 0", *(f"{e.kind} {e.sequence} {e.step} {hex_of(e.time)} {e.id_a} {e.id_b} "
                           f"{hexes(e.x, e.y, e.value)}" for e in model.events()))


def checkpoint(context, profile, model):
    data = model.checkpoint()
    other = vbgpd.Model.from_checkpoint(context, data)
    print(f"33 checkpoint 0 {len(data)} made 0 hash {other.state_hash:016X}")
    advance("   both", model, 0.125)
    advance("   both", other, 0.125)
    model.restore_checkpoint(data)
    print(f"   back 0 hash {model.state_hash:016X}")
    print("   cut short:", failure(model.restore_checkpoint, data[:len(data) // 2]))
    print(f"   profile 0 {len(profile.to_flatbuffer())} snapshot 0 {len(model.snapshot())}")


def coupling(context, profile):
    profile.set("spacing", 1.25)
    with vbgpd.Model(context, profile) as model:
        states(model)
        selections(model)
        samples(model)
        outside(model)
        events(model)
        checkpoint(context, profile, model)


def log(context, model):
    lines = []

    def hear(line):
        lines.append(line)
        print(f"   heard level {line.level}: {line.text}")
    data = model.checkpoint()
    context.set_log(hear)
    vbgpd.Model.from_checkpoint(context, data).close()
    context.set_log(None)
    print(f"   told 0 0 0, {len(lines)} lines")


def memory(context, model):
    line = context.log()[0]
    print(f"   log 0 level {line.level} sequence {line.sequence}: {line.text} then {Status.END_OF_DATA:d}")
    m = model.memory()
    print("   memory 0", m.bytes, m.model, m.state, m.scratch, m.copies, m.outside, m.saved)


def endings(context, profile, model, job):
    c, n, value = library.c, ctypes.c_int64(), ctypes.c_double()
    gone = _raw.vbgpd_profile(profile.handle.value)
    profile.close()
    foreign = _raw.vbgpd_model(context.handle.value)
    print("34 destroyed 0", c.vbgpd_profile_count(gone, Kind.LAYER, n), "NULL",
          c.vbgpd_model_item_count(None, Location.BOND, n), c.vbgpd_job_get_f64(None, b"steps", 5, value),
          c.vbgpd_profile_destroy(None), "foreign", c.vbgpd_model_item_count(foreign, Location.BOND, n))
    context.close()
    model.close()
    print("35 destroyed 0 0, job still has", numbers(job, "factor_of_safety"), end=" ")
    job.close()
    print(0)


sys.stdout.reconfigure(encoding="utf-8", newline="\n")
tables()
context = contexts()
profile = vbgpd.Profile(context)
edit(context, profile)
model = vbgpd.Model(context, profile)
print("15 model 0", numbers(model, "particles", "bonds", "area", "height", "total_mass", "spacing_x", "spacing_y"),
      f"hash {model.state_hash:016X}")
memory(context, model)
log(context, model)
equilibrium(model)
read_fields(model)
dynamics(model)
plan(model)
model = vbgpd.Model(context, profile)
job = vbgpd.Job.strength_reduction(model)
strength_reduction(model, job)
progress(context, profile)
coupling(context, profile)
endings(context, profile, model, job)
