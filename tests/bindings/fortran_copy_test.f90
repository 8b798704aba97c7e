! A handle has one owner: assignment ends the program instead of leaving two variables with one object.
program fortran_copy_test
  use vbgpd
  implicit none
  type(vbgpd_context) :: context, other
  call context%create()
  other = context
  write (*, "(a)") "a handle was copied"
end program fortran_copy_test
