! Jobs: equilibrium, strength reduction or run-out, advanced in slices; their results.
module vbgpd_jobs
  use vbgpd_c
  use vbgpd_base_models, only: vbgpd_base_model
  use vbgpd_support
  implicit none
  private
  public :: vbgpd_job

  type :: vbgpd_job
    type(c_ptr) :: handle = c_null_ptr ! for calls of module vbgpd_c
  contains
    procedure :: create_equilibrium
    procedure :: create_strength_reduction
    procedure :: create_runout
    procedure :: destroy
    procedure :: set => set_number
    procedure :: run
    procedure :: cancel
    procedure, private :: get_number, get_text
    generic :: get => get_number, get_text
    procedure :: trial
    procedure :: level
    procedure :: slip_surface
    procedure :: last_error
    procedure, private :: copy
    generic :: assignment(=) => copy
    final :: finalize
  end type vbgpd_job

contains

  subroutine create_equilibrium(self, model, stat, errmsg)
    class(vbgpd_job), intent(inout) :: self
    class(vbgpd_base_model), intent(in) :: model
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(c_ptr) :: fresh
    integer(c_int32_t) :: status
    fresh = c_null_ptr
    status = vbgpd_job_create_equilibrium(model%handle, fresh)
    call adopt(self, fresh, status)
    call conclude(status, vbgpd_model_error, model%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine create_equilibrium

  subroutine create_strength_reduction(self, model, stat, errmsg)
    class(vbgpd_job), intent(inout) :: self
    class(vbgpd_base_model), intent(in) :: model
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(c_ptr) :: fresh
    integer(c_int32_t) :: status
    fresh = c_null_ptr
    status = vbgpd_job_create_strength_reduction(model%handle, fresh)
    call adopt(self, fresh, status)
    call conclude(status, vbgpd_model_error, model%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine create_strength_reduction

  ! The model must be a run-out model (create_runout of vbgpd_model).
  subroutine create_runout(self, model, stat, errmsg)
    class(vbgpd_job), intent(inout) :: self
    class(vbgpd_base_model), intent(in) :: model
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(c_ptr) :: fresh
    integer(c_int32_t) :: status
    fresh = c_null_ptr
    status = vbgpd_job_create_runout(model%handle, fresh)
    call adopt(self, fresh, status)
    call conclude(status, vbgpd_model_error, model%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine create_runout

  subroutine adopt(self, fresh, status)
    class(vbgpd_job), intent(inout) :: self
    type(c_ptr), intent(in) :: fresh
    integer(c_int32_t), intent(in) :: status
    integer(c_int32_t) :: ignored
    if (status < 0) return
    ignored = vbgpd_job_destroy(self%handle)
    self%handle = fresh
  end subroutine adopt

  subroutine destroy(self, stat, errmsg)
    class(vbgpd_job), intent(inout) :: self
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int32_t) :: status
    status = vbgpd_job_destroy(self%handle)
    call conclude(status, vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
    if (status >= 0) self%handle = c_null_ptr
  end subroutine destroy

  subroutine set_number(self, name, value, stat, errmsg)
    class(vbgpd_job), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), intent(in) :: value
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_job_set_f64(self%handle, name, len_trim(name, c_int64_t), value), &
                  vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_number

  ! Without wall_seconds to the end. stat: VBGPD_OK finished, VBGPD_LIMIT_REACHED or VBGPD_CANCELLED call again,
  ! VBGPD_NOT_CONVERGED and VBGPD_UNSTABLE finished with that outcome. go_on hears of progress about ten times a second.
  subroutine run(self, wall_seconds, go_on, progress, stat, errmsg)
    class(vbgpd_job), intent(in) :: self
    real(c_double), intent(in), optional :: wall_seconds
    procedure(vbgpd_go_on), optional :: go_on
    type(vbgpd_progress), intent(inout), optional :: progress
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(listener), target :: user
    type(c_funptr) :: teller
    real(c_double) :: limit
    limit = 0
    if (present(wall_seconds)) limit = wall_seconds
    teller = c_null_funptr
    if (present(go_on)) then
      user%go_on => go_on
      teller = c_funloc(tell)
    end if
    call conclude(vbgpd_job_run(self%handle, limit, teller, c_loc(user), progress), &
                  vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine run

  subroutine cancel(self, stat, errmsg)
    class(vbgpd_job), intent(in) :: self
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_job_cancel(self%handle), vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine cancel

  subroutine get_number(self, name, value, stat, errmsg)
    class(vbgpd_job), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), intent(inout) :: value
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_job_get_f64(self%handle, name, len_trim(name, c_int64_t), value), &
                  vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine get_number

  subroutine get_text(self, name, value, stat, errmsg)
    class(vbgpd_job), intent(in) :: self
    character(*), intent(in) :: name
    character(:), allocatable, intent(inout) :: value
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    character(:), allocatable :: buffer
    integer(c_int64_t) :: needed, length
    integer(c_int32_t) :: status
    needed = 0
    length = len_trim(name, c_int64_t)
    status = vbgpd_job_get_text(self%handle, name, length, cap=0_c_int64_t, needed=needed)
    if (status == VBGPD_OK) then
      allocate (character(needed + 1) :: buffer)
      status = vbgpd_job_get_text(self%handle, name, length, buffer, needed + 1)
      if (status == VBGPD_OK) value = buffer(:needed)
    end if
    call conclude(status, vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine get_text

  ! Trial i, from 0, in the order they were made; stat VBGPD_END_OF_DATA past the last.
  subroutine trial(self, i, record, stat, errmsg)
    class(vbgpd_job), intent(in) :: self
    integer(c_int64_t), intent(in) :: i
    type(vbgpd_trial), intent(inout) :: record
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_job_trial(self%handle, i, record), vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine trial

  ! Grid i, 0 = coarsest; stat VBGPD_END_OF_DATA past the last.
  subroutine level(self, i, record, stat, errmsg)
    class(vbgpd_job), intent(in) :: self
    integer(c_int64_t), intent(in) :: i
    type(vbgpd_level), intent(inout) :: record
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_job_level(self%handle, i, record), vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine level

  ! xy(2, n) from left to right; no points when there is none.
  subroutine slip_surface(self, xy, stat, errmsg)
    class(vbgpd_job), intent(in) :: self
    real(c_double), allocatable, target, intent(inout) :: xy(:, :)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int64_t) :: n
    integer(c_int32_t) :: status
    n = 0
    status = vbgpd_job_slip_surface(self%handle, c_null_ptr, 16_c_int64_t, 0_c_int64_t, n)
    if (status == VBGPD_OK) then
      if (allocated(xy)) deallocate (xy)
      allocate (xy(2, n))
      if (n > 0) status = vbgpd_job_slip_surface(self%handle, c_loc(xy), 16_c_int64_t, n, n)
    end if
    call conclude(status, vbgpd_job_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine slip_surface

  ! The last failure on this object; stat VBGPD_END_OF_DATA when there was none.
  subroutine last_error(self, info, text, stat)
    class(vbgpd_job), intent(in) :: self
    type(vbgpd_error_info), intent(inout) :: info
    character(:), allocatable, intent(out) :: text
    integer(c_int32_t), intent(out) :: stat
    call read_error(vbgpd_job_error, self%handle, info, text, stat)
  end subroutine last_error

  subroutine copy(self, other)
    class(vbgpd_job), intent(inout) :: self
    class(vbgpd_job), intent(in) :: other
    if (same_type_as(self, other)) call copied_handle("job")
  end subroutine copy

  impure elemental subroutine finalize(self)
    type(vbgpd_job), intent(inout) :: self
    integer(c_int32_t) :: ignored
    ignored = vbgpd_job_destroy(self%handle)
    self%handle = c_null_ptr
  end subroutine finalize
end module vbgpd_jobs
