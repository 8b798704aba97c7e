! The C face declared for Fortran, one declaration per constant, struct member and function of vbgpd.h, in its order.
! Nothing here thinks: the manual is vbgpd.h. A test compares every name, type and order with the header.
!
! How C is read here: handles and arrays with a stride are addresses (c_ptr by value); a text is the first character of
! (text, length); every other pointer is an argument by reference, and leaving an optional one out passes NULL.
! Receiving arguments are intent(inout) because a call that failed leaves them as they were.
! Fortran does not tell capitals apart: VBGPD_VERSION_NUMBER and VBGPD_ABI_VERSION of the header are
! VBGPD_HEADER_VERSION_NUMBER and VBGPD_HEADER_ABI_VERSION beside the functions of the same name.
module vbgpd_c
  use, intrinsic :: iso_c_binding
  implicit none
  public

  integer(c_int32_t), parameter :: VBGPD_HEADER_VERSION_NUMBER = 1000000
  integer(c_int32_t), parameter :: VBGPD_HEADER_ABI_VERSION = 1
  integer(c_int64_t), parameter :: VBGPD_STRLEN = -1_c_int64_t
  integer(c_int32_t), parameter :: VBGPD_OK = 0
  integer(c_int32_t), parameter :: VBGPD_CANCELLED = 1
  integer(c_int32_t), parameter :: VBGPD_LIMIT_REACHED = 2
  integer(c_int32_t), parameter :: VBGPD_NOT_CONVERGED = 3
  integer(c_int32_t), parameter :: VBGPD_UNSTABLE = 4
  integer(c_int32_t), parameter :: VBGPD_END_OF_DATA = 5
  integer(c_int32_t), parameter :: VBGPD_E_ARGUMENT = -1
  integer(c_int32_t), parameter :: VBGPD_E_HANDLE = -2
  integer(c_int32_t), parameter :: VBGPD_E_MEMORY = -3
  integer(c_int32_t), parameter :: VBGPD_E_LIMIT = -4
  integer(c_int32_t), parameter :: VBGPD_E_BUSY = -5
  integer(c_int32_t), parameter :: VBGPD_E_LEASED = -6
  integer(c_int32_t), parameter :: VBGPD_E_REENTRANT = -7
  integer(c_int32_t), parameter :: VBGPD_E_STATE = -8
  integer(c_int32_t), parameter :: VBGPD_E_GEOMETRY = -9
  integer(c_int32_t), parameter :: VBGPD_E_UNKNOWN_NAME = -10
  integer(c_int32_t), parameter :: VBGPD_E_RANGE = -11
  integer(c_int32_t), parameter :: VBGPD_E_BUFFER = -12
  integer(c_int32_t), parameter :: VBGPD_E_FORMAT = -13
  integer(c_int32_t), parameter :: VBGPD_E_VERSION = -14
  integer(c_int32_t), parameter :: VBGPD_E_DIVERGED = -15
  integer(c_int32_t), parameter :: VBGPD_E_UNSUPPORTED = -17
  integer(c_int32_t), parameter :: VBGPD_E_INTERNAL = -99
  integer(c_int32_t), parameter :: VBGPD_OBJECT_CONTEXT = 1
  integer(c_int32_t), parameter :: VBGPD_OBJECT_PROFILE = 2
  integer(c_int32_t), parameter :: VBGPD_OBJECT_MATERIAL = 3
  integer(c_int32_t), parameter :: VBGPD_OBJECT_LAYER = 4
  integer(c_int32_t), parameter :: VBGPD_OBJECT_LOAD = 5
  integer(c_int32_t), parameter :: VBGPD_OBJECT_BOUNDARY = 6
  integer(c_int32_t), parameter :: VBGPD_OBJECT_MODEL = 7
  integer(c_int32_t), parameter :: VBGPD_OBJECT_JOB = 8
  integer(c_int32_t), parameter :: VBGPD_OBJECT_STATE = 9
  integer(c_int32_t), parameter :: VBGPD_LOG_WARNING = 1
  integer(c_int32_t), parameter :: VBGPD_LOG_INFO = 2
  integer(c_int32_t), parameter :: VBGPD_LOG_DETAIL = 3
  integer(c_int32_t), parameter :: VBGPD_BOUNDARY_FREE = 0
  integer(c_int32_t), parameter :: VBGPD_BOUNDARY_FIXED = 1
  integer(c_int32_t), parameter :: VBGPD_BOUNDARY_ROLLER = 2
  integer(c_int32_t), parameter :: VBGPD_BOUNDARY_VELOCITY = 3
  integer(c_int32_t), parameter :: VBGPD_VERDICT_UNDECIDED = 0
  integer(c_int32_t), parameter :: VBGPD_VERDICT_STABLE = 1
  integer(c_int32_t), parameter :: VBGPD_VERDICT_FAILED = 2
  integer(c_int32_t), parameter :: VBGPD_AT_PARTICLE = 1
  integer(c_int32_t), parameter :: VBGPD_AT_BOND = 2
  integer(c_int32_t), parameter :: VBGPD_TYPE_F64 = 1
  integer(c_int32_t), parameter :: VBGPD_TYPE_I64 = 2
  integer(c_int32_t), parameter :: VBGPD_SELECT_ALL = 0
  integer(c_int32_t), parameter :: VBGPD_SELECT_IDS = 1
  integer(c_int32_t), parameter :: VBGPD_SELECT_BOX = 2
  integer(c_int32_t), parameter :: VBGPD_SELECT_POLYGON = 3
  integer(c_int32_t), parameter :: VBGPD_SELECT_MATERIAL = 4
  integer(c_int32_t), parameter :: VBGPD_SELECT_LAYER = 5
  integer(c_int32_t), parameter :: VBGPD_SELECT_BOUNDARY = 6
  integer(c_int32_t), parameter :: VBGPD_SELECT_SOIL = 7
  integer(c_int32_t), parameter :: VBGPD_EVENT_FIRST_YIELD = 1
  integer(c_int32_t), parameter :: VBGPD_EVENT_AT_REST = 2
  integer(c_int32_t), parameter :: VBGPD_EVENT_MECHANISM = 3
  integer(c_int32_t), parameter :: VBGPD_EVENT_DIVERGED = 4
  integer(c_int32_t), parameter :: VBGPD_EVENT_NEAR_DIVERGENCE = 5

  type, bind(C) :: vbgpd_error_info
    integer(c_int32_t) :: struct_size = 56
    integer(c_int32_t) :: status = 0
    integer(c_int32_t) :: object_kind = 0
    integer(c_int32_t) :: argument = 0
    integer(c_int64_t) :: object_id = 0
    integer(c_int64_t) :: item = 0
    real(c_double) :: x = 0
    real(c_double) :: y = 0
    real(c_double) :: value = 0
  end type vbgpd_error_info

  type, bind(C) :: vbgpd_context_desc
    integer(c_int32_t) :: struct_size = 56
    integer(c_int32_t) :: abi_version = 0
    integer(c_int32_t) :: threads = 0
    integer(c_int32_t) :: reserved = 0
    integer(c_int64_t) :: max_particles = 0
    integer(c_int64_t) :: max_bytes = 0
    type(c_funptr) :: alloc = c_null_funptr
    type(c_funptr) :: free = c_null_funptr
    type(c_ptr) :: alloc_user = c_null_ptr
  end type vbgpd_context_desc

  type, bind(C) :: vbgpd_log_line
    integer(c_int32_t) :: struct_size = 24
    integer(c_int32_t) :: level = 0
    integer(c_int64_t) :: sequence = 0
    real(c_double) :: seconds = 0
  end type vbgpd_log_line

  type, bind(C) :: vbgpd_property_info
    integer(c_int32_t) :: struct_size = 64
    integer(c_int32_t) :: required = 0
    type(c_ptr) :: name = c_null_ptr
    type(c_ptr) :: unit = c_null_ptr
    type(c_ptr) :: doc = c_null_ptr
    real(c_double) :: default_value = 0
    real(c_double) :: min_value = 0
    real(c_double) :: max_value = 0
    integer(c_int32_t) :: min_open = 0
    integer(c_int32_t) :: max_open = 0
  end type vbgpd_property_info

  type, bind(C) :: vbgpd_feature
    integer(c_int32_t) :: struct_size = 48
    integer(c_int32_t) :: used = 0
    type(c_ptr) :: name = c_null_ptr
    type(c_ptr) :: doc = c_null_ptr
    integer(c_int64_t) :: bytes = 0
    real(c_double) :: bytes_per_particle = 0
    real(c_double) :: bytes_per_bond = 0
  end type vbgpd_feature

  type, bind(C) :: vbgpd_memory
    integer(c_int32_t) :: struct_size = 64
    integer(c_int32_t) :: reserved = 0
    integer(c_int64_t) :: bytes = 0
    integer(c_int64_t) :: model = 0
    integer(c_int64_t) :: state = 0
    integer(c_int64_t) :: scratch = 0
    integer(c_int64_t) :: copies = 0
    integer(c_int64_t) :: outside = 0
    integer(c_int64_t) :: saved = 0
  end type vbgpd_memory

  type, bind(C) :: vbgpd_progress
    integer(c_int32_t) :: struct_size = 72
    integer(c_int32_t) :: level = 0
    integer(c_int32_t) :: trial = 0
    integer(c_int32_t) :: phase = 0
    integer(c_int64_t) :: steps = 0
    real(c_double) :: fraction = 0
    real(c_double) :: strength_reduction_factor = 0
    real(c_double) :: srf_stable = 0
    real(c_double) :: srf_unstable = 0
    real(c_double) :: unbalanced_force_ratio = 0
    real(c_double) :: max_displacement = 0
  end type vbgpd_progress

  type, bind(C) :: vbgpd_advance_result
    integer(c_int32_t) :: struct_size = 72
    integer(c_int32_t) :: reserved = 0
    integer(c_int64_t) :: steps = 0
    real(c_double) :: time = 0
    real(c_double) :: time_step = 0
    real(c_double) :: kinetic_energy = 0
    real(c_double) :: unbalanced_force_ratio = 0
    real(c_double) :: max_displacement = 0
    real(c_double) :: max_velocity = 0
    integer(c_int64_t) :: plastic_bonds = 0
  end type vbgpd_advance_result

  type, bind(C) :: vbgpd_trial
    integer(c_int32_t) :: struct_size = 80
    integer(c_int32_t) :: level = 0
    integer(c_int32_t) :: verdict = 0
    integer(c_int32_t) :: band_connected = 0
    real(c_double) :: strength_reduction_factor = 0
    real(c_double) :: unbalanced_force_ratio = 0
    real(c_double) :: unbalanced_force_slope = 0
    real(c_double) :: displacement_level = 0
    real(c_double) :: displacement_growth = 0
    real(c_double) :: power_ratio = 0
    integer(c_int64_t) :: steps = 0
    real(c_double) :: wall_seconds = 0
  end type vbgpd_trial

  type, bind(C) :: vbgpd_level
    integer(c_int32_t) :: struct_size = 120
    integer(c_int32_t) :: reserved = 0
    real(c_double) :: spacing_x = 0
    real(c_double) :: spacing_y = 0
    integer(c_int64_t) :: particles = 0
    integer(c_int64_t) :: bonds = 0
    integer(c_int64_t) :: steps = 0
    integer(c_int64_t) :: trials = 0
    real(c_double) :: srf_stable = 0
    real(c_double) :: srf_unstable = 0
    real(c_double) :: factor_of_safety = 0
    real(c_double) :: wall_seconds = 0
    real(c_double) :: cpu_seconds = 0
    real(c_double) :: estimate = 0
    real(c_double) :: error_estimate = 0
    real(c_double) :: sliding_area = 0
  end type vbgpd_level

  type, bind(C) :: vbgpd_field_info
    integer(c_int32_t) :: struct_size = 48
    integer(c_int32_t) :: type = 0
    integer(c_int32_t) :: location = 0
    integer(c_int32_t) :: components = 0
    type(c_ptr) :: name = c_null_ptr
    type(c_ptr) :: unit = c_null_ptr
    type(c_ptr) :: doc = c_null_ptr
    integer(c_int32_t) :: writable = 0
    integer(c_int32_t) :: reserved = 0
  end type vbgpd_field_info

  type, bind(C) :: vbgpd_selection
    integer(c_int32_t) :: struct_size = 96
    integer(c_int32_t) :: kind = 0
    integer(c_int64_t) :: object_id = 0
    real(c_double) :: xmin = 0
    real(c_double) :: ymin = 0
    real(c_double) :: xmax = 0
    real(c_double) :: ymax = 0
    type(c_ptr) :: ids = c_null_ptr
    integer(c_int64_t) :: ids_stride = 0
    integer(c_int64_t) :: n_ids = 0
    type(c_ptr) :: xy = c_null_ptr
    integer(c_int64_t) :: xy_stride = 0
    integer(c_int64_t) :: n_points = 0
  end type vbgpd_selection

  type, bind(C) :: vbgpd_view
    integer(c_int32_t) :: struct_size = 64
    integer(c_int32_t) :: type = 0
    type(c_ptr) :: data = c_null_ptr
    integer(c_int64_t) :: count = 0
    integer(c_int64_t) :: components = 0
    integer(c_int64_t) :: stride_item = 0
    integer(c_int64_t) :: stride_component = 0
    integer(c_int64_t) :: epoch = 0
    integer(c_int64_t) :: lease = 0
  end type vbgpd_view

  type, bind(C) :: vbgpd_event
    integer(c_int32_t) :: struct_size = 72
    integer(c_int32_t) :: kind = 0
    integer(c_int64_t) :: sequence = 0
    integer(c_int64_t) :: step = 0
    real(c_double) :: time = 0
    integer(c_int64_t) :: id_a = 0
    integer(c_int64_t) :: id_b = 0
    real(c_double) :: x = 0
    real(c_double) :: y = 0
    real(c_double) :: value = 0
  end type vbgpd_event

  abstract interface
    function vbgpd_alloc_fn(user, bytes, alignment) result(outcome) bind(C)
      import
      type(c_ptr), value :: user
      integer(c_int64_t), value :: bytes
      integer(c_int64_t), value :: alignment
      type(c_ptr) :: outcome
    end function vbgpd_alloc_fn

    subroutine vbgpd_free_fn(user, p, bytes, alignment) bind(C)
      import
      type(c_ptr), value :: user
      type(c_ptr), value :: p
      integer(c_int64_t), value :: bytes
      integer(c_int64_t), value :: alignment
    end subroutine vbgpd_free_fn

    subroutine vbgpd_log_fn(user, line, text) bind(C)
      import
      type(c_ptr), value :: user
      type(vbgpd_log_line), intent(in) :: line
      character(kind=c_char), intent(in), optional :: text(*)
    end subroutine vbgpd_log_fn

    function vbgpd_progress_fn(user, progress) result(outcome) bind(C)
      import
      type(c_ptr), value :: user
      type(vbgpd_progress), intent(in) :: progress
      integer(c_int32_t) :: outcome
    end function vbgpd_progress_fn
  end interface

  interface
    ! ---- version
    function vbgpd_version_number() result(outcome) bind(C)
      import
      integer(c_int32_t) :: outcome
    end function vbgpd_version_number

    function vbgpd_abi_version() result(outcome) bind(C)
      import
      integer(c_int32_t) :: outcome
    end function vbgpd_abi_version

    function vbgpd_version_string() result(outcome) bind(C)
      import
      type(c_ptr) :: outcome
    end function vbgpd_version_string

    ! ---- status
    function vbgpd_status_name(s) result(outcome) bind(C)
      import
      integer(c_int32_t), value :: s
      type(c_ptr) :: outcome
    end function vbgpd_status_name

    function vbgpd_build_info(key, key_len, buf, cap, needed) result(outcome) bind(C)
      import
      character(kind=c_char), intent(in), optional :: key(*)
      integer(c_int64_t), value :: key_len
      character(kind=c_char), intent(inout), optional :: buf(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_build_info

    function vbgpd_context_error(context, info, text, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: context
      type(vbgpd_error_info), intent(inout), optional :: info
      character(kind=c_char), intent(inout), optional :: text(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_context_error

    function vbgpd_profile_error(profile, info, text, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      type(vbgpd_error_info), intent(inout), optional :: info
      character(kind=c_char), intent(inout), optional :: text(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_error

    function vbgpd_model_error(model, info, text, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(vbgpd_error_info), intent(inout), optional :: info
      character(kind=c_char), intent(inout), optional :: text(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_model_error

    function vbgpd_job_error(job, info, text, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      type(vbgpd_error_info), intent(inout), optional :: info
      character(kind=c_char), intent(inout), optional :: text(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_job_error

    ! ---- context
    function vbgpd_context_desc_init(d, struct_size) result(outcome) bind(C)
      import
      type(vbgpd_context_desc), intent(inout), optional :: d
      integer(c_int32_t), value :: struct_size
      integer(c_int32_t) :: outcome
    end function vbgpd_context_desc_init

    function vbgpd_context_create(d, out) result(outcome) bind(C)
      import
      type(vbgpd_context_desc), intent(in), optional :: d
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_context_create

    function vbgpd_context_desc_check(d, info, text, cap, needed) result(outcome) bind(C)
      import
      type(vbgpd_context_desc), intent(in), optional :: d
      type(vbgpd_error_info), intent(inout), optional :: info
      character(kind=c_char), intent(inout), optional :: text(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_context_desc_check

    function vbgpd_context_destroy(context) result(outcome) bind(C)
      import
      type(c_ptr), value :: context
      integer(c_int32_t) :: outcome
    end function vbgpd_context_destroy

    ! ---- log
    function vbgpd_context_log_next(context, after, line, text, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: context
      integer(c_int64_t), value :: after
      type(vbgpd_log_line), intent(inout), optional :: line
      character(kind=c_char), intent(inout), optional :: text(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_context_log_next

    function vbgpd_context_set_log(context, fn, user, level) result(outcome) bind(C)
      import
      type(c_ptr), value :: context
      type(c_funptr), value :: fn
      type(c_ptr), value :: user
      integer(c_int32_t), value :: level
      integer(c_int32_t) :: outcome
    end function vbgpd_context_set_log

    ! ---- the named numbers describe themselves
    function vbgpd_property_count(object_kind, n) result(outcome) bind(C)
      import
      integer(c_int32_t), value :: object_kind
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_property_count

    function vbgpd_property_info_at(object_kind, i, info) result(outcome) bind(C)
      import
      integer(c_int32_t), value :: object_kind
      integer(c_int64_t), value :: i
      type(vbgpd_property_info), intent(inout), optional :: info
      integer(c_int32_t) :: outcome
    end function vbgpd_property_info_at

    ! ---- slope profile
    function vbgpd_profile_create(context, out) result(outcome) bind(C)
      import
      type(c_ptr), value :: context
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_create

    function vbgpd_profile_create_from_flatbuffer(context, bytes, len, out) result(outcome) bind(C)
      import
      type(c_ptr), value :: context
      type(c_ptr), value :: bytes
      integer(c_int64_t), value :: len
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_create_from_flatbuffer

    function vbgpd_profile_to_flatbuffer(profile, buf, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      type(c_ptr), value :: buf
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_to_flatbuffer

    function vbgpd_profile_destroy(profile) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_destroy

    function vbgpd_profile_set_exterior(profile, xy, stride, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_set_exterior

    function vbgpd_profile_add_material(profile, name, len, material_id) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      integer(c_int64_t), intent(inout), optional :: material_id
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_add_material

    function vbgpd_profile_add_layer(profile, xy, stride, n, material_id, layer_id) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: n
      integer(c_int64_t), value :: material_id
      integer(c_int64_t), intent(inout), optional :: layer_id
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_add_layer

    function vbgpd_profile_add_boundary(profile, side, side_len, xy, stride, n, kind, &
                                        boundary_id) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      character(kind=c_char), intent(in), optional :: side(*)
      integer(c_int64_t), value :: side_len
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: n
      integer(c_int32_t), value :: kind
      integer(c_int64_t), intent(inout), optional :: boundary_id
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_add_boundary

    function vbgpd_profile_add_load(profile, x0, x1, pressure, pressure_end, load_id) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      real(c_double), value :: x0
      real(c_double), value :: x1
      real(c_double), value :: pressure
      real(c_double), value :: pressure_end
      integer(c_int64_t), intent(inout), optional :: load_id
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_add_load

    function vbgpd_profile_set_water_table(profile, xy, stride, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_set_water_table

    function vbgpd_profile_water_table(profile, xy, stride, cap, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_water_table

    function vbgpd_profile_set_f64(profile, object_kind, id, name, len, value) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int32_t), value :: object_kind
      integer(c_int64_t), value :: id
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      real(c_double), value :: value
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_set_f64

    function vbgpd_profile_get_f64(profile, object_kind, id, name, len, value) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int32_t), value :: object_kind
      integer(c_int64_t), value :: id
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      real(c_double), intent(inout), optional :: value
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_get_f64

    function vbgpd_profile_set_text(profile, object_kind, id, name, len, value, value_len) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int32_t), value :: object_kind
      integer(c_int64_t), value :: id
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      character(kind=c_char), intent(in), optional :: value(*)
      integer(c_int64_t), value :: value_len
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_set_text

    function vbgpd_profile_get_text(profile, object_kind, id, name, len, buf, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int32_t), value :: object_kind
      integer(c_int64_t), value :: id
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      character(kind=c_char), intent(inout), optional :: buf(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_get_text

    function vbgpd_profile_count(profile, object_kind, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int32_t), value :: object_kind
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_count

    function vbgpd_profile_polygon(profile, object_kind, id, xy, stride, cap, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int32_t), value :: object_kind
      integer(c_int64_t), value :: id
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_polygon

    function vbgpd_profile_validate(profile, errors, warnings) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int64_t), intent(inout), optional :: errors
      integer(c_int64_t), intent(inout), optional :: warnings
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_validate

    function vbgpd_profile_issue(profile, i, info, text, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: profile
      integer(c_int64_t), value :: i
      type(vbgpd_error_info), intent(inout), optional :: info
      character(kind=c_char), intent(inout), optional :: text(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_profile_issue

    ! ---- model
    function vbgpd_model_create(context, profile, out) result(outcome) bind(C)
      import
      type(c_ptr), value :: context
      type(c_ptr), value :: profile
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_model_create

    function vbgpd_model_destroy(model) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t) :: outcome
    end function vbgpd_model_destroy

    function vbgpd_model_set_f64(model, name, len, value) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      real(c_double), value :: value
      integer(c_int32_t) :: outcome
    end function vbgpd_model_set_f64

    function vbgpd_model_get_f64(model, name, len, value) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      real(c_double), intent(inout), optional :: value
      integer(c_int32_t) :: outcome
    end function vbgpd_model_get_f64

    function vbgpd_model_plan(model, i, f) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), value :: i
      type(vbgpd_feature), intent(inout), optional :: f
      integer(c_int32_t) :: outcome
    end function vbgpd_model_plan

    function vbgpd_model_memory(model, m) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(vbgpd_memory), intent(inout), optional :: m
      integer(c_int32_t) :: outcome
    end function vbgpd_model_memory

    function vbgpd_model_step(model, steps, r) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), value :: steps
      type(vbgpd_advance_result), intent(inout), optional :: r
      integer(c_int32_t) :: outcome
    end function vbgpd_model_step

    function vbgpd_model_cancel(model) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t) :: outcome
    end function vbgpd_model_cancel

    function vbgpd_model_advance_to(model, time, wall_seconds, fn, user, r) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      real(c_double), value :: time
      real(c_double), value :: wall_seconds
      type(c_funptr), value :: fn
      type(c_ptr), value :: user
      type(vbgpd_advance_result), intent(inout), optional :: r
      integer(c_int32_t) :: outcome
    end function vbgpd_model_advance_to

    function vbgpd_model_epoch(model, epoch) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), intent(inout), optional :: epoch
      integer(c_int32_t) :: outcome
    end function vbgpd_model_epoch

    ! ---- save and restore
    function vbgpd_model_save_state(model, inout) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), intent(inout) :: inout
      integer(c_int32_t) :: outcome
    end function vbgpd_model_save_state

    function vbgpd_model_restore_state(model, state) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), value :: state
      integer(c_int32_t) :: outcome
    end function vbgpd_model_restore_state

    function vbgpd_state_destroy(state) result(outcome) bind(C)
      import
      type(c_ptr), value :: state
      integer(c_int32_t) :: outcome
    end function vbgpd_state_destroy

    function vbgpd_model_checkpoint(model, buf, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), value :: buf
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_model_checkpoint

    function vbgpd_model_create_from_checkpoint(context, bytes, len, out) result(outcome) bind(C)
      import
      type(c_ptr), value :: context
      type(c_ptr), value :: bytes
      integer(c_int64_t), value :: len
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_model_create_from_checkpoint

    function vbgpd_model_restore_checkpoint(model, bytes, len) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), value :: bytes
      integer(c_int64_t), value :: len
      integer(c_int32_t) :: outcome
    end function vbgpd_model_restore_checkpoint

    function vbgpd_model_snapshot(model, buf, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), value :: buf
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_model_snapshot

    ! ---- run-out
    function vbgpd_model_create_runout(from, out) result(outcome) bind(C)
      import
      type(c_ptr), value :: from
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_model_create_runout

    function vbgpd_job_create_runout(model, out) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_job_create_runout

    ! ---- jobs: long analyses in slices
    function vbgpd_job_create_equilibrium(model, out) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_job_create_equilibrium

    function vbgpd_job_create_strength_reduction(model, out) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), intent(inout) :: out
      integer(c_int32_t) :: outcome
    end function vbgpd_job_create_strength_reduction

    function vbgpd_job_set_f64(job, name, len, value) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      real(c_double), value :: value
      integer(c_int32_t) :: outcome
    end function vbgpd_job_set_f64

    function vbgpd_job_run(job, wall_seconds, fn, user, p) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      real(c_double), value :: wall_seconds
      type(c_funptr), value :: fn
      type(c_ptr), value :: user
      type(vbgpd_progress), intent(inout), optional :: p
      integer(c_int32_t) :: outcome
    end function vbgpd_job_run

    function vbgpd_job_cancel(job) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      integer(c_int32_t) :: outcome
    end function vbgpd_job_cancel

    function vbgpd_job_get_f64(job, name, len, value) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      real(c_double), intent(inout), optional :: value
      integer(c_int32_t) :: outcome
    end function vbgpd_job_get_f64

    function vbgpd_job_get_text(job, name, len, buf, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      character(kind=c_char), intent(inout), optional :: buf(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function vbgpd_job_get_text

    function vbgpd_job_trial(job, i, t) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      integer(c_int64_t), value :: i
      type(vbgpd_trial), intent(inout), optional :: t
      integer(c_int32_t) :: outcome
    end function vbgpd_job_trial

    function vbgpd_job_level(job, i, l) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      integer(c_int64_t), value :: i
      type(vbgpd_level), intent(inout), optional :: l
      integer(c_int32_t) :: outcome
    end function vbgpd_job_level

    function vbgpd_job_slip_surface(job, xy, stride, cap, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_job_slip_surface

    function vbgpd_job_destroy(job) result(outcome) bind(C)
      import
      type(c_ptr), value :: job
      integer(c_int32_t) :: outcome
    end function vbgpd_job_destroy

    ! ---- reading fields
    function vbgpd_field_count(n) result(outcome) bind(C)
      import
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_field_count

    function vbgpd_field_info_at(i, info) result(outcome) bind(C)
      import
      integer(c_int64_t), value :: i
      type(vbgpd_field_info), intent(inout), optional :: info
      integer(c_int32_t) :: outcome
    end function vbgpd_field_info_at

    function vbgpd_field_find(name, len, field) result(outcome) bind(C)
      import
      character(kind=c_char), intent(in), optional :: name(*)
      integer(c_int64_t), value :: len
      integer(c_int32_t), intent(inout), optional :: field
      integer(c_int32_t) :: outcome
    end function vbgpd_field_find

    function vbgpd_model_item_count(model, location, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: location
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_item_count

    function vbgpd_model_read_f64(model, field, dst, stride_item, stride_component, cap, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      type(c_ptr), value :: dst
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_read_f64

    function vbgpd_model_read_i64(model, field, dst, stride_item, stride_component, cap, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      type(c_ptr), value :: dst
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_read_i64

    function vbgpd_model_select(model, selection, ids, stride, cap, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(vbgpd_selection), intent(in), optional :: selection
      type(c_ptr), value :: ids
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_select

    function vbgpd_model_read_selected_f64(model, field, selection, dst, stride_item, stride_component, cap, &
                                           n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      type(vbgpd_selection), intent(in), optional :: selection
      type(c_ptr), value :: dst
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_read_selected_f64

    function vbgpd_model_read_selected_i64(model, field, selection, dst, stride_item, stride_component, cap, &
                                           n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      type(vbgpd_selection), intent(in), optional :: selection
      type(c_ptr), value :: dst
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_read_selected_i64

    function vbgpd_model_sample_points(model, field, xy, stride_xy, n, dst, stride_item, stride_component, inside, &
                                       stride_inside) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride_xy
      integer(c_int64_t), value :: n
      type(c_ptr), value :: dst
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      type(c_ptr), value :: inside
      integer(c_int64_t), value :: stride_inside
      integer(c_int32_t) :: outcome
    end function vbgpd_model_sample_points

    function vbgpd_model_sample_line(model, field, x0, y0, x1, y1, n, dst, stride_item, stride_component, inside, &
                                     stride_inside) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      real(c_double), value :: x0
      real(c_double), value :: y0
      real(c_double), value :: x1
      real(c_double), value :: y1
      integer(c_int64_t), value :: n
      type(c_ptr), value :: dst
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      type(c_ptr), value :: inside
      integer(c_int64_t), value :: stride_inside
      integer(c_int32_t) :: outcome
    end function vbgpd_model_sample_line

    function vbgpd_model_sample_grid(model, field, x0, y0, dx, dy, nx, ny, dst, stride_item, stride_component, &
                                     inside, stride_inside) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      real(c_double), value :: x0
      real(c_double), value :: y0
      real(c_double), value :: dx
      real(c_double), value :: dy
      integer(c_int64_t), value :: nx
      integer(c_int64_t), value :: ny
      type(c_ptr), value :: dst
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      type(c_ptr), value :: inside
      integer(c_int64_t), value :: stride_inside
      integer(c_int32_t) :: outcome
    end function vbgpd_model_sample_grid

    function vbgpd_model_ground_surface(model, xy, stride, cap, n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_ground_surface

    function vbgpd_model_view_acquire(model, field, view) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      type(vbgpd_view), intent(inout), optional :: view
      integer(c_int32_t) :: outcome
    end function vbgpd_model_view_acquire

    function vbgpd_model_view_release(model, lease) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), value :: lease
      integer(c_int32_t) :: outcome
    end function vbgpd_model_view_release

    function vbgpd_model_state_hash(model, hash) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), intent(inout), optional :: hash
      integer(c_int32_t) :: outcome
    end function vbgpd_model_state_hash

    ! ---- events
    function vbgpd_model_events_read(model, after, dst, stride, cap, n, dropped) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), value :: after
      type(c_ptr), value :: dst
      integer(c_int64_t), value :: stride
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: n
      integer(c_int64_t), intent(inout), optional :: dropped
      integer(c_int32_t) :: outcome
    end function vbgpd_model_events_read

    ! ---- setting from outside: stays until set again
    function vbgpd_model_write_f64(model, field, selection, src, stride_item, stride_component, &
                                   n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      type(vbgpd_selection), intent(in), optional :: selection
      type(c_ptr), value :: src
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      integer(c_int64_t), value :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_write_f64

    function vbgpd_model_write_points(model, field, xy, stride_xy, src, stride_item, stride_component, &
                                      n) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      type(c_ptr), value :: xy
      integer(c_int64_t), value :: stride_xy
      type(c_ptr), value :: src
      integer(c_int64_t), value :: stride_item
      integer(c_int64_t), value :: stride_component
      integer(c_int64_t), value :: n
      integer(c_int32_t) :: outcome
    end function vbgpd_model_write_points

    function vbgpd_model_write_grid(model, field, x0, y0, dx, dy, nx, ny, src, stride_item) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int32_t), value :: field
      real(c_double), value :: x0
      real(c_double), value :: y0
      real(c_double), value :: dx
      real(c_double), value :: dy
      integer(c_int64_t), value :: nx
      integer(c_int64_t), value :: ny
      type(c_ptr), value :: src
      integer(c_int64_t), value :: stride_item
      integer(c_int32_t) :: outcome
    end function vbgpd_model_write_grid

    function vbgpd_model_set_load(model, load_id, pressure, pressure_end) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), value :: load_id
      real(c_double), value :: pressure
      real(c_double), value :: pressure_end
      integer(c_int32_t) :: outcome
    end function vbgpd_model_set_load

    function vbgpd_model_set_boundary_velocity(model, boundary_id, vx, vy) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), value :: boundary_id
      real(c_double), value :: vx
      real(c_double), value :: vy
      integer(c_int32_t) :: outcome
    end function vbgpd_model_set_boundary_velocity

    function vbgpd_model_set_layer_active(model, layer_id, active) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), value :: layer_id
      integer(c_int32_t), value :: active
      integer(c_int32_t) :: outcome
    end function vbgpd_model_set_layer_active

    function vbgpd_model_boundary_reaction(model, boundary_id, fx, fy) result(outcome) bind(C)
      import
      type(c_ptr), value :: model
      integer(c_int64_t), value :: boundary_id
      real(c_double), intent(inout), optional :: fx
      real(c_double), intent(inout), optional :: fy
      integer(c_int32_t) :: outcome
    end function vbgpd_model_boundary_reaction
  end interface
end module vbgpd_c
