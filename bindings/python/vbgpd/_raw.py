"""The C face declared for ctypes, one line per constant, struct member and function of vbgpd.h, in its order.

Nothing here thinks: the manual is vbgpd.h. A test compares every name, type and order with the header.
"""
import ctypes
from ctypes import POINTER, c_char, c_char_p, c_double, c_int32, c_int64, c_uint32, c_uint64, c_void_p

# ---- constants
VBGPD_VERSION_NUMBER = 1000000
VBGPD_ABI_VERSION = 1
VBGPD_STRLEN = -1
VBGPD_OK = 0
VBGPD_CANCELLED = 1
VBGPD_LIMIT_REACHED = 2
VBGPD_NOT_CONVERGED = 3
VBGPD_UNSTABLE = 4
VBGPD_END_OF_DATA = 5
VBGPD_E_ARGUMENT = -1
VBGPD_E_HANDLE = -2
VBGPD_E_MEMORY = -3
VBGPD_E_LIMIT = -4
VBGPD_E_BUSY = -5
VBGPD_E_LEASED = -6
VBGPD_E_REENTRANT = -7
VBGPD_E_STATE = -8
VBGPD_E_GEOMETRY = -9
VBGPD_E_UNKNOWN_NAME = -10
VBGPD_E_RANGE = -11
VBGPD_E_BUFFER = -12
VBGPD_E_FORMAT = -13
VBGPD_E_VERSION = -14
VBGPD_E_DIVERGED = -15
VBGPD_E_UNSUPPORTED = -17
VBGPD_E_INTERNAL = -99
VBGPD_OBJECT_CONTEXT = 1
VBGPD_OBJECT_PROFILE = 2
VBGPD_OBJECT_MATERIAL = 3
VBGPD_OBJECT_LAYER = 4
VBGPD_OBJECT_LOAD = 5
VBGPD_OBJECT_BOUNDARY = 6
VBGPD_OBJECT_MODEL = 7
VBGPD_OBJECT_JOB = 8
VBGPD_OBJECT_STATE = 9
VBGPD_LOG_WARNING = 1
VBGPD_LOG_INFO = 2
VBGPD_LOG_DETAIL = 3
VBGPD_BOUNDARY_FREE = 0
VBGPD_BOUNDARY_FIXED = 1
VBGPD_BOUNDARY_ROLLER = 2
VBGPD_BOUNDARY_VELOCITY = 3
VBGPD_VERDICT_UNDECIDED = 0
VBGPD_VERDICT_STABLE = 1
VBGPD_VERDICT_FAILED = 2
VBGPD_AT_PARTICLE = 1
VBGPD_AT_BOND = 2
VBGPD_TYPE_F64 = 1
VBGPD_TYPE_I64 = 2
VBGPD_SELECT_ALL = 0
VBGPD_SELECT_IDS = 1
VBGPD_SELECT_BOX = 2
VBGPD_SELECT_POLYGON = 3
VBGPD_SELECT_MATERIAL = 4
VBGPD_SELECT_LAYER = 5
VBGPD_SELECT_BOUNDARY = 6
VBGPD_SELECT_SOIL = 7
VBGPD_EVENT_FIRST_YIELD = 1
VBGPD_EVENT_AT_REST = 2
VBGPD_EVENT_MECHANISM = 3
VBGPD_EVENT_DIVERGED = 4
VBGPD_EVENT_NEAR_DIVERGENCE = 5


# ---- handles: a type each, so that ctypes refuses a profile where a model is wanted
class vbgpd_context(c_void_p):
    pass


class vbgpd_profile(c_void_p):
    pass


class vbgpd_model(c_void_p):
    pass


class vbgpd_job(c_void_p):
    pass


class vbgpd_state(c_void_p):
    pass

# ---- structs
class Record(ctypes.Structure):
    """A struct of the C face; knows its struct_size from the start."""

    def __init__(self, **members):
        super().__init__(struct_size=ctypes.sizeof(self), **members)


class vbgpd_error_info(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("status", c_int32),
        ("object_kind", c_int32),
        ("argument", c_int32),
        ("object_id", c_int64),
        ("item", c_int64),
        ("x", c_double),
        ("y", c_double),
        ("value", c_double),
    ]


vbgpd_alloc_fn = ctypes.CFUNCTYPE(c_void_p, c_void_p, c_int64, c_int64)
vbgpd_free_fn = ctypes.CFUNCTYPE(None, c_void_p, c_void_p, c_int64, c_int64)


class vbgpd_context_desc(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("abi_version", c_int32),
        ("threads", c_int32),
        ("reserved", c_int32),
        ("max_particles", c_int64),
        ("max_bytes", c_int64),
        ("alloc", vbgpd_alloc_fn),
        ("free", vbgpd_free_fn),
        ("alloc_user", c_void_p),
    ]


class vbgpd_log_line(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("level", c_int32),
        ("sequence", c_int64),
        ("seconds", c_double),
    ]


class vbgpd_property_info(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("required", c_int32),
        ("name", c_char_p),
        ("unit", c_char_p),
        ("doc", c_char_p),
        ("default_value", c_double),
        ("min_value", c_double),
        ("max_value", c_double),
        ("min_open", c_int32),
        ("max_open", c_int32),
    ]


class vbgpd_feature(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("used", c_int32),
        ("name", c_char_p),
        ("doc", c_char_p),
        ("bytes", c_int64),
        ("bytes_per_particle", c_double),
        ("bytes_per_bond", c_double),
    ]


class vbgpd_memory(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_int32),
        ("bytes", c_int64),
        ("model", c_int64),
        ("state", c_int64),
        ("scratch", c_int64),
        ("copies", c_int64),
        ("outside", c_int64),
        ("saved", c_int64),
    ]


class vbgpd_progress(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("level", c_int32),
        ("trial", c_int32),
        ("phase", c_int32),
        ("steps", c_int64),
        ("fraction", c_double),
        ("strength_reduction_factor", c_double),
        ("srf_stable", c_double),
        ("srf_unstable", c_double),
        ("unbalanced_force_ratio", c_double),
        ("max_displacement", c_double),
    ]


class vbgpd_advance_result(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_int32),
        ("steps", c_int64),
        ("time", c_double),
        ("time_step", c_double),
        ("kinetic_energy", c_double),
        ("unbalanced_force_ratio", c_double),
        ("max_displacement", c_double),
        ("max_velocity", c_double),
        ("plastic_bonds", c_int64),
    ]


class vbgpd_trial(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("level", c_int32),
        ("verdict", c_int32),
        ("band_connected", c_int32),
        ("strength_reduction_factor", c_double),
        ("unbalanced_force_ratio", c_double),
        ("unbalanced_force_slope", c_double),
        ("displacement_level", c_double),
        ("displacement_growth", c_double),
        ("power_ratio", c_double),
        ("steps", c_int64),
        ("wall_seconds", c_double),
    ]


class vbgpd_level(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("reserved", c_int32),
        ("spacing_x", c_double),
        ("spacing_y", c_double),
        ("particles", c_int64),
        ("bonds", c_int64),
        ("steps", c_int64),
        ("trials", c_int64),
        ("srf_stable", c_double),
        ("srf_unstable", c_double),
        ("factor_of_safety", c_double),
        ("wall_seconds", c_double),
        ("cpu_seconds", c_double),
        ("estimate", c_double),
        ("error_estimate", c_double),
        ("sliding_area", c_double),
    ]


class vbgpd_field_info(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("type", c_int32),
        ("location", c_int32),
        ("components", c_int32),
        ("name", c_char_p),
        ("unit", c_char_p),
        ("doc", c_char_p),
        ("writable", c_int32),
        ("reserved", c_int32),
    ]


class vbgpd_selection(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("object_id", c_int64),
        ("xmin", c_double),
        ("ymin", c_double),
        ("xmax", c_double),
        ("ymax", c_double),
        ("ids", POINTER(c_int64)),
        ("ids_stride", c_int64),
        ("n_ids", c_int64),
        ("xy", POINTER(c_double)),
        ("xy_stride", c_int64),
        ("n_points", c_int64),
    ]


class vbgpd_view(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("type", c_int32),
        ("data", c_void_p),
        ("count", c_int64),
        ("components", c_int64),
        ("stride_item", c_int64),
        ("stride_component", c_int64),
        ("epoch", c_int64),
        ("lease", c_int64),
    ]


class vbgpd_event(Record):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("sequence", c_int64),
        ("step", c_int64),
        ("time", c_double),
        ("id_a", c_int64),
        ("id_b", c_int64),
        ("x", c_double),
        ("y", c_double),
        ("value", c_double),
    ]

# ---- callback
vbgpd_log_fn = ctypes.CFUNCTYPE(None, c_void_p, POINTER(vbgpd_log_line), ctypes.c_char_p)
vbgpd_progress_fn = ctypes.CFUNCTYPE(c_int32, c_void_p, POINTER(vbgpd_progress))

# ---- functions: name -> (result, parameters)
FUNCTIONS = {
    # version
    "vbgpd_version_number": (c_int32, ()),
    "vbgpd_abi_version": (c_int32, ()),
    "vbgpd_version_string": (c_char_p, ()),
    # status
    "vbgpd_status_name": (c_char_p, (c_int32,)),
    "vbgpd_build_info": (c_int32, (c_char_p, c_int64, POINTER(c_char), c_int64, POINTER(c_int64))),
    "vbgpd_context_error": (
        c_int32, (vbgpd_context, POINTER(vbgpd_error_info), POINTER(c_char), c_int64, POINTER(c_int64))),
    "vbgpd_profile_error": (
        c_int32, (vbgpd_profile, POINTER(vbgpd_error_info), POINTER(c_char), c_int64, POINTER(c_int64))),
    "vbgpd_model_error": (
        c_int32, (vbgpd_model, POINTER(vbgpd_error_info), POINTER(c_char), c_int64, POINTER(c_int64))),
    "vbgpd_job_error": (c_int32, (vbgpd_job, POINTER(vbgpd_error_info), POINTER(c_char), c_int64, POINTER(c_int64))),
    # context
    "vbgpd_context_desc_init": (c_int32, (POINTER(vbgpd_context_desc), c_uint32)),
    "vbgpd_context_create": (c_int32, (POINTER(vbgpd_context_desc), POINTER(vbgpd_context))),
    "vbgpd_context_desc_check": (
        c_int32,
        (POINTER(vbgpd_context_desc), POINTER(vbgpd_error_info), POINTER(c_char), c_int64, POINTER(c_int64))),
    "vbgpd_context_destroy": (c_int32, (vbgpd_context,)),
    # log
    "vbgpd_context_log_next": (
        c_int32, (vbgpd_context, c_int64, POINTER(vbgpd_log_line), POINTER(c_char), c_int64, POINTER(c_int64))),
    # the named numbers describe themselves
    "vbgpd_context_set_log": (c_int32, (vbgpd_context, vbgpd_log_fn, c_void_p, c_int32)),
    "vbgpd_property_count": (c_int32, (c_int32, POINTER(c_int64))),
    "vbgpd_property_info_at": (c_int32, (c_int32, c_int64, POINTER(vbgpd_property_info))),
    # slope profile
    "vbgpd_profile_create": (c_int32, (vbgpd_context, POINTER(vbgpd_profile))),
    "vbgpd_profile_create_from_flatbuffer": (c_int32, (vbgpd_context, c_void_p, c_int64, POINTER(vbgpd_profile))),
    "vbgpd_profile_to_flatbuffer": (c_int32, (vbgpd_profile, c_void_p, c_int64, POINTER(c_int64))),
    "vbgpd_profile_destroy": (c_int32, (vbgpd_profile,)),
    "vbgpd_profile_set_exterior": (c_int32, (vbgpd_profile, POINTER(c_double), c_int64, c_int64)),
    "vbgpd_profile_add_material": (c_int32, (vbgpd_profile, c_char_p, c_int64, POINTER(c_int64))),
    "vbgpd_profile_add_layer": (
        c_int32, (vbgpd_profile, POINTER(c_double), c_int64, c_int64, c_int64, POINTER(c_int64))),
    "vbgpd_profile_add_boundary": (
        c_int32, (vbgpd_profile, c_char_p, c_int64, POINTER(c_double), c_int64, c_int64, c_int32, POINTER(c_int64))),
    "vbgpd_profile_add_load": (c_int32, (vbgpd_profile, c_double, c_double, c_double, c_double, POINTER(c_int64))),
    "vbgpd_profile_set_water_table": (c_int32, (vbgpd_profile, POINTER(c_double), c_int64, c_int64)),
    "vbgpd_profile_water_table": (c_int32, (vbgpd_profile, POINTER(c_double), c_int64, c_int64, POINTER(c_int64))),
    "vbgpd_profile_set_f64": (c_int32, (vbgpd_profile, c_int32, c_int64, c_char_p, c_int64, c_double)),
    "vbgpd_profile_get_f64": (c_int32, (vbgpd_profile, c_int32, c_int64, c_char_p, c_int64, POINTER(c_double))),
    "vbgpd_profile_set_text": (c_int32, (vbgpd_profile, c_int32, c_int64, c_char_p, c_int64, c_char_p, c_int64)),
    "vbgpd_profile_get_text": (
        c_int32, (vbgpd_profile, c_int32, c_int64, c_char_p, c_int64, POINTER(c_char), c_int64, POINTER(c_int64))),
    "vbgpd_profile_count": (c_int32, (vbgpd_profile, c_int32, POINTER(c_int64))),
    "vbgpd_profile_polygon": (
        c_int32, (vbgpd_profile, c_int32, c_int64, POINTER(c_double), c_int64, c_int64, POINTER(c_int64))),
    "vbgpd_profile_validate": (c_int32, (vbgpd_profile, POINTER(c_int64), POINTER(c_int64))),
    "vbgpd_profile_issue": (
        c_int32, (vbgpd_profile, c_int64, POINTER(vbgpd_error_info), POINTER(c_char), c_int64, POINTER(c_int64))),
    # model
    "vbgpd_model_create": (c_int32, (vbgpd_context, vbgpd_profile, POINTER(vbgpd_model))),
    "vbgpd_model_destroy": (c_int32, (vbgpd_model,)),
    "vbgpd_model_set_f64": (c_int32, (vbgpd_model, c_char_p, c_int64, c_double)),
    "vbgpd_model_get_f64": (c_int32, (vbgpd_model, c_char_p, c_int64, POINTER(c_double))),
    "vbgpd_model_plan": (c_int32, (vbgpd_model, c_int64, POINTER(vbgpd_feature))),
    "vbgpd_model_memory": (c_int32, (vbgpd_model, POINTER(vbgpd_memory))),
    "vbgpd_model_step": (c_int32, (vbgpd_model, c_int64, POINTER(vbgpd_advance_result))),
    "vbgpd_model_cancel": (c_int32, (vbgpd_model,)),
    "vbgpd_model_advance_to": (
        c_int32, (vbgpd_model, c_double, c_double, vbgpd_progress_fn, c_void_p, POINTER(vbgpd_advance_result))),
    "vbgpd_model_epoch": (c_int32, (vbgpd_model, POINTER(c_int64))),
    # save and restore
    "vbgpd_model_save_state": (c_int32, (vbgpd_model, POINTER(vbgpd_state))),
    "vbgpd_model_restore_state": (c_int32, (vbgpd_model, vbgpd_state)),
    "vbgpd_state_destroy": (c_int32, (vbgpd_state,)),
    "vbgpd_model_checkpoint": (c_int32, (vbgpd_model, c_void_p, c_int64, POINTER(c_int64))),
    "vbgpd_model_create_from_checkpoint": (c_int32, (vbgpd_context, c_void_p, c_int64, POINTER(vbgpd_model))),
    "vbgpd_model_restore_checkpoint": (c_int32, (vbgpd_model, c_void_p, c_int64)),
    "vbgpd_model_snapshot": (c_int32, (vbgpd_model, c_void_p, c_int64, POINTER(c_int64))),
    # run-out
    "vbgpd_model_create_runout": (c_int32, (vbgpd_model, POINTER(vbgpd_model))),
    "vbgpd_job_create_runout": (c_int32, (vbgpd_model, POINTER(vbgpd_job))),
    # jobs: long analyses in slices
    "vbgpd_job_create_equilibrium": (c_int32, (vbgpd_model, POINTER(vbgpd_job))),
    "vbgpd_job_create_strength_reduction": (c_int32, (vbgpd_model, POINTER(vbgpd_job))),
    "vbgpd_job_set_f64": (c_int32, (vbgpd_job, c_char_p, c_int64, c_double)),
    "vbgpd_job_run": (c_int32, (vbgpd_job, c_double, vbgpd_progress_fn, c_void_p, POINTER(vbgpd_progress))),
    "vbgpd_job_cancel": (c_int32, (vbgpd_job,)),
    "vbgpd_job_get_f64": (c_int32, (vbgpd_job, c_char_p, c_int64, POINTER(c_double))),
    "vbgpd_job_get_text": (c_int32, (vbgpd_job, c_char_p, c_int64, POINTER(c_char), c_int64, POINTER(c_int64))),
    "vbgpd_job_trial": (c_int32, (vbgpd_job, c_int64, POINTER(vbgpd_trial))),
    "vbgpd_job_level": (c_int32, (vbgpd_job, c_int64, POINTER(vbgpd_level))),
    "vbgpd_job_slip_surface": (c_int32, (vbgpd_job, POINTER(c_double), c_int64, c_int64, POINTER(c_int64))),
    "vbgpd_job_destroy": (c_int32, (vbgpd_job,)),
    # reading fields
    "vbgpd_field_count": (c_int32, (POINTER(c_int64),)),
    "vbgpd_field_info_at": (c_int32, (c_int64, POINTER(vbgpd_field_info))),
    "vbgpd_field_find": (c_int32, (c_char_p, c_int64, POINTER(c_int32))),
    "vbgpd_model_item_count": (c_int32, (vbgpd_model, c_int32, POINTER(c_int64))),
    "vbgpd_model_read_f64": (
        c_int32, (vbgpd_model, c_int32, POINTER(c_double), c_int64, c_int64, c_int64, POINTER(c_int64))),
    "vbgpd_model_read_i64": (
        c_int32, (vbgpd_model, c_int32, POINTER(c_int64), c_int64, c_int64, c_int64, POINTER(c_int64))),
    "vbgpd_model_select": (
        c_int32, (vbgpd_model, POINTER(vbgpd_selection), POINTER(c_int64), c_int64, c_int64, POINTER(c_int64))),
    "vbgpd_model_read_selected_f64": (
        c_int32, (vbgpd_model, c_int32, POINTER(vbgpd_selection), POINTER(c_double), c_int64, c_int64, c_int64,
         POINTER(c_int64))),
    "vbgpd_model_read_selected_i64": (
        c_int32, (vbgpd_model, c_int32, POINTER(vbgpd_selection), POINTER(c_int64), c_int64, c_int64, c_int64,
         POINTER(c_int64))),
    "vbgpd_model_sample_points": (
        c_int32, (vbgpd_model, c_int32, POINTER(c_double), c_int64, c_int64, POINTER(c_double), c_int64, c_int64,
         POINTER(c_int64), c_int64)),
    "vbgpd_model_sample_line": (
        c_int32, (vbgpd_model, c_int32, c_double, c_double, c_double, c_double, c_int64, POINTER(c_double), c_int64,
         c_int64, POINTER(c_int64), c_int64)),
    "vbgpd_model_sample_grid": (
        c_int32, (vbgpd_model, c_int32, c_double, c_double, c_double, c_double, c_int64, c_int64, POINTER(c_double),
         c_int64, c_int64, POINTER(c_int64), c_int64)),
    "vbgpd_model_ground_surface": (c_int32, (vbgpd_model, POINTER(c_double), c_int64, c_int64, POINTER(c_int64))),
    "vbgpd_model_view_acquire": (c_int32, (vbgpd_model, c_int32, POINTER(vbgpd_view))),
    "vbgpd_model_view_release": (c_int32, (vbgpd_model, c_int64)),
    "vbgpd_model_state_hash": (c_int32, (vbgpd_model, POINTER(c_uint64))),
    # events
    "vbgpd_model_events_read": (
        c_int32, (vbgpd_model, c_int64, POINTER(vbgpd_event), c_int64, c_int64, POINTER(c_int64), POINTER(c_int64))),
    # setting from outside: stays until set again
    "vbgpd_model_write_f64": (
        c_int32, (vbgpd_model, c_int32, POINTER(vbgpd_selection), POINTER(c_double), c_int64, c_int64, c_int64)),
    "vbgpd_model_write_points": (
        c_int32, (vbgpd_model, c_int32, POINTER(c_double), c_int64, POINTER(c_double), c_int64, c_int64, c_int64)),
    "vbgpd_model_write_grid": (
        c_int32, (vbgpd_model, c_int32, c_double, c_double, c_double, c_double, c_int64, c_int64, POINTER(c_double),
         c_int64)),
    "vbgpd_model_set_load": (c_int32, (vbgpd_model, c_int64, c_double, c_double)),
    "vbgpd_model_set_boundary_velocity": (c_int32, (vbgpd_model, c_int64, c_double, c_double)),
    "vbgpd_model_set_layer_active": (c_int32, (vbgpd_model, c_int64, c_int32)),
    "vbgpd_model_boundary_reaction": (c_int32, (vbgpd_model, c_int64, POINTER(c_double), POINTER(c_double))),
}


def declare(library):
    """Gives every function of a loaded library its result and parameter types; AttributeError names a missing one."""
    for name, (result, parameters) in FUNCTIONS.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = parameters
    return library
