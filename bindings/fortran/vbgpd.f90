! The engine for Fortran 2018: five types whose objects destroy themselves, over the C face of module vbgpd_c.
!
! Every call has stat and errmsg, both optional. With stat a failure is a negative number there and a sentence in
! errmsg; without stat it ends the program with that sentence. Outcomes that are no failure (VBGPD_LIMIT_REACHED ...)
! are positive numbers in stat. Trailing blanks of texts do not count. Points are xy(2, n), ids and indices count from 0.
! Objects cannot be copied by assignment; variables of a main program live to its end unless destroyed.
module vbgpd
  use vbgpd_c
  use vbgpd_contexts, only: vbgpd_context
  use vbgpd_jobs, only: vbgpd_job
  use vbgpd_models, only: vbgpd_model, vbgpd_state
  use vbgpd_profiles, only: vbgpd_profile
  use vbgpd_support, only: vbgpd_go_on, vbgpd_hear, vbgpd_status_text, vbgpd_text
  implicit none
  public
end module vbgpd
