/* vbgpd.h - C ABI of the VB-GPD engine (virtual-bond general particle dynamics for soil slopes).
 * C99 and C++11; no compiler extension is needed to read it. This header is the manual.
 *
 * Rules that hold for every function, so they are not repeated below
 *  R1  returns vbgpd_status: 0 = done, >0 = done with a named outcome, <0 = failed, nothing changed.
 *  R2  never throws, exits, aborts, prints, reads the environment or the locale, installs a signal handler;
 *      enters with the default floating-point environment and puts the caller's back.
 *  R3  NULL, foreign or destroyed handles give VBGPD_E_HANDLE; they do not crash. Destroying NULL is VBGPD_OK.
 *  R4  an object may be used by any thread, by one thread at a time; overlap gives VBGPD_E_BUSY.
 *      Different models may run at once. Only functions marked [any-thread] may overlap another call.
 *  R5  callbacks run only on the thread that is inside the call, never after the call returned, and may not
 *      call back into the same object (VBGPD_E_REENTRANT). All callbacks have a polling equivalent.
 *  R6  a child object keeps what it needs of its parent: handles may be destroyed in any order (GC languages).
 *  R7  strings are UTF-8, passed as (pointer, length); length -1 = NUL-terminated. Text comes back in a buffer
 *      of the caller: (buf, cap, *needed); needed excludes the NUL; cap 0 asks for the size only. A buffer too
 *      small for the text and its NUL gives VBGPD_E_BUFFER. needed may be NULL.
 *  R8  sizes, counts and ids are int64_t; ids count from 0; angles in degrees, all else SI (m, kg, s, Pa, N);
 *      2-D plane strain, 1 m thick, x right, y up; stress positive in tension.
 *  R9  structs begin with struct_size = sizeof the caller's struct; fields are only ever appended; a shorter
 *      struct is filled as far as it goes, a longer one too. Fill with the matching _init first where there is one.
 *      No enum, bool, long, size_t, bit-field, union or by-value struct crosses the ABI.
 *
 * Life cycle: context -> profile (edit, validate) -> model (particles and bonds) -> job (equilibrium or strength
 * reduction, in slices) or step by step -> fields and results -> destroy, in any order.
 */
/* clang-format off: one declaration, one line */
#ifndef VBGPD_H
#define VBGPD_H
#include <stdint.h>
#if defined(_WIN32)
#define VBGPD_CALL __cdecl
#if defined(VBGPD_BUILD)
#define VBGPD_API __declspec(dllexport)
#elif defined(VBGPD_STATIC)
#define VBGPD_API
#else
#define VBGPD_API __declspec(dllimport)
#endif
#else
#define VBGPD_CALL
#define VBGPD_API __attribute__((visibility("default")))
#endif
#ifdef __cplusplus
extern "C" {
#endif

/* ---- version ------------------------------------------------------------------------------------------- */
#define VBGPD_VERSION_NUMBER 1000000 /* major*1000000 + minor*1000 + patch */
#define VBGPD_ABI_VERSION 1          /* = soname libvbgpd.so.1; changes only when R9 is broken */
#define VBGPD_STRLEN ((int64_t)-1)   /* as a length: the text ends at its NUL */
VBGPD_API int32_t VBGPD_CALL vbgpd_version_number(void);      /* [any-thread] of the library, not of this header */
VBGPD_API int32_t VBGPD_CALL vbgpd_abi_version(void);         /* [any-thread] */
VBGPD_API const char* VBGPD_CALL vbgpd_version_string(void);  /* [any-thread] static text, "1.0.0" */

/* ---- status -------------------------------------------------------------------------------------------- */
typedef int32_t vbgpd_status;
#define VBGPD_OK 0
#define VBGPD_CANCELLED 1     /* stopped on request at a step boundary; can be continued */
#define VBGPD_LIMIT_REACHED 2 /* end of this wall-clock slice; call again to go on */
#define VBGPD_NOT_CONVERGED 3 /* the job ended without the answer asked for; its "reason" says why */
#define VBGPD_UNSTABLE 4      /* equilibrium job: a mechanism formed, the slope moves */
#define VBGPD_END_OF_DATA 5   /* index past the last item */
#define VBGPD_E_ARGUMENT -1
#define VBGPD_E_HANDLE -2
#define VBGPD_E_MEMORY -3
#define VBGPD_E_LIMIT -4 /* max_particles or max_bytes of the context */
#define VBGPD_E_BUSY -5  /* another thread is inside this object */
#define VBGPD_E_LEASED -6 /* a view of this model is still held: release it first */
#define VBGPD_E_REENTRANT -7
#define VBGPD_E_STATE -8    /* not allowed in this phase */
#define VBGPD_E_GEOMETRY -9 /* profile not simple, layer outside ...; see the error record and the issues */
#define VBGPD_E_UNKNOWN_NAME -10
#define VBGPD_E_RANGE -11
#define VBGPD_E_BUFFER -12 /* caller's buffer too small; *needed is set */
#define VBGPD_E_FORMAT -13 /* flatbuffer refused by the verifier */
#define VBGPD_E_VERSION -14
#define VBGPD_E_DIVERGED -15 /* NaN/Inf or runaway step; the model is back at a good step before it (see vbgpd_model_step) and readable */
#define VBGPD_E_UNSUPPORTED -17
#define VBGPD_E_INTERNAL -99
VBGPD_API const char* VBGPD_CALL vbgpd_status_name(vbgpd_status s); /* [any-thread] static text, "VBGPD_E_RANGE" */
/* version, abi_version, compiler, build_type, cgal, flatbuffers (yes, no), instruction_sets (built, best first), instruction_set (used
 * here), instruction_set_runout, cores, checkpoint_format, snapshot_format; key_len 0 = all, lines of "key = value". [any-thread] */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_build_info(const char* key, int64_t key_len, char* buf, int64_t cap, int64_t* needed);

typedef struct vbgpd_context vbgpd_context; /* threads, limits; cheap; no process globals */
typedef struct vbgpd_profile vbgpd_profile; /* slope profile: polygons, materials, loads, supports */
typedef struct vbgpd_model vbgpd_model;     /* particles and virtual bonds, at a time */
typedef struct vbgpd_job vbgpd_job;         /* equilibrium or strength reduction, advanced in slices */
typedef struct vbgpd_state vbgpd_state;     /* a saved instant of a model, in memory */

#define VBGPD_OBJECT_CONTEXT 1
#define VBGPD_OBJECT_PROFILE 2
#define VBGPD_OBJECT_MATERIAL 3
#define VBGPD_OBJECT_LAYER 4
#define VBGPD_OBJECT_LOAD 5
#define VBGPD_OBJECT_BOUNDARY 6
#define VBGPD_OBJECT_MODEL 7
#define VBGPD_OBJECT_JOB 8
#define VBGPD_OBJECT_STATE 9

/* What went wrong, where: for a program to highlight. The text is a whole sentence for a person. */
typedef struct vbgpd_error_info {
  uint32_t struct_size;
  int32_t status;      /* VBGPD_E_*; 0 in an issue that is only a warning */
  int32_t object_kind; /* VBGPD_OBJECT_*, 0 = none */
  int32_t argument;    /* 1-based number of the offending argument, 0 = none */
  int64_t object_id;   /* e.g. layer id, -1 = none */
  int64_t item;        /* e.g. vertex index, -1 = none */
  double x, y, value;  /* where, and the offending value; NaN = none */
} vbgpd_error_info;
/* The last failure of a call ON THIS OBJECT (not per thread); kept until the next failing call on it.
 * Without a failure so far: VBGPD_END_OF_DATA. info and text may be NULL. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_context_error(const vbgpd_context*, vbgpd_error_info* info, char* text, int64_t cap, int64_t* needed);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_error(const vbgpd_profile*, vbgpd_error_info* info, char* text, int64_t cap, int64_t* needed);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_error(const vbgpd_model*, vbgpd_error_info* info, char* text, int64_t cap, int64_t* needed);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_error(const vbgpd_job*, vbgpd_error_info* info, char* text, int64_t cap, int64_t* needed);

/* ---- context ------------------------------------------------------------------------------------------- */
/* Memory from the host: all arrays and lists over particles and bonds of the models of a context and of their states, 9 bytes in
 * 10 of a model and more; lattice cells, names, jobs, texts and what lives inside one call only come from the C++ library.
 * bytes > 0, alignment a power of 2 up to 64, to be honoured; free gets both again. alloc NULL: out of memory (VBGPD_E_MEMORY,
 * nothing changed). R5 holds, _destroy calls included; they must not throw, and stay good until the last model and state of
 * the context are destroyed. Host threads that work with different objects of the context call them at the same time. */
typedef void*(VBGPD_CALL* vbgpd_alloc_fn)(void* user, int64_t bytes, int64_t alignment);
typedef void(VBGPD_CALL* vbgpd_free_fn)(void* user, void* p, int64_t bytes, int64_t alignment);
typedef struct vbgpd_context_desc {
  uint32_t struct_size;
  int32_t abi_version;   /* VBGPD_ABI_VERSION the caller was built with; another one gives VBGPD_E_VERSION */
  int32_t threads;       /* workers per model, up to 1024; 0 = all cores, 1 = none (default). Results do not depend on it; where
                          * the system gives fewer, those do the work */
  int32_t reserved;      /* 0 */
  int64_t max_particles; /* of a model, walls included; beyond it VBGPD_E_LIMIT, a spacing that fits in the text; 0 = no limit (default) */
  int64_t max_bytes;     /* a model predicted to have more once it was stepped, relaxed and read (saved states not counted), or a run-out
                          * that has more: VBGPD_E_LIMIT, a spacing that would fit in the text; 0 = no limit (default) */
  vbgpd_alloc_fn alloc;  /* both or none; NULL (default): those of the C++ library */
  vbgpd_free_fn free;
  void* alloc_user;
} vbgpd_context_desc;
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_context_desc_init(vbgpd_context_desc* d, uint32_t struct_size);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_context_create(const vbgpd_context_desc* d, vbgpd_context** out); /* d NULL = defaults */
/* Why vbgpd_context_create refuses a description, all its faults in one text: there is no object yet that could tell. Answers like
 * vbgpd_context_error; VBGPD_END_OF_DATA: it does not. [any-thread] */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_context_desc_check(const vbgpd_context_desc* d, vbgpd_error_info* info, char* text, int64_t cap, int64_t* needed);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_context_destroy(vbgpd_context*);

/* ---- log: what the engine has to say; it never prints ------------------------------------------------------ */
/* A context keeps the last 256 lines of its models and their jobs, to be polled. Failures of calls are in the error records. */
#define VBGPD_LOG_WARNING 1 /* an answer may be worth less than it looks: warnings of the profile, undecided trials, jobs not OK */
#define VBGPD_LOG_INFO 2    /* models, grids, ends of jobs */
#define VBGPD_LOG_DETAIL 3  /* phases and trials of jobs */
typedef struct vbgpd_log_line {
  uint32_t struct_size;
  int32_t level;    /* VBGPD_LOG_* */
  int64_t sequence; /* counts from 1; a gap between two lines: those are kept no longer */
  double seconds;   /* since the context was created */
} vbgpd_log_line;
/* The oldest line kept with a sequence above after (0 = of all); VBGPD_END_OF_DATA when there is none. Reading takes nothing away.
 * line and text may be NULL. No text is longer than 247 bytes, so that 248 always hold one and its NUL. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_context_log_next(vbgpd_context*, int64_t after, vbgpd_log_line* line, char* text, int64_t cap, int64_t* needed);
/* The same lines as they are said, of level and below (1 to VBGPD_LOG_DETAIL; another one gives VBGPD_E_RANGE): fn is called within
 * the call that says them, on its thread, in the default floating-point environment, one line at a time; text ends with a NUL
 * and, as line, lasts as long as fn. R5 holds; what fn throws is dropped. A line said by what fn itself calls is only kept.
 * fn NULL (level is not read then), or destroying the context, ends it. VBGPD_E_BUSY: fn is running on another thread; VBGPD_E_REENTRANT: on this one. */
typedef void(VBGPD_CALL* vbgpd_log_fn)(void* user, const vbgpd_log_line* line, const char* text);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_context_set_log(vbgpd_context*, vbgpd_log_fn fn, void* user, int32_t level);

/* ---- the named numbers describe themselves ---------------------------------------------------------------- */
typedef struct vbgpd_property_info {
  uint32_t struct_size;
  int32_t required;                                /* 1 = has no default and must be set */
  const char *name, *unit, *doc;                   /* static text: "cohesion", "Pa" (UDUNITS), one sentence */
  double default_value, min_value, max_value;      /* default NaN = absent */
  int32_t min_open, max_open;                      /* 1 = the end itself is not allowed */
} vbgpd_property_info;
/* object_kind: VBGPD_OBJECT_PROFILE (spacing, gravity, kh, kv, smoothing_ratio, jitter, srf_min, srf_max, srf_tolerance),
 * MATERIAL, LOAD, BOUNDARY, MODEL, JOB */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_property_count(int32_t object_kind, int64_t* n);                    /* [any-thread] */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_property_info_at(int32_t object_kind, int64_t i, vbgpd_property_info* info); /* [any-thread] */

/* ---- slope profile --------------------------------------------------------------------------------------- */
/* xy arrays: n points, x at p + i*stride bytes, y 8 bytes behind it; stride 16 = packed pairs. Any winding, either slope
 * direction, map-sized coordinates. Contents are copied. Values are checked as a whole by _validate and _model_create. */
#define VBGPD_BOUNDARY_FREE 0
#define VBGPD_BOUNDARY_FIXED 1    /* in a run-out rough, or with a "friction_angle" Coulomb friction */
#define VBGPD_BOUNDARY_ROLLER 2   /* slides along itself, does not move across */
#define VBGPD_BOUNDARY_VELOCITY 3 /* moves with the properties "vx", "vy" */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_create(vbgpd_context*, vbgpd_profile** out);
/* A scene from a flatbuffer (schema core/exchange/vbgpd.fbs, file identifier "VBGP"); bytes are verified and copied. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_create_from_flatbuffer(vbgpd_context*, const void* bytes, int64_t len, vbgpd_profile** out);
/* The profile as such a flatbuffer; cap and *needed count bytes, cap 0 asks for the size, too small gives VBGPD_E_BUFFER. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_to_flatbuffer(const vbgpd_profile*, void* buf, int64_t cap, int64_t* needed);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_destroy(vbgpd_profile*);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_set_exterior(vbgpd_profile*, const double* xy, int64_t stride, int64_t n);
/* At most 256 materials (vbgpd_profile_validate says so). */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_add_material(vbgpd_profile*, const char* name, int64_t len, int64_t* material_id);
/* Layers are painted in order; n = 0 (xy NULL) fills the exterior, later polygons overwrite. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_add_layer(vbgpd_profile*, const double* xy, int64_t stride, int64_t n, int64_t material_id, int64_t* layer_id);
/* A held part of the outline. side "base", "left" or "right" with n = 0, or side NULL and a polyline along the exterior.
 * A profile without any boundary has three in its model: 0 a fixed base, 1 a roller left, 2 a roller right. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_add_boundary(vbgpd_profile*, const char* side, int64_t side_len, const double* xy, int64_t stride, int64_t n, int32_t kind, int64_t* boundary_id);
/* Vertical pressure (Pa, down positive) on the ground surface from x0 to x1, linear from pressure to pressure_end. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_add_load(vbgpd_profile*, double x0, double x1, double pressure, double pressure_end, int64_t* load_id);
/* Ground water: hydrostatic below a line from left to right over the whole section (unit weight: PROFILE "water_unit_weight"),
 * weight by MATERIAL "saturated_unit_weight"; where it runs above the ground the water stands there and presses on it. n = 0:
 * dry. A MATERIAL with a "pore_pressure_ratio" (r_u) has that times the weight above it instead. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_set_water_table(vbgpd_profile*, const double* xy, int64_t stride, int64_t n);
/* Its points; rules for cap and n as vbgpd_profile_polygon. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_water_table(const vbgpd_profile*, double* xy, int64_t stride, int64_t cap, int64_t* n);
/* Named numbers; id is ignored for VBGPD_OBJECT_PROFILE. NaN takes a value back to "absent". */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_set_f64(vbgpd_profile*, int32_t object_kind, int64_t id, const char* name, int64_t len, double value);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_get_f64(const vbgpd_profile*, int32_t object_kind, int64_t id, const char* name, int64_t len, double* value);
/* Named texts: PROFILE "name", "source", "bond" (virtual_bond | none; run-outs also sph | sph_artificial_stress | pseudo_spring | gpd), "kernel" (wendland_c2 | cubic_spline);
 * MATERIAL "name", "law" (elastic | drucker_prager | mohr_coulomb | undrained); LAYER "material"; BOUNDARY "name", "side", "kind" (free | fixed | roller | velocity). */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_set_text(vbgpd_profile*, int32_t object_kind, int64_t id, const char* name, int64_t len, const char* value, int64_t value_len);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_get_text(const vbgpd_profile*, int32_t object_kind, int64_t id, const char* name, int64_t len, char* buf, int64_t cap, int64_t* needed);
/* How many materials, layers, loads, boundaries (PROFILE: 1). */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_count(const vbgpd_profile*, int32_t object_kind, int64_t* n);
/* Vertices of the exterior (PROFILE), of a LAYER, of a BOUNDARY polyline; *n is always the full count; cap counts points;
 * cap 0 asks for the count only, a cap too small gives VBGPD_E_BUFFER. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_polygon(const vbgpd_profile*, int32_t object_kind, int64_t id, double* xy, int64_t stride, int64_t cap, int64_t* n);
/* Finds every fault, not the first: *errors of them forbid a model, *warnings do not. Errors do not make the call fail. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_validate(vbgpd_profile*, int64_t* errors, int64_t* warnings);
/* Issue i of the last _validate, errors and warnings in the order found; VBGPD_END_OF_DATA past the last. Its text speaks
 * in the units of the flatbuffer that the profile came from (kPa), info's value like all numbers here in SI. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_profile_issue(const vbgpd_profile*, int64_t i, vbgpd_error_info* info, char* text, int64_t cap, int64_t* needed);

/* ---- model ------------------------------------------------------------------------------------------------ */
/* Validates, cuts the lattice, bonds the particles; the profile may be changed or destroyed afterwards.
 * An invalid profile gives the status of its first error; the context's error record has all errors in its text. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_create(vbgpd_context*, const vbgpd_profile*, vbgpd_model** out);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_destroy(vbgpd_model*);
/* "damping" (local damping coefficient of dynamic steps, [0, 1), default 0), "strength_reduction_factor" (default 1),
 * "time_step_factor" (time step of dynamic steps over the stable one, default 0.68; above 1 they diverge; not of a run-out),
 * "kh", "kv" (pseudo-static coefficients, (-1, 1) as in a profile and at first those; weight acts times 1 + kv). May be set between
 * any two steps; VBGPD_E_RANGE, VBGPD_E_UNKNOWN_NAME, VBGPD_E_STATE (cannot be set). */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_set_f64(vbgpd_model*, const char* name, int64_t len, double value);
/* the above and: time, steps, stable_time_step, time_step, unbalanced_force_ratio, max_displacement, max_velocity,
 * displacement_level (E u_max / gamma H^2), total_mass, area, height, spacing_x, spacing_y, particles, bonds, plastic_bonds,
 * bytes, and the energy ledger of dynamic steps: kinetic_energy, elastic_energy, plastic_dissipation, damping_dissipation,
 * external_work, energy_residual (relative to the largest of them; what jobs relax is not booked: after one, 0 until the next
 * step, and the elastic energy counts from there; NaN while walls are moved, whose work is not booked, and where a
 * sum is no number); and estimates of a factor of safety on this grid, from
 * steps that are run when asked and taken back: forecast_step_seconds (measured), forecast_steps, forecast_seconds, forecast_bytes
 * (like a call that changes the model: VBGPD_E_LEASED, VBGPD_E_STATE while a job is under way; a run-out: VBGPD_E_UNSUPPORTED) */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_get_f64(const vbgpd_model*, const char* name, int64_t len, double* value);
/* What the model uses of everything the engine can do. A feature left out has no bytes and costs no time. Some begin to be used
 * (relaxation by the first job, dynamic steps by the first _step, copies for fields by the first reading). */
typedef struct vbgpd_feature {
  uint32_t struct_size;
  int32_t used;              /* 1 used, 0 left out */
  const char *name, *doc;    /* static text */
  int64_t bytes;             /* allocated now; all features together are the model's "bytes" */
  double bytes_per_particle; /* its arrays over the particles, per particle */
  double bytes_per_bond;     /* its arrays over the bonds, per bond; 0 without bonds */
} vbgpd_feature;
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_plan(const vbgpd_model*, int64_t i, vbgpd_feature* f); /* END_OF_DATA past the last */
typedef struct vbgpd_memory { /* the same bytes by what they are for */
  uint32_t struct_size;
  int32_t reserved;
  int64_t bytes;   /* the model's "bytes": the sum of the five that follow */
  int64_t model;   /* geometry, neighbours, operators, masses: never changes */
  int64_t state;   /* what changes: displacements, velocities, plastic strains */
  int64_t scratch; /* what a step writes before it reads it */
  int64_t copies;  /* of the state, for fields, monitors, views and the audit of energy */
  int64_t outside; /* forces and pore pressures written by the host */
  int64_t saved;   /* not in bytes: states saved from this model that are alive, those of its jobs included */
} vbgpd_memory;
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_memory(const vbgpd_model*, vbgpd_memory* m);

typedef struct vbgpd_progress {
  uint32_t struct_size;
  int32_t level;                    /* which grid, 0 = coarsest */
  int32_t trial;                    /* which strength reduction factor, from 0 */
  int32_t phase;                    /* 1 gravity, 2 search, 3 stable end, 4 failed end, 5 slip surface, 6 run-out */
  int64_t steps;                    /* since the job began, all grids */
  double fraction;                  /* estimate of the work done, [0, 1] */
  double strength_reduction_factor; /* of the trial now running */
  double srf_stable, srf_unstable;  /* bracket so far on this grid, NaN = not yet */
  double unbalanced_force_ratio, max_displacement;
} vbgpd_progress;
typedef int32_t(VBGPD_CALL* vbgpd_progress_fn)(void* user, const vbgpd_progress*); /* 0 = go on, else stop: VBGPD_CANCELLED */

typedef struct vbgpd_advance_result {
  uint32_t struct_size;
  int32_t reserved;
  int64_t steps;                /* done in this call */
  double time, time_step;       /* s */
  double kinetic_energy;        /* J per metre run */
  double unbalanced_force_ratio, max_displacement, max_velocity; /* the first by the forces of the last step */
  int64_t plastic_bonds;
} vbgpd_advance_result;
/* Explicit dynamic steps with true masses at the stable time step. r may be NULL.
 * VBGPD_E_DIVERGED: a particle outran the waves, or energy came out of nothing (5 % of what the motion holds or turned over; looked
 * at every 512 steps, not where walls are moved); the model is back at a good step and readable: at most 64 steps before (a run-out
 * 256), or at the last look at the energy, which may be before this call. What the host wrote before that step stays written,
 * mad velocities too: write sound ones or restore a state. VBGPD_CANCELLED: between two steps. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_step(vbgpd_model*, int64_t steps, vbgpd_advance_result* r);
/* Stops a _step or _advance_to between two steps. The request stands until one has obeyed it: without one under way it stops the next
 * before its first step. vbgpd_job_cancel does the same to _run, this one does not. [any-thread] [signal-safe] */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_cancel(vbgpd_model*);
/* Dynamic steps of equal length, none longer than the stable one, that end exactly at time (s); VBGPD_OK = there.
 * VBGPD_LIMIT_REACHED: wall_seconds (<= 0: no limit) are over; VBGPD_CANCELLED: by vbgpd_model_cancel or fn; call again
 * with the same time to go on, the result is that of an uninterrupted run, bit by bit. fn (may be NULL) is called at most
 * about ten times a second; in its progress level, trial and phase are 0. r may be NULL.
 * VBGPD_E_RANGE: the model is already past time. VBGPD_E_DIVERGED as _step. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_advance_to(vbgpd_model*, double time, double wall_seconds, vbgpd_progress_fn fn, void* user, vbgpd_advance_result* r);
/* Grows whenever particles are added, removed or stored in another order: storage order of another epoch is void. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_epoch(const vbgpd_model*, int64_t* epoch);

/* Calls that change a model give VBGPD_E_LEASED while a view of it is held, and VBGPD_E_STATE while one of its jobs has
 * begun and not ended: the job counts on what it found. Finish or destroy the job first. */

/* ---- save and restore ------------------------------------------------------------------------------------- */
/* A saved instant: displacements, velocities, plastic strains, time, forces, pressures and loads from outside. In memory,
 * for trying a step and taking it back (implicit coupling). _save_state fills *inout, or makes a new state where that is
 * NULL; it costs one copy of the state. A state fits only the model it was saved from: others give VBGPD_E_ARGUMENT. It
 * may outlive the model. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_save_state(const vbgpd_model*, vbgpd_state** inout);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_restore_state(vbgpd_model*, const vbgpd_state*);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_state_destroy(vbgpd_state*);
/* The model with its profile as bytes for a file or another process: a flatbuffer (core/exchange/checkpoint.fbs, file
 * identifier "VBGC"). cap and *needed count bytes; cap 0 asks for the size, too small gives VBGPD_E_BUFFER. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_checkpoint(const vbgpd_model*, void* buf, int64_t cap, int64_t* needed);
/* A model from such bytes, in this process or another one, with the threads and limits of the context. It goes on as the
 * old one would have: with the same build on a processor of the same kind bit by bit, at any thread count. Bytes are
 * verified, checked against all ranges and copied before anything is built: VBGPD_E_FORMAT; a newer format, or a
 * run-out in an older one, gives VBGPD_E_VERSION. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_create_from_checkpoint(vbgpd_context*, const void* bytes, int64_t len, vbgpd_model** out);
/* Takes a model of the same profile back to a checkpoint. VBGPD_E_FORMAT, the first difference in the text, when it is of another
 * one: exterior, layers, materials (laws and every number), boundaries, places of loads, water, gravity, bond, kernel, smoothing,
 * jitter and grid are compared. Names are not, nor the search range, nor what can be set on a model: the checkpoint brings that. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_restore_checkpoint(vbgpd_model*, const void* bytes, int64_t len);
/* What can be seen of the model, for other programs: a flatbuffer (core/exchange/snapshot.fbs, file identifier "VBGS") with positions,
 * displacements, velocities, stresses ... by particle id; buf as _checkpoint. VBGPD_E_UNSUPPORTED in a build without flatbuffers. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_snapshot(const vbgpd_model*, void* buf, int64_t cap, int64_t* needed);

/* ---- run-out: large motion, from the first plastic bonds to rest ------------------------------------------------ */
/* A new model that goes on from the present state of `from` (positions, stresses, plastic strain, strength reduction factor;
 * at rest) in updated-Lagrangian form: bonds come and go with the neighbours, walls are mirrors that go on straight beyond
 * the section where nothing adjoins. `from` may be fresh, loaded by an equilibrium job, or failed by a strength reduction; it
 * is not changed. The new model has soil only (same ids unless layers are off) and is stepped, set, read, saved like any other; loads stay on their
 * particles (those on top), pore pressures move with them (where soil has come apart less K times the gap); a material without "tension_cutoff" bears no tension, where strength
 * reduction lets it bear that of the cone's apex. get_f64 also knows peak_kinetic_energy, standing_time (s for which no
 * particle went farther by a thousandth of a spacing), viscous_dissipation, contact_work, yielding_area, viscosity (alpha c h, m2/s),
 * neighbour_searches. VBGPD_E_STATE: `from` is one already; UNSUPPORTED: moving boundaries, standing
 * water, kernel "cubic_spline". */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_create_runout(const vbgpd_model* from, vbgpd_model** out);
/* Works on a run-out model. A model without stress is first brought to equilibrium under gravity without strengths (phase 1);
 * then it moves (phase 6) until its kinetic energy is below 1e-6 of its peak, until it is plain that the slope stands, or to the
 * job's "end_time" (s of the model's time; 0 = to rest, NOT_CONVERGED after 200 times the fall time sqrt(H/g)). Afterwards another job goes on with the same model. Results: status
 * AT_REST or TIME_REACHED, crest_settlement (of the highest ground, from the undeformed section on), toe_displacement (soil at the foot of the slope on the side
 * where the front went farther), runout_distance (of the connected mass that came from behind that foot and moved a spacing or more: its front, beyond the foot),
 * moved_area (soil that did), plastic_fraction, max_displacement, energy_residual. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_create_runout(vbgpd_model*, vbgpd_job** out);

/* ---- jobs: long analyses in slices ------------------------------------------------------------------------- */
/* A job works on the model it was made for; while a slice runs that model answers VBGPD_E_BUSY to other threads and
 * VBGPD_E_REENTRANT to the job's own callback. A strength reduction takes layers, kh, kv, loads, pressures and forces as they
 * are and begins on every grid with soil that has never moved: a second one of the same model gives the same bits; a state worth
 * keeping is saved before. When it has ended the model is left in the failing state of
 * the grid with the profile's spacing, so that its fields show the mechanism; it is the finest one unless a target or a budget
 * went on to finer ones, or ended before it (then the model is as it was). Without a bracket it stands still in the last trial on
 * that grid, or where that diverged as it was. Soils further apart in stiffness than "stiffness_contrast" are searched on a grid of
 * their own: then the model stays as it was until the end, and displacement_level counts the evened stiffness. A job destroyed under way leaves what its last slice left, velocities of the
 * relaxation and the factor of the trial with it: save a state before, or restore one. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_create_equilibrium(vbgpd_model*, vbgpd_job** out);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_create_strength_reduction(vbgpd_model*, vbgpd_job** out);
/* "srf_min", "srf_max", "srf_tolerance" (taken from the profile), "careful" (0 fast search then verification, 1 plain
 * bisection from the gravity state), "step_limit" (per trial, looked at every ten steps). Before the first _run only.
 * Every job takes every option and minds its own: an equilibrium "step_limit", a run-out "end_time", a strength reduction all but that.
 * "stiffness_contrast" (3): soils that yield count as at most so many times as stiff as the softest one, which leaves the factor
 * of safety as it is and saves most of the time; "reason" says where it did. The model then takes over displacements and
 * stresses of the failing state, the strain that differs is the shape its soil was placed in; without a bracket it is as it was.
 * "levels": grids, coarse to fine, 1 to 5, the last with the spacing of the profile; each starts from the factor of the one
 * before. "target_error": ends as soon as error_estimate is that small, brackets are narrowed to a third of it. "budget":
 * wall seconds inside _run; a grid that is predicted to outlast it is not begun, one that does is given up. levels 0 (default)
 * = 2 grids, or with a target or a budget as many as it takes, from twice the spacing on to finer ones than the profile's
 * (1/1.5, 1/2, 1/3 ... 1/32) within max_particles: the profile's spacing is then where it starts. A budget makes the number of
 * grids depend on the machine; each grid is the same everywhere. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_set_f64(vbgpd_job*, const char* name, int64_t len, double value);
/* VBGPD_OK = finished; LIMIT_REACHED or CANCELLED = call again; NOT_CONVERGED, UNSTABLE = finished with that outcome.
 * wall_seconds <= 0: no limit. fn may be NULL; it is called at most about ten times a second. p may be NULL.
 * VBGPD_E_MEMORY: a job under way is over and says so at every further call; the model stands where the job was. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_run(vbgpd_job*, double wall_seconds, vbgpd_progress_fn fn, void* user, vbgpd_progress* p);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_cancel(vbgpd_job*); /* [any-thread] [signal-safe] */
/* After it finished: factor_of_safety, srf_stable, srf_unstable, error_estimate, displacement_level, sliding_area,
 * energy_residual, levels, trials, steps, particles, bonds, wall_seconds, cpu_seconds, observed_order (of three grids),
 * next_level_spacing and next_level_seconds (one more grid, predicted). NaN where it has no value.
 * cpu_seconds is the processor time that the whole process, all its threads, took while the job ran.
 * An equilibrium job: unbalanced_force_ratio, max_displacement, displacement_level, steps, wall_seconds, cpu_seconds. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_get_f64(const vbgpd_job*, const char* name, int64_t len, double* value);
/* "status" (NOT_RUN: not finished; of an equilibrium STABLE, UNSTABLE, NOT_CONVERGED; of a run-out AT_REST, TIME_REACHED,
 * NOT_CONVERGED; of a strength reduction OK, BELOW_MIN, ABOVE_MAX, NOT_CONVERGED, NOT_FIRST_ORDER, NOT_MONOTONIC, THIN_LAYER, THIN_SLIDE, TOO_COARSE, ENERGY_UNBALANCED:
 * the value of the finest grid is given as it is; TARGET_NOT_MET; DIVERGED; REFUSED: a grid could not be made; of any NO_MEMORY, INTERNAL), "reason" (a sentence), "scheme", "reduced" (which strengths), "flow_rule" */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_get_text(const vbgpd_job*, const char* name, int64_t len, char* buf, int64_t cap, int64_t* needed);

/* One strength reduction factor that was tried, with its evidence. */
#define VBGPD_VERDICT_UNDECIDED 0
#define VBGPD_VERDICT_STABLE 1
#define VBGPD_VERDICT_FAILED 2
typedef struct vbgpd_trial {
  uint32_t struct_size;
  int32_t level;                    /* which grid, 0 = coarsest */
  int32_t verdict;                  /* VBGPD_VERDICT_* */
  int32_t band_connected;           /* 1: yielding bonds join two places of the outline of the soil */
  double strength_reduction_factor;
  double unbalanced_force_ratio;    /* at the end: sum |f| / sum m g */
  double unbalanced_force_slope;    /* change of its logarithm over the last look; about 0 = plateau */
  double displacement_level;        /* E u_max / gamma H^2 at the end */
  double displacement_growth;       /* growth of u_max over the last look, relative to the elastic u_max */
  double power_ratio;               /* internal / gravity power times F: the F this flow would just balance; NaN = at rest */
  int64_t steps;
  double wall_seconds;
} vbgpd_trial;
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_trial(const vbgpd_job*, int64_t i, vbgpd_trial* t); /* END_OF_DATA past the last */
typedef struct vbgpd_level {
  uint32_t struct_size;
  int32_t reserved;
  double spacing_x, spacing_y;
  int64_t particles, bonds, steps, trials;
  double srf_stable, srf_unstable, factor_of_safety; /* of this grid alone */
  double wall_seconds, cpu_seconds;                  /* the latter of the whole process, as that of the job */
  double estimate, error_estimate;                   /* from this grid and the coarser ones */
  double sliding_area;                               /* of the mechanism on this grid, m2 */
} vbgpd_level;
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_level(const vbgpd_job*, int64_t i, vbgpd_level* l);
/* The critical slip surface from entry to exit, left to right; rules for cap and n as vbgpd_profile_polygon. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_slip_surface(const vbgpd_job*, double* xy, int64_t stride, int64_t cap, int64_t* n);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_job_destroy(vbgpd_job*);

/* ---- reading fields ----------------------------------------------------------------------------------------- */
#define VBGPD_AT_PARTICLE 1
#define VBGPD_AT_BOND 2
#define VBGPD_TYPE_F64 1
#define VBGPD_TYPE_I64 2
typedef struct vbgpd_field_info {
  uint32_t struct_size;
  int32_t type;     /* VBGPD_TYPE_* */
  int32_t location; /* VBGPD_AT_* */
  int32_t components;
  const char *name, *unit, *doc; /* static text; unit UDUNITS */
  int32_t writable;              /* 1 = vbgpd_model_write_f64 and its sisters take it */
  int32_t reserved;
} vbgpd_field_info;
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_field_count(int64_t* n);                            /* [any-thread] */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_field_info_at(int64_t i, vbgpd_field_info* info);   /* [any-thread] */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_field_find(const char* name, int64_t len, int32_t* field); /* [any-thread] */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_item_count(const vbgpd_model*, int32_t location, int64_t* n);
/* Copies all items of a field, by particle id (soil first, then wall particles) or bond by bond. dst + i*stride_item +
 * c*stride_component bytes receives component c of item i; strides 0 = packed rows. cap counts items; *n (may be NULL) is the
 * full count; cap too small gives VBGPD_E_BUFFER. read_i64 wants an integer field, read_f64 takes either. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_read_f64(const vbgpd_model*, int32_t field, double* dst, int64_t stride_item, int64_t stride_component, int64_t cap, int64_t* n);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_read_i64(const vbgpd_model*, int32_t field, int64_t* dst, int64_t stride_item, int64_t stride_component, int64_t cap, int64_t* n);
/* Which particles. Set struct_size and kind; members a kind does not name are not read. Shorter structs may leave out
 * what their kind does not need. Results come by particle id, ascending; IDS in the order given. */
#define VBGPD_SELECT_ALL 0
#define VBGPD_SELECT_IDS 1      /* ids, ids_stride (bytes), n_ids */
#define VBGPD_SELECT_BOX 2      /* xmin, ymin, xmax, ymax: present position, rim included */
#define VBGPD_SELECT_POLYGON 3  /* xy, xy_stride, n_points: present position */
#define VBGPD_SELECT_MATERIAL 4 /* object_id: soil of a material */
#define VBGPD_SELECT_LAYER 5    /* object_id: soil of the cells that a layer of the profile, as painted, holds most of */
#define VBGPD_SELECT_BOUNDARY 6 /* object_id: wall particles of a boundary */
#define VBGPD_SELECT_SOIL 7     /* all that are no wall particles */
typedef struct vbgpd_selection {
  uint32_t struct_size;
  int32_t kind;      /* VBGPD_SELECT_* */
  int64_t object_id;
  double xmin, ymin, xmax, ymax;
  const int64_t* ids;
  int64_t ids_stride, n_ids;
  const double* xy;
  int64_t xy_stride, n_points;
} vbgpd_selection;
/* The ids of the selected particles; cap, stride (bytes, 8 = packed) and *n as above. selection NULL = all. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_select(const vbgpd_model*, const vbgpd_selection* selection, int64_t* ids, int64_t stride, int64_t cap, int64_t* n);
/* As vbgpd_model_read_f64 and _i64, of the selected particles only; bond fields give VBGPD_E_ARGUMENT. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_read_selected_f64(const vbgpd_model*, int32_t field, const vbgpd_selection* selection, double* dst, int64_t stride_item, int64_t stride_component, int64_t cap, int64_t* n);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_read_selected_i64(const vbgpd_model*, int32_t field, const vbgpd_selection* selection, int64_t* dst, int64_t stride_item, int64_t stride_component, int64_t cap, int64_t* n);
/* A particle field of real numbers at n places in the present shape: the plane fitted by the kernel of the method through
 * the soil particles around, exact for linear fields. inside (may be NULL) gets 1, or 0 where no soil is (value NaN). */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_sample_points(const vbgpd_model*, int32_t field, const double* xy, int64_t stride_xy, int64_t n, double* dst, int64_t stride_item, int64_t stride_component, int64_t* inside, int64_t stride_inside);
/* n places at equal distances from (x0, y0) to (x1, y1), both ends included. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_sample_line(const vbgpd_model*, int32_t field, double x0, double y0, double x1, double y1, int64_t n, double* dst, int64_t stride_item, int64_t stride_component, int64_t* inside, int64_t stride_inside);
/* nx times ny places x0 + i*dx, y0 + j*dy; item i + nx*j. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_sample_grid(const vbgpd_model*, int32_t field, double x0, double y0, double dx, double dy, int64_t nx, int64_t ny, double* dst, int64_t stride_item, int64_t stride_component, int64_t* inside, int64_t stride_inside);
/* The ground surface in its present shape, left to right, a point about every spacing; rules as vbgpd_profile_polygon. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_ground_surface(const vbgpd_model*, double* xy, int64_t stride, int64_t cap, int64_t* n);

/* Zero copy: a particle field as it is stored, padding included: component c of item i lies at data + i*stride_item +
 * c*stride_component bytes. displacement, velocity, mass, volume (double) and particle_id (int64_t, -1 = padding) can be
 * viewed, of a run-out velocity, mass, volume, plastic_strain and particle_id; the others give VBGPD_E_UNSUPPORTED. Read only. Until
 * release the data stay where they are and calls that would change the model give VBGPD_E_LEASED. Destroying the model ends all leases. */
typedef struct vbgpd_view {
  uint32_t struct_size;
  int32_t type;                           /* VBGPD_TYPE_* */
  const void* data;
  int64_t count, components;
  int64_t stride_item, stride_component;  /* bytes */
  int64_t epoch, lease;
} vbgpd_view;
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_view_acquire(vbgpd_model*, int32_t field, vbgpd_view* view);
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_view_release(vbgpd_model*, int64_t lease);
/* 64-bit hash of the soil's state (displacements, velocities, plastic strain, which layers are there; not of what acts on it:
 * factors, damping, loads, pressures): same run = same hash, at any thread count. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_state_hash(const vbgpd_model*, uint64_t* hash);

/* ---- events ------------------------------------------------------------------------------------------------ */
/* What happened, noticed at the end of the call that made it happen; the last 256 are kept, to be polled. */
#define VBGPD_EVENT_FIRST_YIELD 1 /* the first bonds turned plastic: id_a, id_b and x, y of the one that did most, value its strain */
#define VBGPD_EVENT_AT_REST 2     /* dynamic steps came to rest: value = unbalanced force ratio, below 1e-5 */
#define VBGPD_EVENT_MECHANISM 3   /* a job found the slope failing: value = strength reduction factor of the model */
#define VBGPD_EVENT_DIVERGED 4    /* the model is back at a good step, see vbgpd_model_step */
/* dynamic steps reached a fifth of the speed, or half of the energy out of nothing, that ends them: value = share of that limit */
#define VBGPD_EVENT_NEAR_DIVERGENCE 5
typedef struct vbgpd_event {
  uint32_t struct_size;
  int32_t kind;         /* VBGPD_EVENT_* */
  int64_t sequence;     /* counts from 1 */
  int64_t step;         /* dynamic steps done when it was noticed */
  double time;          /* s */
  int64_t id_a, id_b;   /* particle ids, -1 = none */
  double x, y, value;   /* NaN = none */
} vbgpd_event;
/* Events with a sequence above after (0 = all), oldest first, stride bytes apart; dst->struct_size holds for all of them.
 * cap counts events; *n gets how many were given (cap 0: how many there are), *dropped how many are kept no longer. Both
 * may be NULL. Reading takes nothing away. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_events_read(vbgpd_model*, int64_t after, vbgpd_event* dst, int64_t stride, int64_t cap, int64_t* n, int64_t* dropped);

/* ---- setting from outside: stays until set again ------------------------------------------------------------ */
/* Between any two steps. Writable fields (field_info.writable):
 * pore_pressure (Pa, compression positive, may be negative): from then on bonds carry effective stress; total stress is
 *   stress - pore_pressure. The pressure goes on into the wall particles: set them too (_points and _grid do). Where it is
 *   not 0 at the ground, the water standing there is a load of its own. Jobs count it in, on every grid.
 * external_force (N per metre run, x and y): added to weight and loads.
 * velocity (m/s, -1e9 to 1e9): of what walls do not hold; the energy ledger books it as external work.
 * A number that is not finite, or out of that range, gives VBGPD_E_RANGE with the error record's item: the particle, in
 * _points the place, in _grid the item. Places farther out than 1e12 m are refused alike. */
/* n items in the order of the selection (NULL = all particles by id); n must be their number. strides as _read_f64. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_write_f64(vbgpd_model*, int32_t field, const vbgpd_selection* selection, const double* src, int64_t stride_item, int64_t stride_component, int64_t n);
/* Values at n places of another program, e.g. nodes of a seepage mesh, brought to all particles at their present
 * positions by the plane through the eight nearest places (as many more as it takes to span one, at most 512; of places on one
 * line a straight line along it), weighted 1/d^2: exact for linear fields and at the places. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_write_points(vbgpd_model*, int32_t field, const double* xy, int64_t stride_xy, const double* src, int64_t stride_item, int64_t stride_component, int64_t n);
/* Values on a raster, item i + nx*j at x0 + i*dx, y0 + j*dy, bilinear, continued linearly beyond its rim. NaN = no value:
 * particles that would need it keep what they have. One component only. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_write_grid(vbgpd_model*, int32_t field, double x0, double y0, double dx, double dy, int64_t nx, int64_t ny, const double* src, int64_t stride_item);
/* Pressures of a load of the profile (Pa, down positive). VBGPD_E_ARGUMENT: no such load. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_set_load(vbgpd_model*, int64_t load_id, double pressure, double pressure_end);
/* Of a boundary of kind VBGPD_BOUNDARY_VELOCITY, m/s; another kind gives VBGPD_E_STATE. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_set_boundary_velocity(vbgpd_model*, int64_t boundary_id, double vx, double vy);
/* Staged construction: takes the soil of a layer away (active 0: excavation) or places it (1: fill, or a layer switched off
 * before); at first all layers are there. The soil is that of VBGPD_SELECT_LAYER, with the walls beside it; what the layer
 * painted over does not come back in its place. Between any two steps, in no step's time; the rest keeps its state.
 * Off: as air. Its particles keep their ids and read 0 as field "active", as volume, mass, stress, displacement and velocity;
 *   bonds through them and across the gap are gone, the new surface is a free one. A load of the profile acts on the ground
 *   that is there now, over the part of x0 to x1 that has soil. Forces and pressures written to its particles wait.
 * On: placed without stress, at rest, in the present shape, each particle moved as its nearest neighbour that was there;
 *   no stress changes in what was there. Then it weighs. Its "displacement" counts from the undeformed section.
 * Saved states and checkpoints bring their layers back; jobs take them over on every grid. Costs about what a model costs to
 * create, in time and for that time in memory. Setting what is so does nothing.
 * VBGPD_E_ARGUMENT: no such layer, active neither 0 nor 1, or no soil would be left. VBGPD_E_UNSUPPORTED: a run-out. One
 * made of a model with layers switched off has the soil that is there, numbered anew in the order of the ids, and all its walls. */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_set_layer_active(vbgpd_model*, int64_t layer_id, int32_t active);
/* The force of a boundary on the soil, N per metre run, of total stress: on a slope at rest the reactions of all boundaries
 * balance weight, loads and forces from outside on the soil. Of a run-out: that of the step to come (costs one step). */
VBGPD_API vbgpd_status VBGPD_CALL vbgpd_model_boundary_reaction(const vbgpd_model*, int64_t boundary_id, double* fx, double* fy);

#ifdef __cplusplus
}
#endif
#endif
