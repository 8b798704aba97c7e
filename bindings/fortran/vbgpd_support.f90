! What the four objects share: how a call ends, texts, and arrays seen through byte strides.
module vbgpd_support
  use vbgpd_c
  implicit none
  private
  public :: conclude, refuse, read_error, error_reader, vbgpd_text, vbgpd_status_text
  public :: point_view, accept_points, byte_distance, number_text, copied_handle
  public :: vbgpd_hear, log_hearer, tell_line, vbgpd_go_on, listener, tell, find_field, item_view, view_of_items, view_of_values

  ! The shape of vbgpd_context_error and its three sisters.
  abstract interface
    function error_reader(object, info, text, cap, needed) result(outcome) bind(C)
      import
      type(c_ptr), value :: object
      type(vbgpd_error_info), intent(inout), optional :: info
      character(kind=c_char), intent(inout), optional :: text(*)
      integer(c_int64_t), value :: cap
      integer(c_int64_t), intent(inout), optional :: needed
      integer(c_int32_t) :: outcome
    end function error_reader
  end interface

  interface
    pure function strlen(text) result(length) bind(C)
      import
      type(c_ptr), value, intent(in) :: text
      integer(c_size_t) :: length
    end function strlen
  end interface

  ! A progress function of the program; .false. stops the run, which can be continued.
  abstract interface
    function vbgpd_go_on(progress) result(go_on)
      import :: vbgpd_progress
      type(vbgpd_progress), intent(in) :: progress
      logical :: go_on
    end function vbgpd_go_on
  end interface

  ! A function of the program that is told the lines of the log.
  abstract interface
    subroutine vbgpd_hear(line, text)
      import :: vbgpd_log_line
      type(vbgpd_log_line), intent(in) :: line
      character(*), intent(in) :: text
    end subroutine vbgpd_hear
  end interface

  type :: log_hearer
    procedure(vbgpd_hear), pointer, nopass :: hear => null()
  end type log_hearer

  type :: listener
    procedure(vbgpd_go_on), pointer, nopass :: go_on => null()
  end type listener

  ! n points as the C face takes them; packed holds a copy when y does not lie 8 bytes behind x.
  type :: point_view
    type(c_ptr) :: address = c_null_ptr
    integer(c_int64_t) :: stride = 16, n = 0
    real(c_double), allocatable :: packed(:, :)
  end type point_view

  ! Items of a field as the C face takes them, in place.
  type :: item_view
    type(c_ptr) :: first = c_null_ptr
    integer(c_int64_t) :: row = 0, column = 0, n = 0
  end type item_view

contains

  ! values(component, item)
  function view_of_items(values) result(view)
    real(c_double), intent(in), target :: values(:, :)
    type(item_view) :: view
    view%n = size(values, 2, c_int64_t)
    if (size(values) == 0) return
    view%first = c_loc(values(1, 1))
    if (size(values, 2) > 1) view%row = byte_distance(view%first, c_loc(values(1, 2)))
    if (size(values, 1) > 1) view%column = byte_distance(view%first, c_loc(values(2, 1)))
  end function view_of_items

  ! values(item)
  function view_of_values(values) result(view)
    real(c_double), intent(in), target :: values(:)
    type(item_view) :: view
    view%n = size(values, kind=c_int64_t)
    if (size(values) == 0) return
    view%first = c_loc(values(1))
    if (size(values) > 1) view%row = byte_distance(view%first, c_loc(values(2)))
  end function view_of_values

  ! A NUL-terminated text of the library, e.g. the name in a vbgpd_field_info.
  function vbgpd_text(address) result(text)
    type(c_ptr), intent(in) :: address
    character(:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: i
    if (.not. c_associated(address)) then
      text = ""
      return
    end if
    call c_f_pointer(address, letters, [strlen(address)])
    allocate (character(size(letters)) :: text)
    do i = 1, size(letters)
      text(i:i) = letters(i)
    end do
  end function vbgpd_text

  function vbgpd_status_text(status) result(text)
    integer(c_int32_t), intent(in) :: status
    character(:), allocatable :: text
    text = vbgpd_text(vbgpd_status_name(status))
  end function vbgpd_status_text

  function number_text(number) result(text)
    integer(c_int64_t), intent(in) :: number
    character(:), allocatable :: text
    character(20) :: digits
    write (digits, "(i0)") number
    text = trim(digits)
  end function number_text

  ! The last failure on an object; outcome VBGPD_END_OF_DATA and an empty text when there was none.
  subroutine read_error(reader, handle, info, text, outcome)
    procedure(error_reader) :: reader
    type(c_ptr), intent(in) :: handle
    type(vbgpd_error_info), intent(inout) :: info
    character(:), allocatable, intent(out) :: text
    integer(c_int32_t), intent(out) :: outcome
    character(:), allocatable :: buffer
    integer(c_int64_t) :: needed
    needed = 0
    text = ""
    outcome = reader(handle, cap=0_c_int64_t, needed=needed)
    if (outcome /= VBGPD_OK) return
    allocate (character(needed + 1) :: buffer)
    outcome = reader(handle, info, buffer, needed + 1)
    if (outcome == VBGPD_OK) text = buffer(:needed)
  end subroutine read_error

  ! Ends every call of the face: the status goes to stat, the words of the object to failure or, without stat, to error
  ! stop. Every method hands failure on to its errmsg itself: gfortran 12 loses the length of an optional text of
  ! deferred length that is passed from one procedure to the next as optional.
  subroutine conclude(status, reader, handle, stat, failure)
    integer(c_int32_t), intent(in) :: status
    procedure(error_reader) :: reader
    type(c_ptr), intent(in) :: handle
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout) :: failure
    type(vbgpd_error_info) :: info
    character(:), allocatable :: text
    integer(c_int32_t) :: outcome
    if (status >= 0) then
      if (present(stat)) stat = status
      return
    end if
    call read_error(reader, handle, info, text, outcome)
    if (outcome /= VBGPD_OK .or. info%status /= status) text = unrecorded(status)
    call refuse(status, text, stat, failure)
  end subroutine conclude

  subroutine refuse(status, text, stat, failure)
    integer(c_int32_t), intent(in) :: status
    character(*), intent(in) :: text
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout) :: failure
    failure = text
    if (.not. present(stat)) error stop text
    stat = status
  end subroutine refuse

  ! Statuses that leave no record on an object.
  function unrecorded(status) result(text)
    integer(c_int32_t), intent(in) :: status
    character(:), allocatable :: text
    select case (status)
    case (VBGPD_E_HANDLE)
      text = "This object was not created yet or is already destroyed."
    case (VBGPD_E_BUSY)
      text = "Another thread is inside this object."
    case (VBGPD_E_REENTRANT)
      text = "A progress function must not call back into the object it reports on."
    case default
      text = "The call failed with " // vbgpd_status_text(status) // "."
    end select
  end function unrecorded

  function tell(user, progress) result(stop_now) bind(C)
    type(c_ptr), value :: user
    type(vbgpd_progress), intent(in) :: progress
    integer(c_int32_t) :: stop_now
    type(listener), pointer :: hearer
    call c_f_pointer(user, hearer)
    stop_now = merge(0_c_int32_t, 1_c_int32_t, hearer%go_on(progress))
  end function tell

  subroutine tell_line(user, line, text) bind(C)
    type(c_ptr), value :: user
    type(vbgpd_log_line), intent(in) :: line
    character(kind=c_char), intent(in), optional :: text(*)
    type(log_hearer), pointer :: hearer
    character(247) :: words
    integer :: n
    call c_f_pointer(user, hearer)
    words = ""
    do n = 1, len(words)
      if (text(n) == c_null_char) exit
      words(n:n) = text(n)
    end do
    call hearer%hear(line, words(:n - 1))
  end subroutine tell_line

  function byte_distance(from, to) result(bytes)
    type(c_ptr), intent(in) :: from, to
    integer(c_int64_t) :: bytes
    bytes = transfer(to, 0_c_intptr_t) - transfer(from, 0_c_intptr_t)
  end function byte_distance

  ! xy(2, n), any section of an array, seen in place where possible; the view lives as long as xy and itself.
  function accept_points(xy, view, stat, failure) result(accepted)
    real(c_double), intent(in), target :: xy(:, :)
    type(point_view), intent(inout), target :: view
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout) :: failure
    logical :: accepted
    accepted = size(xy, 1) == 2
    if (.not. accepted) then
      call refuse(VBGPD_E_ARGUMENT, "The array of points has " // number_text(size(xy, 1, c_int64_t)) // &
                  " rows; it needs two, x and y.", stat, failure)
      return
    end if
    view%n = size(xy, 2, c_int64_t)
    if (view%n == 0) return
    if (byte_distance(c_loc(xy(1, 1)), c_loc(xy(2, 1))) == 8) then
      view%address = c_loc(xy(1, 1))
      if (view%n > 1) view%stride = byte_distance(c_loc(xy(1, 1)), c_loc(xy(1, 2)))
    else
      view%packed = xy
      view%address = c_loc(view%packed)
    end if
  end function accept_points

  ! The C face knows nothing of the array's extent within an item: rows must be as many as the field has components.
  function find_field(field, rows, id, stat, failure) result(found)
    character(*), intent(in) :: field
    integer, intent(in) :: rows
    integer(c_int32_t), intent(out) :: id
    integer(c_int32_t), intent(out), optional :: stat
    character(:), allocatable, intent(inout) :: failure
    logical :: found
    type(vbgpd_field_info) :: info
    integer(c_int32_t) :: status
    id = -1
    status = vbgpd_field_find(field, len_trim(field, c_int64_t), id)
    if (status == VBGPD_OK) status = vbgpd_field_info_at(int(id, c_int64_t), info)
    found = status == VBGPD_OK .and. info%components == rows
    if (status /= VBGPD_OK) then
      call refuse(status, "There is no field named """ // trim(field) // """.", stat, failure)
    else if (.not. found) then
      call refuse(VBGPD_E_ARGUMENT, "The field """ // trim(field) // """ has " // &
                  number_text(int(info%components, c_int64_t)) // " components per item; the array has room for " // &
                  number_text(int(rows, c_int64_t)) // ".", stat, failure)
    end if
  end function find_field

  ! A handle has one owner, whose end destroys the object: copies are a mistake of the program.
  subroutine copied_handle(what)
    character(*), intent(in) :: what
    error stop "A " // what // " cannot be copied by assignment; pass it as an argument."
  end subroutine copied_handle
end module vbgpd_support
