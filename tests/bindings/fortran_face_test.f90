! What Fortran does by itself: texts, errmsg, arrays of a wrong shape, the end of scopes; then a failure without stat.
program fortran_face_test
  use vbgpd
  implicit none
  type(vbgpd_context) :: context
  type(vbgpd_profile) :: profile
  type(vbgpd_model) :: model, moving
  character(:), allocatable :: errmsg, text
  character(20) :: padded = "spacing"
  real(c_double) :: three_rows(3, 4) = 0, columns(4, 2) = 0, value, stress(3, 10), none(4, 0), nothing(2, 0), sampled(4, 4)
  real(c_double), allocatable :: xy(:, :), velocity(:, :)
  real(c_double), pointer :: first(:), second(:)
  integer(c_int64_t) :: n, lease, marks(4)
  integer(c_int32_t) :: stat

  call profile%set("spacing", 1.0_c_double, stat=stat, errmsg=errmsg)
  call expect(stat == VBGPD_E_HANDLE .and. index(errmsg, "not created") > 0, "an object that was not created says so")
  call expect(len(errmsg) == 56 .and. errmsg == "This object was not created yet or is already destroyed.", &
              "errmsg is as long as what it says")
  call context%create(threads=-1, stat=stat, errmsg=errmsg)
  call expect(stat < 0 .and. index(errmsg, "threads") > 0, "a wrong context is refused with a sentence")
  call context%create()
  call profile%create(context)

  call profile%set_exterior(three_rows, stat, errmsg)
  call expect(stat == VBGPD_E_ARGUMENT .and. index(errmsg, "3 rows") > 0, "points need two rows")
  columns(:, 1) = [0.0_c_double, 32.0_c_double, 12.0_c_double, 0.0_c_double]
  columns(:, 2) = [0.0_c_double, 0.0_c_double, 10.0_c_double, 10.0_c_double]
  call profile%set_exterior(transpose(columns))
  call profile%polygon(xy)
  call expect(same(xy, transpose(columns)), "an outline comes back as it was given")
  three_rows(1, :) = columns(:, 1)
  three_rows(3, :) = columns(:, 2)
  call profile%set_exterior(three_rows(1:3:2, :))
  call profile%polygon(xy)
  call expect(same(xy, transpose(columns)), "y need not lie beside x")

  call profile%add_material("clay" // repeat(" ", 6))
  call profile%get("name", text, VBGPD_OBJECT_MATERIAL)
  call expect(text == "clay" .and. len(text) == 4, "trailing blanks do not count")
  call profile%set(padded, 1.0_c_double)
  call profile%get(padded, value)
  call expect(abs(value - 1) <= 0, "names may be padded")
  call profile%set("unit_weight", 20e3_c_double, VBGPD_OBJECT_MATERIAL)
  call profile%set("cohesion", 10e3_c_double, VBGPD_OBJECT_MATERIAL)
  call profile%add_layer(0_c_int64_t)
  call model%create(context, profile)

  call model%read("stress", stress, stat=stat, errmsg=errmsg)
  call expect(stat == VBGPD_E_ARGUMENT .and. index(errmsg, "4 components") > 0, "rows must be as many as components")
  call model%read("strain", stress, stat=stat, errmsg=errmsg)
  call expect(stat == VBGPD_E_UNKNOWN_NAME .and. index(errmsg, "strain") > 0, "an unknown field is named")
  call model%sample("stress", transpose(columns), sampled, marks(:1), stat, errmsg)
  call expect(stat == VBGPD_E_ARGUMENT .and. index(errmsg, "values for 1 places") > 0, "marks are as many as places")
  call model%view("particle_id", lease, first, stat=stat, errmsg=errmsg)
  call expect(stat == VBGPD_E_UNSUPPORTED .and. .not. associated(first), "views are of real numbers")
  call model%set("strength_reduction_factor", 3.0_c_double)
  call moving%create_runout(model)
  call moving%step(20_c_int64_t)
  call moving%view("velocity", lease, first, second)
  n = 0
  call moving%read("velocity", nothing, n)
  allocate (velocity(2, n))
  call moving%read("velocity", velocity)
  call expect(size(first) == size(velocity, 2), "a view has every item")
  call expect(abs(sum(first**2 + second**2) - sum(velocity**2)) <= 1e-12*sum(velocity**2) .and. sum(velocity**2) > 0, &
              "items of a run-out lie apart and are found")
  call moving%release(lease)
  n = 0
  call model%read("stress", none, n)
  call expect(n > 0, "an array for no items asks for their number")
  errmsg = "as before"
  call model%set("damping", 0.5_c_double, stat, errmsg)
  call expect(stat == VBGPD_OK .and. errmsg == "as before", "errmsg is left alone by success")
  call scopes_destroy_their_objects()
  write (*, "(a)") "all expectations met"
  call model%set("dampin", 0.5_c_double) ! ends the program with the engine's sentence
  write (*, "(a)") "a failure without stat went unnoticed"

contains

  pure function same(a, b)
    real(c_double), intent(in) :: a(:, :), b(:, :)
    logical :: same
    same = all(shape(a) == shape(b))
    if (same) same = .not. any(abs(a - b) > 0)
  end function same

  subroutine expect(truth, what)
    logical, intent(in) :: truth
    character(*), intent(in) :: what
    if (.not. truth) error stop "not so: " // what
  end subroutine expect

  subroutine scopes_destroy_their_objects()
    type(c_ptr) :: gone
    integer(c_int64_t) :: parts
    gone = handle_of_a_local_profile()
    call expect(vbgpd_profile_count(gone, VBGPD_OBJECT_LAYER, parts) == VBGPD_E_HANDLE, "objects end with their scope")
  end subroutine scopes_destroy_their_objects

  function handle_of_a_local_profile() result(handle)
    type(c_ptr) :: handle
    type(vbgpd_profile) :: local
    call local%create(context)
    handle = local%handle
  end function handle_of_a_local_profile
end program fortran_face_test
