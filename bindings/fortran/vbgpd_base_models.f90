! Models: particles and virtual bonds, at a time; stepping, named numbers, fields as a whole. vbgpd_model extends this
! type by everything for coupling.
module vbgpd_base_models
  use vbgpd_c
  use vbgpd_contexts, only: vbgpd_context
  use vbgpd_profiles, only: vbgpd_profile
  use vbgpd_support
  implicit none
  private
  public :: vbgpd_base_model

  type :: vbgpd_base_model
    type(c_ptr) :: handle = c_null_ptr ! for calls of module vbgpd_c
  contains
    procedure :: create
    procedure :: destroy
    procedure :: set => set_number
    procedure :: get => get_number
    procedure :: plan
    procedure :: memory
    procedure :: step
    procedure :: advance_to
    procedure :: epoch
    procedure :: cancel
    procedure :: item_count
    procedure, private :: read_f64_column, read_f64_rows, read_i64_column, read_i64_rows
    generic :: read => read_f64_column, read_f64_rows, read_i64_column, read_i64_rows
    procedure :: state_hash
    procedure :: last_error
    procedure, private :: copy
    generic :: assignment(=) => copy
    final :: finalize
  end type vbgpd_base_model

contains

  ! Of a faulty profile errmsg has every error.
  subroutine create(self, context, profile, stat, errmsg)
    class(vbgpd_base_model), intent(inout) :: self
    class(vbgpd_context), intent(in) :: context
    class(vbgpd_profile), intent(in) :: profile
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(c_ptr) :: fresh
    integer(c_int32_t) :: status, ignored
    fresh = c_null_ptr
    status = vbgpd_model_create(context%handle, profile%handle, fresh)
    if (status >= 0) then
      ignored = vbgpd_model_destroy(self%handle)
      self%handle = fresh
    end if
    call conclude(status, vbgpd_context_error, context%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine create

  subroutine destroy(self, stat, errmsg)
    class(vbgpd_base_model), intent(inout) :: self
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int32_t) :: status
    status = vbgpd_model_destroy(self%handle)
    call conclude(status, vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
    if (status >= 0) self%handle = c_null_ptr
  end subroutine destroy

  subroutine set_number(self, name, value, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), intent(in) :: value
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_set_f64(self%handle, name, len_trim(name, c_int64_t), value), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_number

  subroutine get_number(self, name, value, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), intent(inout) :: value
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_get_f64(self%handle, name, len_trim(name, c_int64_t), value), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine get_number

  ! Feature i from 0, used or left out; stat VBGPD_END_OF_DATA past the last. vbgpd_text(record%name) is its name.
  subroutine plan(self, i, record, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    integer(c_int64_t), intent(in) :: i
    type(vbgpd_feature), intent(inout) :: record
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_plan(self%handle, i, record), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine plan

  ! The bytes of the model by what they are for.
  subroutine memory(self, record, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    type(vbgpd_memory), intent(inout) :: record
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_memory(self%handle, record), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine memory

  ! Explicit dynamic steps with true masses at the stable time step.
  subroutine step(self, steps, report, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    integer(c_int64_t), intent(in) :: steps
    type(vbgpd_advance_result), intent(inout), optional :: report
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_step(self%handle, steps, report), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine step

  ! To an exact time, in slices where wall_seconds are given. stat: VBGPD_OK there, VBGPD_LIMIT_REACHED or VBGPD_CANCELLED
  ! call again with the same time. go_on hears of progress about ten times a second.
  subroutine advance_to(self, time, wall_seconds, go_on, report, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    real(c_double), intent(in) :: time
    real(c_double), intent(in), optional :: wall_seconds
    procedure(vbgpd_go_on), optional :: go_on
    type(vbgpd_advance_result), intent(inout), optional :: report
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
    call conclude(vbgpd_model_advance_to(self%handle, time, limit, teller, c_loc(user), report), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine advance_to

  ! Grows whenever particles are added, removed or stored in another order.
  subroutine epoch(self, n, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    integer(c_int64_t), intent(inout) :: n
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_epoch(self%handle, n), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine epoch

  subroutine cancel(self, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_cancel(self%handle), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine cancel

  ! location: VBGPD_AT_PARTICLE or VBGPD_AT_BOND.
  subroutine item_count(self, location, n, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    integer(c_int32_t), intent(in) :: location
    integer(c_int64_t), intent(inout) :: n
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_item_count(self%handle, location, n), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine item_count

  ! read(field, values): values(component, item), or values(item) of a field with one component; any section of an
  ! array, written in place. n is the number of items there are; an array for no items asks for that only.
  subroutine read_f64_rows(self, field, values, n, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(inout), target :: values(:, :)
    integer(c_int64_t), intent(inout), optional :: n
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(item_view) :: view
    integer(c_int32_t) :: id
    if (.not. find_field(field, size(values, 1), id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    view = view_of_items(values)
    call conclude(vbgpd_model_read_f64(self%handle, id, view%first, view%row, view%column, view%n, n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine read_f64_rows

  subroutine read_f64_column(self, field, values, n, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(inout), target :: values(:)
    integer(c_int64_t), intent(inout), optional :: n
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(item_view) :: view
    integer(c_int32_t) :: id
    if (.not. find_field(field, 1, id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    view = view_of_values(values)
    call conclude(vbgpd_model_read_f64(self%handle, id, view%first, view%row, view%column, view%n, n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine read_f64_column

  subroutine read_i64_rows(self, field, values, n, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    character(*), intent(in) :: field
    integer(c_int64_t), intent(inout), target :: values(:, :)
    integer(c_int64_t), intent(inout), optional :: n
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int64_t) :: row, column
    integer(c_int32_t) :: id
    type(c_ptr) :: first
    if (.not. find_field(field, size(values, 1), id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    row = 0
    column = 0
    first = c_null_ptr
    if (size(values) > 0) first = c_loc(values(1, 1))
    if (size(values) > 0 .and. size(values, 2) > 1) row = byte_distance(first, c_loc(values(1, 2)))
    if (size(values) > 0 .and. size(values, 1) > 1) column = byte_distance(first, c_loc(values(2, 1)))
    call conclude(vbgpd_model_read_i64(self%handle, id, first, row, column, size(values, 2, c_int64_t), n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine read_i64_rows

  subroutine read_i64_column(self, field, values, n, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    character(*), intent(in) :: field
    integer(c_int64_t), intent(inout), target :: values(:)
    integer(c_int64_t), intent(inout), optional :: n
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int64_t) :: row
    integer(c_int32_t) :: id
    type(c_ptr) :: first
    if (.not. find_field(field, 1, id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    row = 0
    first = c_null_ptr
    if (size(values) > 0) first = c_loc(values(1))
    if (size(values) > 1) row = byte_distance(first, c_loc(values(2)))
    call conclude(vbgpd_model_read_i64(self%handle, id, first, row, 0_c_int64_t, size(values, kind=c_int64_t), n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine read_i64_column

  ! The 64 bits of the hash; as an unsigned number they may be beyond huge(hash).
  subroutine state_hash(self, hash, stat, errmsg)
    class(vbgpd_base_model), intent(in) :: self
    integer(c_int64_t), intent(inout) :: hash
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_state_hash(self%handle, hash), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine state_hash

  ! The last failure on this object; stat VBGPD_END_OF_DATA when there was none.
  subroutine last_error(self, info, text, stat)
    class(vbgpd_base_model), intent(in) :: self
    type(vbgpd_error_info), intent(inout) :: info
    character(:), allocatable, intent(out) :: text
    integer(c_int32_t), intent(out) :: stat
    call read_error(vbgpd_model_error, self%handle, info, text, stat)
  end subroutine last_error

  subroutine copy(self, other)
    class(vbgpd_base_model), intent(inout) :: self
    class(vbgpd_base_model), intent(in) :: other
    if (same_type_as(self, other)) call copied_handle("model")
  end subroutine copy

  impure elemental subroutine finalize(self)
    type(vbgpd_base_model), intent(inout) :: self
    integer(c_int32_t) :: ignored
    ignored = vbgpd_model_destroy(self%handle)
    self%handle = c_null_ptr
  end subroutine finalize
end module vbgpd_base_models
