! Slope profiles: polygons, materials, loads, supports, and what is wrong with them.
module vbgpd_profiles
  use vbgpd_c
  use vbgpd_contexts, only: vbgpd_context
  use vbgpd_support
  implicit none
  private
  public :: vbgpd_profile

  type :: vbgpd_profile
    type(c_ptr) :: handle = c_null_ptr ! for calls of module vbgpd_c
  contains
    procedure :: create
    procedure :: create_from_flatbuffer
    procedure :: to_flatbuffer
    procedure :: destroy
    procedure :: set_exterior
    procedure :: add_material
    procedure :: add_layer
    procedure :: add_boundary
    procedure :: add_load
    procedure :: set_water_table
    procedure :: water_table
    procedure, private :: set_number, set_text, get_number, get_text
    generic :: set => set_number, set_text
    generic :: get => get_number, get_text
    procedure :: count => count_parts
    procedure :: polygon
    procedure :: validate
    procedure :: issue
    procedure :: last_error
    procedure, private :: copy
    generic :: assignment(=) => copy
    final :: finalize
  end type vbgpd_profile

contains

  subroutine create(self, context, stat, errmsg)
    class(vbgpd_profile), intent(inout) :: self
    class(vbgpd_context), intent(in) :: context
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(c_ptr) :: fresh
    integer(c_int32_t) :: status
    fresh = c_null_ptr
    status = vbgpd_profile_create(context%handle, fresh)
    call adopt(self, fresh, status)
    call conclude(status, vbgpd_context_error, context%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine create

  ! A scene as a flatbuffer, e.g. a file read into bytes.
  subroutine create_from_flatbuffer(self, context, bytes, stat, errmsg)
    class(vbgpd_profile), intent(inout) :: self
    class(vbgpd_context), intent(in) :: context
    integer(c_int8_t), intent(in), contiguous, target :: bytes(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(c_ptr) :: fresh, first
    integer(c_int32_t) :: status
    fresh = c_null_ptr
    first = c_null_ptr
    if (size(bytes) > 0) first = c_loc(bytes)
    status = vbgpd_profile_create_from_flatbuffer(context%handle, first, size(bytes, kind=c_int64_t), fresh)
    call adopt(self, fresh, status)
    call conclude(status, vbgpd_context_error, context%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine create_from_flatbuffer

  ! The profile as a scene flatbuffer.
  subroutine to_flatbuffer(self, bytes, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    integer(c_int8_t), allocatable, target, intent(inout) :: bytes(:)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int64_t) :: needed
    integer(c_int32_t) :: status
    needed = 0
    status = vbgpd_profile_to_flatbuffer(self%handle, c_null_ptr, 0_c_int64_t, needed)
    if (status >= 0) then
      if (allocated(bytes)) deallocate (bytes)
      allocate (bytes(needed))
      status = vbgpd_profile_to_flatbuffer(self%handle, c_loc(bytes), needed, needed)
    end if
    call conclude(status, vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine to_flatbuffer

  subroutine adopt(self, fresh, status)
    class(vbgpd_profile), intent(inout) :: self
    type(c_ptr), intent(in) :: fresh
    integer(c_int32_t), intent(in) :: status
    integer(c_int32_t) :: ignored
    if (status < 0) return
    ignored = vbgpd_profile_destroy(self%handle)
    self%handle = fresh
  end subroutine adopt

  subroutine destroy(self, stat, errmsg)
    class(vbgpd_profile), intent(inout) :: self
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int32_t) :: status
    status = vbgpd_profile_destroy(self%handle)
    call conclude(status, vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
    if (status >= 0) self%handle = c_null_ptr
  end subroutine destroy

  ! xy(2, n): the outline, any winding.
  subroutine set_exterior(self, xy, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    real(c_double), intent(in), target :: xy(:, :)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(point_view), target :: view
    if (.not. accept_points(xy, view, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    call conclude(vbgpd_profile_set_exterior(self%handle, view%address, view%stride, view%n), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_exterior

  subroutine add_material(self, name, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    character(*), intent(in) :: name
    integer(c_int64_t), intent(inout), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_profile_add_material(self%handle, name, len_trim(name, c_int64_t), id), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine add_material

  ! Without xy the layer fills the exterior; later layers overwrite.
  subroutine add_layer(self, material, xy, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    integer(c_int64_t), intent(in) :: material
    real(c_double), intent(in), target, optional :: xy(:, :)
    integer(c_int64_t), intent(inout), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(point_view), target :: view
    if (present(xy)) then
      if (.not. accept_points(xy, view, stat, failure)) then
        if (present(errmsg)) errmsg = failure
        return
      end if
    end if
    call conclude(vbgpd_profile_add_layer(self%handle, view%address, view%stride, view%n, material, id), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine add_layer

  ! Either side ("base", "left", "right") or xy, a polyline along the exterior.
  subroutine add_boundary(self, kind, side, xy, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    integer(c_int32_t), intent(in) :: kind
    character(*), intent(in), optional :: side
    real(c_double), intent(in), target, optional :: xy(:, :)
    integer(c_int64_t), intent(inout), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(point_view), target :: view
    integer(c_int64_t) :: length
    length = 0
    if (present(side)) length = len_trim(side, c_int64_t)
    if (present(xy)) then
      if (.not. accept_points(xy, view, stat, failure)) then
        if (present(errmsg)) errmsg = failure
        return
      end if
    end if
    call conclude(vbgpd_profile_add_boundary(self%handle, side, length, view%address, view%stride, view%n, kind, id), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine add_boundary

  ! Pressure downwards on the ground surface from x0 to x1, linear to pressure_end where that is given.
  subroutine add_load(self, x0, x1, pressure, pressure_end, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    real(c_double), intent(in) :: x0, x1, pressure
    real(c_double), intent(in), optional :: pressure_end
    integer(c_int64_t), intent(inout), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    real(c_double) :: last
    last = pressure
    if (present(pressure_end)) last = pressure_end
    call conclude(vbgpd_profile_add_load(self%handle, x0, x1, pressure, last, id), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine add_load

  ! set and get: of the profile itself, or of the part id of that object_kind (VBGPD_OBJECT_MATERIAL ...).
  subroutine set_number(self, name, value, object_kind, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), intent(in) :: value
    integer(c_int32_t), intent(in), optional :: object_kind
    integer(c_int64_t), intent(in), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_profile_set_f64(self%handle, kind_of(object_kind), id_of(id), &
                                        name, len_trim(name, c_int64_t), value), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_number

  subroutine get_number(self, name, value, object_kind, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    character(*), intent(in) :: name
    real(c_double), intent(inout) :: value
    integer(c_int32_t), intent(in), optional :: object_kind
    integer(c_int64_t), intent(in), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_profile_get_f64(self%handle, kind_of(object_kind), id_of(id), &
                                        name, len_trim(name, c_int64_t), value), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine get_number

  subroutine set_text(self, name, value, object_kind, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    character(*), intent(in) :: name, value
    integer(c_int32_t), intent(in), optional :: object_kind
    integer(c_int64_t), intent(in), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_profile_set_text(self%handle, kind_of(object_kind), id_of(id), &
                                         name, len_trim(name, c_int64_t), value, len_trim(value, c_int64_t)), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_text

  subroutine get_text(self, name, value, object_kind, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    character(*), intent(in) :: name
    character(:), allocatable, intent(inout) :: value
    integer(c_int32_t), intent(in), optional :: object_kind
    integer(c_int64_t), intent(in), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    character(:), allocatable :: buffer
    integer(c_int64_t) :: needed, length
    integer(c_int32_t) :: status
    needed = 0
    length = len_trim(name, c_int64_t)
    status = vbgpd_profile_get_text(self%handle, kind_of(object_kind), id_of(id), name, length, &
                                    cap=0_c_int64_t, needed=needed)
    if (status == VBGPD_OK) then
      allocate (character(needed + 1) :: buffer)
      status = vbgpd_profile_get_text(self%handle, kind_of(object_kind), id_of(id), name, length, buffer, needed + 1)
      if (status == VBGPD_OK) value = buffer(:needed)
    end if
    call conclude(status, vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine get_text

  pure function kind_of(object_kind) result(kind)
    integer(c_int32_t), intent(in), optional :: object_kind
    integer(c_int32_t) :: kind
    kind = VBGPD_OBJECT_PROFILE
    if (present(object_kind)) kind = object_kind
  end function kind_of

  pure function id_of(given) result(id)
    integer(c_int64_t), intent(in), optional :: given
    integer(c_int64_t) :: id
    id = 0
    if (present(given)) id = given
  end function id_of

  subroutine count_parts(self, object_kind, n, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    integer(c_int32_t), intent(in) :: object_kind
    integer(c_int64_t), intent(inout) :: n
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_profile_count(self%handle, object_kind, n), vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine count_parts

  ! xy(2, n): the exterior, or the polygon of a layer, or the polyline of a boundary.
  subroutine polygon(self, xy, object_kind, id, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    real(c_double), allocatable, target, intent(inout) :: xy(:, :)
    integer(c_int32_t), intent(in), optional :: object_kind
    integer(c_int64_t), intent(in), optional :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int64_t) :: n
    integer(c_int32_t) :: status
    n = 0
    status = vbgpd_profile_polygon(self%handle, kind_of(object_kind), id_of(id), c_null_ptr, 16_c_int64_t, &
                                   0_c_int64_t, n)
    if (status == VBGPD_OK) then
      if (allocated(xy)) deallocate (xy)
      allocate (xy(2, n))
      if (n > 0) status = vbgpd_profile_polygon(self%handle, kind_of(object_kind), id_of(id), c_loc(xy), 16_c_int64_t, &
                                                n, n)
    end if
    call conclude(status, vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine polygon

  ! xy(2, n): ground water, hydrostatic below this line (left to right over the whole section); n = 0: dry.
  subroutine set_water_table(self, xy, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    real(c_double), intent(in), target :: xy(:, :)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    type(point_view), target :: view
    if (.not. accept_points(xy, view, stat, failure)) then
      if (present(errmsg)) errmsg = failure
      return
    end if
    call conclude(vbgpd_profile_set_water_table(self%handle, view%address, view%stride, view%n), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine set_water_table

  ! xy(2, n): its points.
  subroutine water_table(self, xy, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    real(c_double), allocatable, target, intent(inout) :: xy(:, :)
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    integer(c_int64_t) :: n
    integer(c_int32_t) :: status
    n = 0
    status = vbgpd_profile_water_table(self%handle, c_null_ptr, 16_c_int64_t, 0_c_int64_t, n)
    if (status == VBGPD_OK) then
      if (allocated(xy)) deallocate (xy)
      allocate (xy(2, n))
      if (n > 0) status = vbgpd_profile_water_table(self%handle, c_loc(xy), 16_c_int64_t, n, n)
    end if
    call conclude(status, vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine water_table

  ! Finds every fault; errors forbid a model, warnings do not. issue lists them.
  subroutine validate(self, errors, warnings, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    integer(c_int64_t), intent(inout), optional :: errors, warnings
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    call conclude(vbgpd_profile_validate(self%handle, errors, warnings), &
                  vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine validate

  ! Issue i, from 0, of the last validate; stat VBGPD_END_OF_DATA and an empty text past the last.
  subroutine issue(self, i, info, text, stat, errmsg)
    class(vbgpd_profile), intent(in) :: self
    integer(c_int64_t), intent(in) :: i
    type(vbgpd_error_info), intent(inout) :: info
    character(:), allocatable, intent(out) :: text
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout), optional :: errmsg
    character(:), allocatable :: failure
    character(:), allocatable :: buffer
    integer(c_int64_t) :: needed
    integer(c_int32_t) :: status
    needed = 0
    text = ""
    status = vbgpd_profile_issue(self%handle, i, cap=0_c_int64_t, needed=needed)
    if (status == VBGPD_OK) then
      allocate (character(needed + 1) :: buffer)
      status = vbgpd_profile_issue(self%handle, i, info, buffer, needed + 1)
      if (status == VBGPD_OK) text = buffer(:needed)
    end if
    call conclude(status, vbgpd_profile_error, self%handle, stat, failure)
    if (present(errmsg) .and. allocated(failure)) errmsg = failure
  end subroutine issue

  ! The last failure on this object; stat VBGPD_END_OF_DATA when there was none.
  subroutine last_error(self, info, text, stat)
    class(vbgpd_profile), intent(in) :: self
    type(vbgpd_error_info), intent(inout) :: info
    character(:), allocatable, intent(out) :: text
    integer(c_int32_t), intent(out) :: stat
    call read_error(vbgpd_profile_error, self%handle, info, text, stat)
  end subroutine last_error

  subroutine copy(self, other)
    class(vbgpd_profile), intent(inout) :: self
    class(vbgpd_profile), intent(in) :: other
    if (same_type_as(self, other)) call copied_handle("profile")
  end subroutine copy

  impure elemental subroutine finalize(self)
    type(vbgpd_profile), intent(inout) :: self
    integer(c_int32_t) :: ignored
    ignored = vbgpd_profile_destroy(self%handle)
    self%handle = c_null_ptr
  end subroutine finalize
end module vbgpd_profiles
