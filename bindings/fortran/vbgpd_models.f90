! Models that partners couple to: setting from outside, selections, sampling, views, states, checkpoints.
module vbgpd_models
  use vbgpd_c
  use vbgpd_base_models, only: vbgpd_base_model
  use vbgpd_contexts, only: vbgpd_context
  use vbgpd_support
  implicit none
  private
  public :: vbgpd_model, vbgpd_state

  ! A saved instant of a model; ends by itself.
  type :: vbgpd_state
    type(c_ptr) :: handle = c_null_ptr ! for calls of module vbgpd_c
  contains
    procedure :: destroy => destroy_state
    procedure, private :: copy => copy_state
    generic :: assignment(=) => copy
    final :: finalize_state
  end type vbgpd_state

  type, extends(vbgpd_base_model) :: vbgpd_model
  contains
    procedure :: save
    procedure :: restore
    procedure :: checkpoint
    procedure :: snapshot
    procedure :: create_from_checkpoint
    procedure :: create_runout
    procedure :: restore_checkpoint
    procedure :: events
    procedure :: select
    procedure, private :: selected_f64_column, selected_f64_rows, selected_i64_column
    generic :: read_selected => selected_f64_column, selected_f64_rows, selected_i64_column
    procedure :: sample
    procedure :: sample_line
    procedure :: sample_grid
    procedure :: ground_surface
    procedure :: view
    procedure :: release
    procedure, private :: write_column, write_rows
    generic :: write => write_column, write_rows
    procedure, private :: write_points_column, write_points_rows
    generic :: write_points => write_points_column, write_points_rows
    procedure :: write_grid
    procedure :: set_load
    procedure :: set_boundary_velocity
    procedure :: set_layer_active
    procedure :: boundary_reaction
  end type vbgpd_model

contains

  ! Everything that changes, into a state; a state that holds one already is written over.
  subroutine save(self, state, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    type(vbgpd_state), intent(inout) :: state
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_save_state(self%handle, state%handle), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine save

  subroutine restore(self, state, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    type(vbgpd_state), intent(in) :: state
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_restore_state(self%handle, state%handle), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine restore

  ! The model with its profile as bytes, for a file (access="stream") or another process.
  subroutine checkpoint(self, bytes, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int8_t), allocatable, target, intent(inout) :: bytes(:)
    integer(c_int64_t) :: needed
    integer(c_int32_t) :: status
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    needed = 0
    status = vbgpd_model_checkpoint(self%handle, c_null_ptr, 0_c_int64_t, needed)
    if (status >= 0) then
      if (allocated(bytes)) deallocate (bytes)
      allocate (bytes(needed))
      status = vbgpd_model_checkpoint(self%handle, c_loc(bytes), needed, needed)
    end if
    call conclude(status, vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine checkpoint

  ! What can be seen of the model, as the bytes of a flatbuffer (snapshot.fbs) for other programs.
  subroutine snapshot(self, bytes, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int8_t), allocatable, target, intent(inout) :: bytes(:)
    integer(c_int64_t) :: needed
    integer(c_int32_t) :: status
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    needed = 0
    status = vbgpd_model_snapshot(self%handle, c_null_ptr, 0_c_int64_t, needed)
    if (status >= 0) then
      if (allocated(bytes)) deallocate (bytes)
      allocate (bytes(needed))
      status = vbgpd_model_snapshot(self%handle, c_loc(bytes), needed, needed)
    end if
    call conclude(status, vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine snapshot

  subroutine create_from_checkpoint(self, context, bytes, stat, errmsg)
    class(vbgpd_model), intent(inout) :: self
    class(vbgpd_context), intent(in) :: context
    integer(c_int8_t), target, contiguous, intent(in) :: bytes(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(c_ptr) :: fresh
    integer(c_int32_t) :: status, ignored
    fresh = c_null_ptr
    status = vbgpd_model_create_from_checkpoint(context%handle, c_loc(bytes), size(bytes, kind=c_int64_t), fresh)
    if (status >= 0) then
      ignored = vbgpd_model_destroy(self%handle)
      self%handle = fresh
    end if
    call conclude(status, vbgpd_context_error, context%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine create_from_checkpoint

  ! Goes on from the present state of another model in updated-Lagrangian form; that one is not changed.
  subroutine create_runout(self, from, stat, errmsg)
    class(vbgpd_model), intent(inout) :: self
    class(vbgpd_model), intent(in) :: from
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(c_ptr) :: fresh
    integer(c_int32_t) :: status, ignored
    fresh = c_null_ptr
    status = vbgpd_model_create_runout(from%handle, fresh)
    call conclude(status, vbgpd_model_error, from%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
    if (status < 0) return
    ignored = vbgpd_model_destroy(self%handle)
    self%handle = fresh
  end subroutine create_runout

  subroutine restore_checkpoint(self, bytes, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int8_t), target, contiguous, intent(in) :: bytes(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_restore_checkpoint(self%handle, c_loc(bytes), size(bytes, kind=c_int64_t)), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine restore_checkpoint

  ! What happened with a sequence above `after`, oldest first.
  subroutine events(self, after, list, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int64_t), intent(in) :: after
    type(vbgpd_event), allocatable, target, intent(inout) :: list(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int64_t) :: n
    integer(c_int32_t) :: status
    n = 0
    status = vbgpd_model_events_read(self%handle, after, c_null_ptr, 0_c_int64_t, 0_c_int64_t, n)
    if (status >= 0) then
      if (allocated(list)) deallocate (list)
      allocate (list(n))
      if (n > 0) status = vbgpd_model_events_read(self%handle, after, c_loc(list), int(list(1)%struct_size, c_int64_t), n, n)
    end if
    call conclude(status, vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine events

  ! The ids of the selected particles.
  subroutine select(self, where, ids, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    type(vbgpd_selection), intent(in) :: where
    integer(c_int64_t), allocatable, target, intent(inout) :: ids(:)
    integer(c_int64_t) :: n
    integer(c_int32_t) :: status
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    n = 0
    status = vbgpd_model_select(self%handle, where, c_null_ptr, 8_c_int64_t, 0_c_int64_t, n)
    if (status >= 0) then
      if (allocated(ids)) deallocate (ids)
      allocate (ids(n))
      if (n > 0) status = vbgpd_model_select(self%handle, where, c_loc(ids), 8_c_int64_t, n, n)
    end if
    call conclude(status, vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine select

  ! read_selected(field, where, values): as read, of the selected particles.
  subroutine selected_f64_rows(self, field, where, values, n, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    type(vbgpd_selection), intent(in) :: where
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
    call conclude(vbgpd_model_read_selected_f64(self%handle, id, where, view%first, view%row, view%column, view%n, n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine selected_f64_rows

  subroutine selected_f64_column(self, field, where, values, n, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    type(vbgpd_selection), intent(in) :: where
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
    call conclude(vbgpd_model_read_selected_f64(self%handle, id, where, view%first, view%row, view%column, view%n, n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine selected_f64_column

  subroutine selected_i64_column(self, field, where, values, n, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    type(vbgpd_selection), intent(in) :: where
    integer(c_int64_t), intent(inout), target :: values(:)
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
    view%n = size(values, kind=c_int64_t)
    if (view%n > 0) view%first = c_loc(values(1))
    if (view%n > 1) view%row = byte_distance(view%first, c_loc(values(2)))
    call conclude(vbgpd_model_read_selected_i64(self%handle, id, where, view%first, view%row, view%column, view%n, n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine selected_i64_column

  ! values(component, place) of a field at xy(2, place); NaN, and inside 0, where no soil is.
  subroutine sample(self, field, xy, values, inside, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(in) :: xy(:, :)
    real(c_double), intent(inout), target :: values(:, :)
    integer(c_int64_t), intent(inout), optional, target :: inside(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(point_view), target :: places
    type(item_view) :: view
    integer(c_int32_t) :: id
    if (.not. find_field(field, size(values, 1), id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    if (.not. accept_points(xy, places, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    if (.not. as_many(size(values, 2, c_int64_t), places%n, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    view = view_of_items(values)
    if (present(inside)) then
      if (.not. as_many(size(inside, kind=c_int64_t), view%n, stat, failure)) then
        if (present(errmsg)) errmsg = failure
        return
      end if
    end if
    call conclude(vbgpd_model_sample_points(self%handle, id, places%address, places%stride, places%n, view%first, &
                                            view%row, view%column, first_mark(inside), mark_stride(inside)), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine sample

  ! As many places at equal distances as values(component, place) has.
  subroutine sample_line(self, field, from, to, values, inside, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(in) :: from(2), to(2)
    real(c_double), intent(inout), target :: values(:, :)
    integer(c_int64_t), intent(inout), optional, target :: inside(:)
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
    if (present(inside)) then
      if (.not. as_many(size(inside, kind=c_int64_t), view%n, stat, failure)) then
        if (present(errmsg)) errmsg = failure
        return
      end if
    end if
    call conclude(vbgpd_model_sample_line(self%handle, id, from(1), from(2), to(1), to(2), view%n, view%first, view%row, &
                                          view%column, first_mark(inside), mark_stride(inside)), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine sample_line

  ! values(component, nx*ny), x runs first.
  subroutine sample_grid(self, field, origin, step, nx, ny, values, inside, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(in) :: origin(2), step(2)
    integer(c_int64_t), intent(in) :: nx, ny
    real(c_double), intent(inout), target :: values(:, :)
    integer(c_int64_t), intent(inout), optional, target :: inside(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(item_view) :: view
    integer(c_int32_t) :: id
    if (.not. find_field(field, size(values, 1), id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    if (.not. as_many(size(values, 2, c_int64_t), nx*ny, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    view = view_of_items(values)
    if (present(inside)) then
      if (.not. as_many(size(inside, kind=c_int64_t), view%n, stat, failure)) then
        if (present(errmsg)) errmsg = failure
        return
      end if
    end if
    call conclude(vbgpd_model_sample_grid(self%handle, id, origin(1), origin(2), step(1), step(2), nx, ny, view%first, &
                                          view%row, view%column, first_mark(inside), mark_stride(inside)), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine sample_grid

  ! The ground surface in its present shape: xy(2, n), left to right.
  subroutine ground_surface(self, xy, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    real(c_double), allocatable, target, intent(inout) :: xy(:, :)
    integer(c_int64_t) :: n
    integer(c_int32_t) :: status
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    n = 0
    status = vbgpd_model_ground_surface(self%handle, c_null_ptr, 16_c_int64_t, 0_c_int64_t, n)
    if (status >= 0) then
      if (allocated(xy)) deallocate (xy)
      allocate (xy(2, n))
      if (n > 0) status = vbgpd_model_ground_surface(self%handle, c_loc(xy), 16_c_int64_t, n, n)
    end if
    call conclude(status, vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine ground_surface

  ! The components of a real field where they are stored, padding included (particle_id says which item is which
  ! particle, by the raw functions). The model does not change until release(lease); do not use the pointers after that.
  subroutine view(self, field, lease, first, second, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    integer(c_int64_t), intent(out) :: lease
    real(c_double), pointer, intent(out) :: first(:)
    real(c_double), pointer, intent(out), optional :: second(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(vbgpd_view) :: lent
    integer(c_int32_t) :: id, status
    nullify (first)
    if (present(second)) nullify (second)
    lease = 0
    if (.not. find_field(field, merge(2, 1, present(second)), id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    status = vbgpd_model_view_acquire(self%handle, id, lent)
    if (status >= 0) then
      if (lent%type /= VBGPD_TYPE_F64) then
        status = vbgpd_model_view_release(self%handle, lent%lease)
        call refuse(VBGPD_E_UNSUPPORTED, "The field '" // field // "' is not of real numbers.", stat, failure)
        if (present(errmsg) .and. allocated(failure)) errmsg = failure
        return
      end if
      lease = lent%lease
      first => items_of(lent, 0_c_int64_t)
      if (present(second)) second => items_of(lent, lent%stride_component)
    end if
    call conclude(status, vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine view

  subroutine release(self, lease, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int64_t), intent(in) :: lease
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_view_release(self%handle, lease), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine release

  ! write(field, values): of all particles by id, or of those selected.
  subroutine write_column(self, field, values, where, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(in), target :: values(:)
    type(vbgpd_selection), intent(in), optional :: where
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
    call conclude(vbgpd_model_write_f64(self%handle, id, where, view%first, view%row, view%column, view%n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine write_column

  ! Values known at xy(2, n), brought to all particles.
  subroutine write_points_column(self, field, xy, values, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(in) :: xy(:, :)
    real(c_double), intent(in), target :: values(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(point_view), target :: places
    type(item_view) :: view
    integer(c_int32_t) :: id
    if (.not. find_field(field, 1, id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    if (.not. accept_points(xy, places, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    view = view_of_values(values)
    if (.not. as_many(view%n, places%n, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    call conclude(vbgpd_model_write_points(self%handle, id, places%address, places%stride, view%first, view%row, &
                                           view%column, places%n), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine write_points_column

  subroutine write_rows(self, field, values, where, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(in), target :: values(:, :)
    type(vbgpd_selection), intent(in), optional :: where
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
    call conclude(vbgpd_model_write_f64(self%handle, id, where, view%first, view%row, view%column, view%n), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine write_rows

  subroutine write_points_rows(self, field, xy, values, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(in) :: xy(:, :)
    real(c_double), intent(in), target :: values(:, :)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(point_view), target :: places
    type(item_view) :: view
    integer(c_int32_t) :: id
    if (.not. find_field(field, size(values, 1), id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    if (.not. accept_points(xy, places, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    view = view_of_items(values)
    if (.not. as_many(view%n, places%n, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    call conclude(vbgpd_model_write_points(self%handle, id, places%address, places%stride, view%first, view%row, &
                                           view%column, places%n), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine write_points_rows

  ! values(nx, ny) at origin + [i, j]*step; NaN = no value.
  subroutine write_grid(self, field, origin, step, values, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    character(*), intent(in) :: field
    real(c_double), intent(in) :: origin(2), step(2)
    real(c_double), intent(in) :: values(:, :)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    real(c_double), allocatable, target :: packed(:, :)
    integer(c_int32_t) :: id
    if (.not. find_field(field, 1, id, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    packed = values
    call conclude(vbgpd_model_write_grid(self%handle, id, origin(1), origin(2), step(1), step(2), &
                                         size(values, 1, c_int64_t), size(values, 2, c_int64_t), c_loc(packed), &
                                         8_c_int64_t), vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine write_grid

  subroutine set_load(self, load, pressure, pressure_end, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int64_t), intent(in) :: load
    real(c_double), intent(in) :: pressure
    real(c_double), intent(in), optional :: pressure_end
    real(c_double) :: at_end
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    at_end = pressure
    if (present(pressure_end)) at_end = pressure_end
    call conclude(vbgpd_model_set_load(self%handle, load, pressure, at_end), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_load

  subroutine set_boundary_velocity(self, boundary, velocity, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int64_t), intent(in) :: boundary
    real(c_double), intent(in) :: velocity(2)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_set_boundary_velocity(self%handle, boundary, velocity(1), velocity(2)), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_boundary_velocity

  ! Excavation (.false.) and fill (.true.).
  subroutine set_layer_active(self, layer, active, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int64_t), intent(in) :: layer
    logical, intent(in) :: active
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_set_layer_active(self%handle, layer, merge(1_c_int32_t, 0_c_int32_t, active)), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_layer_active

  subroutine boundary_reaction(self, boundary, force, stat, errmsg)
    class(vbgpd_model), intent(in) :: self
    integer(c_int64_t), intent(in) :: boundary
    real(c_double), intent(inout) :: force(2)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_model_boundary_reaction(self%handle, boundary, force(1), force(2)), &
                  vbgpd_model_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine boundary_reaction

  function as_many(given, needed, stat, failure) result(fits)
    integer(c_int64_t), intent(in) :: given, needed
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout) :: failure
    logical :: fits
    fits = given == needed
    if (.not. fits) call refuse(VBGPD_E_ARGUMENT, "There are values for " // number_text(given) // " places; there are " // &
                                number_text(needed) // " places.", stat, failure)
  end function as_many

  function first_mark(marks) result(address)
    integer(c_int64_t), intent(in), optional, target :: marks(:)
    type(c_ptr) :: address
    address = c_null_ptr
    if (.not. present(marks)) return
    if (size(marks) > 0) address = c_loc(marks(1))
  end function first_mark

  function mark_stride(marks) result(bytes)
    integer(c_int64_t), intent(in), optional, target :: marks(:)
    integer(c_int64_t) :: bytes
    bytes = 0
    if (.not. present(marks)) return
    if (size(marks) > 1) bytes = byte_distance(c_loc(marks(1)), c_loc(marks(2)))
  end function mark_stride

  ! One component of the items of a view, at the distances they are stored.
  function items_of(lent, offset) result(items)
    type(vbgpd_view), intent(in) :: lent
    integer(c_int64_t), intent(in) :: offset
    real(c_double), pointer :: items(:), every(:)
    integer(c_int64_t) :: step
    step = lent%stride_item/8
    call c_f_pointer(moved(lent%data, offset), every, [max(0_c_int64_t, (lent%count - 1)*step + 1)])
    items => every(1::step)
  end function items_of

  function moved(address, bytes) result(there)
    type(c_ptr), intent(in) :: address
    integer(c_int64_t), intent(in) :: bytes
    type(c_ptr) :: there
    there = transfer(transfer(address, 0_c_intptr_t) + int(bytes, c_intptr_t), c_null_ptr)
  end function moved

  subroutine destroy_state(self, stat, errmsg)
    class(vbgpd_state), intent(inout) :: self
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int32_t) :: status
    status = vbgpd_state_destroy(self%handle)
    if (status < 0) then
      call refuse(status, "The state is in use by another call or already destroyed.", stat, failure)
      if (present(errmsg) .and. allocated(failure)) errmsg = failure
      return
    end if
    self%handle = c_null_ptr
    if (present(stat)) stat = status
  end subroutine destroy_state

  subroutine copy_state(self, other)
    class(vbgpd_state), intent(inout) :: self
    class(vbgpd_state), intent(in) :: other
    if (same_type_as(self, other)) call copied_handle("state")
  end subroutine copy_state

  impure elemental subroutine finalize_state(self)
    type(vbgpd_state), intent(inout) :: self
    integer(c_int32_t) :: ignored
    ignored = vbgpd_state_destroy(self%handle)
    self%handle = c_null_ptr
  end subroutine finalize_state
end module vbgpd_models
