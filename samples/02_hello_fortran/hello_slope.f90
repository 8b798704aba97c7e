! The factor of safety of a slope given by four corners, in Fortran.
program hello_slope
  use vbgpd
  implicit none

  ! Griffiths and Lane (1999), example 1: 10 m high, 2 to 1, c = 10 kPa, phi = 20 degrees; their answer is 1.4.
  real(c_double), parameter :: corners(2, 4) = reshape([real(c_double) :: 0, 0, 32, 0, 12, 10, 0, 10], [2, 4])
  character(*), parameter :: names(5) = [character(14) :: "unit_weight", "young_modulus", "poisson_ratio", "cohesion", &
                                         "friction_angle"]
  real(c_double), parameter :: values(5) = [20d3, 1d8, 0.3d0, 10d3, 20d0] ! SI units
  type(vbgpd_context) :: context
  type(vbgpd_profile) :: slope
  type(vbgpd_model) :: model
  type(vbgpd_job) :: job
  integer(c_int64_t) :: clay
  integer(c_int32_t) :: status
  real(c_double) :: fs, error
  integer :: i

  call context%create() ! a call that fails ends the program with the engine's sentence; stat and errmsg would catch it
  call slope%create(context)
  call slope%set_exterior(corners)
  call slope%add_material("clay", clay)
  do i = 1, size(names)
    call slope%set(names(i), values(i), VBGPD_OBJECT_MATERIAL, clay)
  end do
  call slope%add_layer(clay) ! fills the section; base fixed, rollers at the sides
  call slope%set("spacing", 0.5d0)

  call model%create(context, slope)
  call job%create_strength_reduction(model)
  call job%run(stat=status)
  call job%get("factor_of_safety", fs)
  call job%get("error_estimate", error)
  write (*, "(a, f5.3, a, f5.3, a)") "factor of safety ", fs, ", error estimate ", error, &
    " (" // vbgpd_status_text(status) // ")"
  if (status /= VBGPD_OK) error stop 1
end program hello_slope
