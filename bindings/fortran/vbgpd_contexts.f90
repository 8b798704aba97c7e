! Contexts: threads and limits.
module vbgpd_contexts
  use vbgpd_c
  use vbgpd_support
  implicit none
  private
  public :: vbgpd_context

  type :: vbgpd_context
    type(c_ptr) :: handle = c_null_ptr ! for calls of module vbgpd_c
    type(log_hearer), pointer, private :: hearer => null()
  contains
    procedure :: create
    procedure :: destroy
    procedure :: last_error
    procedure :: log_next
    procedure :: set_log
    procedure, private :: copy
    generic :: assignment(=) => copy
    final :: finalize
  end type vbgpd_context

contains

  ! threads: workers per model, 0 = all cores, default 1; max_particles, max_bytes (of one model): 0 = no limit.
  subroutine create(self, threads, max_particles, stat, errmsg, max_bytes)
    class(vbgpd_context), intent(inout) :: self
    integer, intent(in), optional :: threads
    integer(c_int64_t), intent(in), optional :: max_particles
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int64_t), intent(in), optional :: max_bytes
    type(vbgpd_context_desc) :: desc
    type(c_ptr) :: fresh
    integer(c_int32_t) :: status, ignored
    fresh = c_null_ptr
    status = vbgpd_context_desc_init(desc, desc%struct_size)
    desc%abi_version = VBGPD_HEADER_ABI_VERSION
    if (present(threads)) desc%threads = int(threads, c_int32_t)
    if (present(max_particles)) desc%max_particles = max_particles
    if (present(max_bytes)) desc%max_bytes = max_bytes
    if (status >= 0) status = vbgpd_context_create(desc, fresh)
    if (status < 0) then
      call refuse(status, fault_of(desc, status), stat, failure)
      if (present(errmsg) .and. allocated(failure)) errmsg = failure
      return
    end if
    ignored = vbgpd_context_destroy(self%handle)
    self%handle = fresh
    if (associated(self%hearer)) deallocate (self%hearer)
    if (present(stat)) stat = status
  end subroutine create

  ! Why the library makes no context of it.
  function fault_of(desc, status) result(text)
    type(vbgpd_context_desc), intent(in) :: desc
    integer(c_int32_t), intent(in) :: status
    character(:), allocatable :: text
    character(1024) :: buffer
    integer(c_int64_t) :: needed
    needed = 0
    text = "The context could not be created: " // vbgpd_status_text(status) // "."
    if (vbgpd_context_desc_check(desc, text=buffer, cap=len(buffer, c_int64_t), needed=needed) == VBGPD_OK) text = buffer(:needed)
  end function fault_of

  subroutine destroy(self, stat, errmsg)
    class(vbgpd_context), intent(inout) :: self
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int32_t) :: status
    status = vbgpd_context_destroy(self%handle)
    call conclude(status, vbgpd_context_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
    if (status < 0) return
    self%handle = c_null_ptr
    if (associated(self%hearer)) deallocate (self%hearer)
  end subroutine destroy

  ! The last failure on this object; stat VBGPD_END_OF_DATA when there was none.
  subroutine last_error(self, info, text, stat)
    class(vbgpd_context), intent(in) :: self
    type(vbgpd_error_info), intent(inout) :: info
    character(:), allocatable, intent(out) :: text
    integer(c_int32_t), intent(out) :: stat
    call read_error(vbgpd_context_error, self%handle, info, text, stat)
  end subroutine last_error

  ! The oldest line of the log with a sequence above `after`; stat VBGPD_END_OF_DATA when there is none.
  subroutine log_next(self, after, line, text, stat, errmsg)
    class(vbgpd_context), intent(in) :: self
    integer(c_int64_t), intent(in) :: after
    type(vbgpd_log_line), intent(inout) :: line
    character(:), allocatable, intent(out) :: text
    integer(c_int32_t), intent(out) :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    character(248) :: buffer
    integer(c_int64_t) :: needed
    integer(c_int32_t) :: status
    needed = 0
    text = ""
    status = vbgpd_context_log_next(self%handle, after, line, buffer, len(buffer, c_int64_t), needed)
    if (status == VBGPD_OK) text = buffer(:needed)
    call conclude(status, vbgpd_context_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine log_next

  ! hear is told every line of that level and below, within the call that says it; without hear nobody is any more.
  subroutine set_log(self, hear, level, stat, errmsg)
    class(vbgpd_context), intent(inout) :: self
    procedure(vbgpd_hear), optional :: hear
    integer(c_int32_t), intent(in), optional :: level
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(log_hearer), pointer :: fresh
    type(c_funptr) :: teller
    type(c_ptr) :: user
    integer(c_int32_t) :: status, most
    most = VBGPD_LOG_INFO
    if (present(level)) most = level
    fresh => null()
    teller = c_null_funptr
    user = c_null_ptr
    if (present(hear)) then
      allocate (fresh)
      fresh%hear => hear
      teller = c_funloc(tell_line)
      user = c_loc(fresh)
    end if
    status = vbgpd_context_set_log(self%handle, teller, user, most)
    if (status >= 0) then
      if (associated(self%hearer)) deallocate (self%hearer)
      self%hearer => fresh
    else if (associated(fresh)) then
      deallocate (fresh)
    end if
    call conclude(status, vbgpd_context_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_log

  subroutine copy(self, other)
    class(vbgpd_context), intent(inout) :: self
    class(vbgpd_context), intent(in) :: other
    if (same_type_as(self, other)) call copied_handle("context")
  end subroutine copy

  impure elemental subroutine finalize(self)
    type(vbgpd_context), intent(inout) :: self
    integer(c_int32_t) :: ignored
    ignored = vbgpd_context_destroy(self%handle)
    self%handle = c_null_ptr
    if (associated(self%hearer)) deallocate (self%hearer)
  end subroutine finalize
end module vbgpd_contexts
