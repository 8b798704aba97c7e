! The conformance transcript in Fortran; it must print what transcript.c prints.
module transcript_lines
  use vbgpd
  implicit none

contains

  pure function hex(value) result(text)
    real(c_double), intent(in) :: value
    character(16) :: text
    write (text, "(z16.16)") transfer(value, 0_c_int64_t)
  end function hex

  pure function hexes(values) result(text)
    real(c_double), intent(in) :: values(:)
    character(17*size(values)) :: text
    integer :: i
    do i = 1, size(values)
      text(17*i - 16:17*i) = " " // hex(values(i))
    end do
  end function hexes

  pure function num(value) result(text)
    integer(c_int64_t), intent(in) :: value
    character(:), allocatable :: text
    character(20) :: digits
    write (digits, "(i0)") value
    text = trim(digits)
  end function num

  pure function num32(value) result(text)
    integer(c_int32_t), intent(in) :: value
    character(:), allocatable :: text
    text = num(1_c_int64_t*value)
  end function num32

  ! Rotate and exclusive or over words of 64 bits, in memory order.
  pure function checksum(words) result(text)
    integer(c_int64_t), intent(in) :: words(:)
    character(16) :: text
    integer(c_int64_t) :: total, i
    total = 0
    do i = 1, size(words)
      total = ieor(ishftc(total, 1), words(i))
    end do
    write (text, "(z16.16)") total
  end function checksum

  pure function words_of(values) result(words)
    real(c_double), intent(in) :: values(:, :)
    integer(c_int64_t) :: words(size(values))
    words = transfer(values, words)
  end function words_of

  subroutine say(text)
    character(*), intent(in) :: text
    write (*, "(a)") text
  end subroutine say

  subroutine begin(text)
    character(*), intent(in) :: text
    write (*, "(a)", advance="no") text
  end subroutine begin

  subroutine say_info(what, status, info, text)
    character(*), intent(in) :: what, text
    integer(c_int32_t), intent(in) :: status
    type(vbgpd_error_info), intent(in) :: info
    call say(what // " " // num32(status) // ": status " // num32(info%status) // " kind " // &
             num32(info%object_kind) // " id " // num(info%object_id) // &
             " item " // num(info%item) // " at" // hexes([info%x, info%y]) // &
             " value " // hex(info%value) // ": " // text)
  end subroutine say_info

  subroutine say_failure(status, info, text)
    integer(c_int32_t), intent(in) :: status
    type(vbgpd_error_info), intent(in) :: info
    character(*), intent(in) :: text
    call begin("argument " // num32(info%argument) // " of ")
    call say_info("failure", status, info, text)
  end subroutine say_failure

  subroutine profile_failed(profile, status)
    type(vbgpd_profile), intent(in) :: profile
    integer(c_int32_t), intent(in) :: status
    type(vbgpd_error_info) :: info
    character(:), allocatable :: text
    integer(c_int32_t) :: outcome
    call profile%last_error(info, text, outcome)
    call say_failure(status, info, text)
  end subroutine profile_failed

  subroutine model_failed(model, status)
    type(vbgpd_model), intent(in) :: model
    integer(c_int32_t), intent(in) :: status
    type(vbgpd_error_info) :: info
    character(:), allocatable :: text
    integer(c_int32_t) :: outcome
    call model%last_error(info, text, outcome)
    call say_failure(status, info, text)
  end subroutine model_failed

  subroutine say_numbers(model, names)
    type(vbgpd_model), intent(in) :: model
    character(*), intent(in) :: names(:)
    real(c_double) :: value
    integer :: i
    do i = 1, size(names)
      call model%get(names(i), value)
      call begin(" " // hex(value))
    end do
  end subroutine say_numbers

  subroutine say_job_numbers(job, names)
    type(vbgpd_job), intent(in) :: job
    character(*), intent(in) :: names(:)
    real(c_double) :: value
    integer :: i
    do i = 1, size(names)
      call job%get(names(i), value)
      call begin(" " // hex(value))
    end do
  end subroutine say_job_numbers

  subroutine say_hash(model)
    type(vbgpd_model), intent(in) :: model
    integer(c_int64_t) :: hash
    character(16) :: text
    call model%state_hash(hash)
    write (text, "(z16.16)") hash
    call say(" hash " // text)
  end subroutine say_hash
end module transcript_lines

module transcript_steps
  use transcript_lines
  implicit none
  integer(c_int32_t) :: lines_heard = 0
  real(c_double), parameter :: outline(2, 6) = &
    reshape([real(c_double) :: 0, 0, 40, 0, 40, 5, 25, 5, 15, 15, 0, 15], [2, 6])
  integer :: calls = 0

contains

  subroutine step_tables()
    type(vbgpd_property_info) :: p
    type(vbgpd_field_info) :: f
    integer(c_int64_t) :: n, i
    integer(c_int32_t) :: kind, found, s
    character(:), allocatable :: name
    character(200) :: built
    call say("01 version " // num32(vbgpd_version_number()) // " " // num32(vbgpd_abi_version()) // " " // &
             vbgpd_text(vbgpd_version_string()))
    built = ""
    s = vbgpd_build_info("compiler", 8_c_int64_t, built, len(built, c_int64_t), n)
    call say("   built " // num32(s) // " " // num(n) // " " // built(:n))
    call say("02 status " // vbgpd_status_text(VBGPD_E_RANGE) // " " // vbgpd_status_text(VBGPD_NOT_CONVERGED) // &
             " " // vbgpd_status_text(12345))
    do kind = VBGPD_OBJECT_PROFILE, VBGPD_OBJECT_JOB
      n = -1
      s = vbgpd_property_count(kind, n)
      call say("03 properties of kind " // num32(kind) // ": " // num(n))
      do i = 0, n - 1
        s = vbgpd_property_info_at(kind, i, p)
        call say("   " // vbgpd_text(p%name) // " [" // vbgpd_text(p%unit) // "] " // num32(p%required) // &
                 hexes([p%default_value, p%min_value, p%max_value]) // " " // num32(p%min_open) // " " // &
                 num32(p%max_open) // " " // vbgpd_text(p%doc))
      end do
    end do
    s = vbgpd_field_count(n)
    do i = 0, n - 1
      s = vbgpd_field_info_at(i, f)
      name = vbgpd_text(f%name)
      s = vbgpd_field_find(name, len(name, c_int64_t), found)
      call say("04 field " // num32(found) // " " // name // " [" // vbgpd_text(f%unit) // "] type " // &
               num32(f%type) // " at " // num32(f%location) // &
               " of " // num32(f%components) // " writable " // num32(f%writable) // ": " // vbgpd_text(f%doc))
    end do
  end subroutine step_tables

  subroutine step_context(context)
    type(vbgpd_context), intent(inout) :: context
    type(vbgpd_context_desc) :: desc
    type(vbgpd_error_info) :: info
    type(c_ptr) :: other
    integer(c_int32_t) :: s, t, e
    character(:), allocatable :: text
    other = c_null_ptr
    s = vbgpd_context_desc_init(desc, desc%struct_size)
    desc%abi_version = 99
    s = vbgpd_context_create(desc, other)
    call context%create(max_particles=100000_c_int64_t, stat=t)
    call context%last_error(info, text, e)
    call say("05 context " // num32(s) // " " // num32(t) // " " // num32(e))
  end subroutine step_context

  subroutine step_issues(profile)
    type(vbgpd_profile), intent(in) :: profile
    type(vbgpd_error_info) :: info
    integer(c_int64_t) :: errors, warnings, i
    integer(c_int32_t) :: s
    character(:), allocatable :: text
    call profile%validate(errors, warnings, s)
    call say("validate " // num32(s) // " errors " // num(errors) // " warnings " // num(warnings))
    i = 0
    do
      call profile%issue(i, info, text, s)
      if (s /= VBGPD_OK) exit
      call say_info("   issue", 0, info, text)
      i = i + 1
    end do
  end subroutine step_issues

  subroutine step_profile(context, profile)
    type(vbgpd_context), intent(in) :: context
    type(vbgpd_profile), intent(in) :: profile
    real(c_double), parameter :: rows(3, 4) = &
      reshape([real(c_double) :: 0, 0, -7, 10, 10, -7, 10, 0, -7, 0, 10, -7], [3, 4])
    real(c_double) :: bow_tie(3, 4), corners(3, 7), v(3)
    real(c_double), allocatable :: xy(:, :)
    type(vbgpd_model) :: model
    type(vbgpd_error_info) :: info
    character(:), allocatable :: text
    character(9) :: small
    integer(c_int64_t) :: needed, id
    integer(c_int32_t) :: s, ignored
    call profile%set("name", "Böschung 斜面", stat=s)
    call profile%get("name", text)
    call say("06 name " // num32(s) // " " // num(len(text, c_int64_t)) // " " // text)
    bow_tie = rows
    call profile%set_exterior(bow_tie(1:2, :), s)
    call begin("07 bow tie " // num32(s) // " ")
    call step_issues(profile)
    call profile%set_exterior(outline(:, 6:1:-1), s)
    corners = 99
    call profile%polygon(xy)
    corners(1:2, 1:size(xy, 2)) = xy
    call say("08 outline backwards " // num32(s) // ": " // num(size(xy, 2, c_int64_t)) // " points, checksum " // &
             checksum(words_of(corners)))
    call profile%set_water_table(outline(:, 1:2), s)
    call profile%water_table(xy)
    call begin("08 water table " // num32(s) // ": " // num(size(xy, 2, c_int64_t)) // " points, then ")
    call profile%set_water_table(outline(:, 1:0), s)
    call profile%water_table(xy)
    call say(num32(s) // ": " // num(size(xy, 2, c_int64_t)))
    call profile%add_material("soil", id, s)
    call begin("09 material " // num32(s) // " id " // num(id) // ", again: ")
    call profile%add_material("soil", id, s)
    call profile_failed(profile, s)
    call begin("10 unknown name: ")
    call profile%set("cohesin", 1.0_c_double, VBGPD_OBJECT_MATERIAL, 0_c_int64_t, s)
    call profile_failed(profile, s)
    small = "untouched"
    s = vbgpd_profile_get_text(profile%handle, VBGPD_OBJECT_MATERIAL, 0_c_int64_t, "law", 3_c_int64_t, small, &
                               3_c_int64_t, needed)
    call begin("11 small buffer " // num32(s) // " needed " // num(needed) // " " // small // ": ")
    call profile_failed(profile, s)
    call model%create(context, profile, s)
    call context%last_error(info, text, ignored)
    call begin("12 model of half a profile: ")
    call say_failure(s, info, text)
    call profile%set("unit_weight", 20e3_c_double, VBGPD_OBJECT_MATERIAL)
    call profile%set("cohesion", 12e3_c_double, VBGPD_OBJECT_MATERIAL)
    call profile%set("friction_angle", 20.0_c_double, VBGPD_OBJECT_MATERIAL)
    call profile%set("spacing", 1.25_c_double)
    call profile%set("srf_tolerance", 0.05_c_double)
    call profile%get("young_modulus", v(1), VBGPD_OBJECT_MATERIAL)
    call profile%get("tension_cutoff", v(2), VBGPD_OBJECT_MATERIAL)
    call profile%get("spacing", v(3))
    call say("13 numbers" // hexes(v))
  end subroutine step_profile

  subroutine step_parts(profile)
    type(vbgpd_profile), intent(in) :: profile
    real(c_double), parameter :: base(2, 2) = reshape([real(c_double) :: 0, 0, 40, 0], [2, 2])
    integer(c_int64_t) :: layer, side, line, load, n(4)
    integer(c_int32_t) :: s(5), i
    call profile%add_layer(0_c_int64_t, id=layer, stat=s(1))
    call profile%add_boundary(VBGPD_BOUNDARY_FIXED, xy=base, id=line, stat=s(2))
    call profile%add_boundary(VBGPD_BOUNDARY_ROLLER, "left", id=side, stat=s(3))
    call profile%add_boundary(VBGPD_BOUNDARY_ROLLER, "right", stat=s(4))
    call profile%add_load(2.0_c_double, 8.0_c_double, 5e3_c_double, id=load, stat=s(5))
    do i = 1, 4
      call profile%count(VBGPD_OBJECT_MATERIAL + i - 1, n(i))
    end do
    call begin("14 parts " // num32(s(1)) // " " // num32(s(2)) // " " // num32(s(3)) // " " // num32(s(4)) // " " // &
               num32(s(5)) // " ids " // num(layer) // " " // num(line) // " " // num(side) // " " // num(load))
    call begin(" counts " // num(n(1)) // " " // num(n(2)) // " " // num(n(3)) // " " // num(n(4)) // " ")
    call step_issues(profile)
  end subroutine step_parts

  function run_in_slices(job) result(s)
    type(vbgpd_job), intent(in) :: job
    integer(c_int32_t) :: s
    do
      call job%run(0.05_c_double, stat=s)
      if (s /= VBGPD_LIMIT_REACHED) exit
    end do
  end function run_in_slices

  subroutine step_equilibrium(model)
    type(vbgpd_model), intent(in) :: model
    type(vbgpd_job) :: job
    integer(c_int32_t) :: created, s
    call job%create_equilibrium(model, created)
    s = run_in_slices(job)
    call begin("16 equilibrium " // num32(created) // " " // num32(s))
    call say_job_numbers(job, [character(22) :: "unbalanced_force_ratio", "max_displacement", "displacement_level", &
                               "steps"])
    call say_hash(model)
  end subroutine step_equilibrium

  subroutine step_field(model, i)
    type(vbgpd_model), intent(in) :: model
    integer(c_int64_t), intent(in) :: i
    type(vbgpd_field_info) :: f
    integer(c_int64_t) :: items, n
    integer(c_int64_t), allocatable :: whole(:, :)
    real(c_double), allocatable :: values(:, :)
    integer(c_int32_t) :: s
    s = vbgpd_field_info_at(i, f)
    call model%item_count(f%location, items)
    allocate (whole(f%components, items), values(f%components, items))
    if (f%type == VBGPD_TYPE_I64 .and. f%components == 1) then
      call model%read(vbgpd_text(f%name), whole(1, :), n, s)
    else if (f%type == VBGPD_TYPE_I64) then
      call model%read(vbgpd_text(f%name), whole, n, s)
    else if (f%components == 1) then
      call model%read(vbgpd_text(f%name), values(1, :), n, s)
    else
      call model%read(vbgpd_text(f%name), values, n, s)
    end if
    if (f%type /= VBGPD_TYPE_I64) whole = reshape(words_of(values), shape(whole))
    call say("17 " // vbgpd_text(f%name) // " " // num32(s) // " " // num(n) // " " // &
             checksum(reshape(whole, [size(whole)])))
  end subroutine step_field

  subroutine step_fields(model)
    type(vbgpd_model), intent(in) :: model
    integer(c_int64_t) :: fields, i, items, n
    real(c_double), allocatable :: wide(:, :)
    integer(c_int64_t), allocatable :: whole(:)
    integer(c_int32_t) :: s
    s = vbgpd_field_count(fields)
    do i = 0, fields - 1
      call step_field(model, i)
    end do
    call model%item_count(VBGPD_AT_PARTICLE, items)
    allocate (wide(6, 2*items), whole(items))
    wide = 7
    call model%read("stress", wide(5:2:-1, 1::2), n, s)
    call say("18 strided stress " // num32(s) // " " // num(n) // " " // checksum(words_of(wide)))
    call begin("19 whole numbers of a real field: ")
    call model%read("volume", whole, stat=s)
    call model_failed(model, s)
  end subroutine step_fields

  subroutine step_plan(model)
    type(vbgpd_model), intent(in) :: model
    type(vbgpd_feature) :: f
    integer(c_int64_t) :: i
    integer(c_int32_t) :: s
    i = 0
    do
      call model%plan(i, f, s)
      if (s /= VBGPD_OK) exit
      call say("21 " // num32(f%used) // " " // vbgpd_text(f%name) // " " // num(f%bytes) // &
               hexes([f%bytes_per_particle, f%bytes_per_bond]))
      i = i + 1
    end do
  end subroutine step_plan

  subroutine step_dynamics(model)
    type(vbgpd_model), intent(in) :: model
    type(vbgpd_advance_result) :: r
    integer(c_int32_t) :: s, t
    call model%set("damping", 0.25_c_double)
    call model%step(5_c_int64_t, r, s)
    call begin("20 steps " // num32(s) // " " // num(r%steps) // hexes([r%time, r%time_step, r%kinetic_energy, &
               r%unbalanced_force_ratio, r%max_displacement, r%max_velocity]) // " " // num(r%plastic_bonds))
    call say_hash(model)
    call model%cancel(s)
    call model%step(5_c_int64_t, r, t)
    call begin("21 cancelled " // num32(s) // " " // num32(t) // " " // num(r%steps) // ", minus one step: ")
    call model%step(-1_c_int64_t, stat=s)
    call model_failed(model, s)
  end subroutine step_dynamics

  subroutine step_strength_reduction(model, job)
    type(vbgpd_model), intent(in) :: model
    type(vbgpd_job), intent(in) :: job
    character(*), parameter :: texts(5) = [character(9) :: "status", "reason", "scheme", "reduced", "flow_rule"]
    type(vbgpd_error_info) :: info
    character(:), allocatable :: text
    real(c_double), allocatable :: xy(:, :)
    integer(c_int32_t) :: s, ignored
    integer :: i
    call job%set("levels", 1.0_c_double, s)
    call begin("22 option " // num32(s) // ", unknown: ")
    call job%set("level", 1.0_c_double, s)
    call job%last_error(info, text, ignored)
    call say_failure(s, info, text)
    s = run_in_slices(job)
    call begin("23 strength reduction " // num32(s))
    call say_job_numbers(job, [character(18) :: "factor_of_safety", "srf_stable", "srf_unstable", &
                               "displacement_level", "sliding_area", "levels", "trials", "steps", "particles", "bonds"])
    call say_hash(model)
    do i = 1, size(texts)
      call job%get(texts(i), text)
      call say("   " // trim(texts(i)) // ": " // text)
    end do
    call say_trials(job)
    call say_levels(job)
    call job%slip_surface(xy, s)
    call say("26 slip surface " // num32(s) // " " // num(size(xy, 2, c_int64_t)) // " " // checksum(words_of(xy)))
  end subroutine step_strength_reduction

  subroutine say_trials(job)
    type(vbgpd_job), intent(in) :: job
    type(vbgpd_trial) :: t
    integer(c_int64_t) :: i
    integer(c_int32_t) :: s
    i = 0
    do
      call job%trial(i, t, s)
      if (s /= VBGPD_OK) exit
      call say("24 trial " // num32(t%level) // " " // num32(t%verdict) // " " // num32(t%band_connected) // &
               hexes([t%strength_reduction_factor, t%unbalanced_force_ratio, t%unbalanced_force_slope, &
                      t%displacement_level, t%displacement_growth, t%power_ratio]) // " " // num(t%steps))
      i = i + 1
    end do
    call say("   then " // num32(s))
  end subroutine say_trials

  subroutine say_levels(job)
    type(vbgpd_job), intent(in) :: job
    type(vbgpd_level) :: l
    integer(c_int64_t) :: i
    integer(c_int32_t) :: s
    i = 0
    do
      call job%level(i, l, s)
      if (s /= VBGPD_OK) exit
      call say("25 level" // hexes([l%spacing_x, l%spacing_y]) // " " // num(l%particles) // " " // num(l%bonds) // &
               " " // num(l%steps) // " " // num(l%trials) // hexes([l%srf_stable, l%srf_unstable, l%factor_of_safety]))
      i = i + 1
    end do
    call say("   then " // num32(s))
  end subroutine say_levels

  function stop_at_once(progress) result(go_on)
    type(vbgpd_progress), intent(in) :: progress
    logical :: go_on
    if (progress%fraction >= 0 .and. progress%fraction <= 1) calls = calls + 1
    go_on = .false.
  end function stop_at_once

  ! So fine a grid takes far longer than the tenth of a second after which the function is called.
  subroutine step_progress(context, profile)
    type(vbgpd_context), intent(in) :: context
    type(vbgpd_profile), intent(in) :: profile
    type(vbgpd_model) :: model
    type(vbgpd_job) :: job
    integer(c_int32_t) :: s
    call profile%set("spacing", 0.25_c_double)
    call model%create(context, profile)
    call job%create_strength_reduction(model)
    call job%run(go_on=stop_at_once, stat=s)
    call begin("27 stopped by the progress function " // num32(s) // " after " // num32(calls) // ", ")
    call job%cancel()
    call job%run(stat=s)
    call say("cancelled " // num32(s))
  end subroutine step_progress

  subroutine say_advance(what, model, time)
    character(*), intent(in) :: what
    type(vbgpd_model), intent(in) :: model
    real(c_double), intent(in) :: time
    type(vbgpd_advance_result) :: r
    integer(c_int32_t) :: s
    call model%advance_to(time, report=r, stat=s)
    call begin(what // " " // num32(s) // " " // num(r%steps) // hexes([r%time, r%time_step]))
    call say_hash(model)
  end subroutine say_advance

  subroutine step_states(model)
    type(vbgpd_model), intent(in) :: model
    ! 2 columns of 3 values, the water table at the level of the toe
    real(c_double), parameter :: water(2, 3) = reshape([50d3, 50d3, 0d0, 0d0, -50d3, -50d3], [2, 3])
    type(vbgpd_state) :: state
    integer(c_int64_t) :: epoch
    integer(c_int32_t) :: s(3)
    call say_advance("28 advanced", model, 0.03125_c_double)
    call model%save(state, s(1))
    call model%save(state, s(2))
    call model%write_grid("pore_pressure", [0d0, 0d0], [40d0, 5d0], water, s(3))
    call say("29 saved " // num32(s(1)) // " again " // num32(s(2)) // ", water " // num32(s(3)))
    call say_advance("   with water", model, 0.0625_c_double)
    call model%restore(state, s(1))
    call begin("   back " // num32(s(1)))
    call say_hash(model)
    call say_advance("   without", model, 0.0625_c_double)
    call model%epoch(epoch)
    call state%destroy(s(1))
    call begin("   epoch " // num(epoch) // ", destroyed " // num32(s(1)) // ", backwards: ")
    call model%advance_to(0d0, stat=s(1))
    call model_failed(model, s(1))
  end subroutine step_states

  subroutine step_selections(model)
    type(vbgpd_model), intent(in) :: model
    real(c_double), target :: corners(2, 4)
    type(vbgpd_selection) :: soil, part
    integer(c_int64_t), allocatable :: ids(:), material(:)
    real(c_double), allocatable :: u(:, :)
    integer(c_int64_t) :: n
    integer(c_int32_t) :: s
    corners = reshape([10d0, 2d0, 30d0, 2d0, 30d0, 8d0, 10d0, 8d0], [2, 4])
    soil%kind = VBGPD_SELECT_SOIL
    part%kind = VBGPD_SELECT_POLYGON
    part%xy = c_loc(corners)
    part%xy_stride = 16
    part%n_points = 4
    call model%select(soil, ids, s)
    call begin("30 soil " // num32(s) // " " // num(size(ids, kind=c_int64_t)) // " " // checksum(ids))
    call model%select(part, ids, s)
    call begin(" polygon " // num32(s) // " " // num(size(ids, kind=c_int64_t)) // " " // checksum(ids))
    allocate (u(2, size(ids)), material(size(ids)))
    call model%read_selected("displacement", part, u, n, s)
    call begin(" displacement " // num32(s) // " " // num(n) // " " // checksum(words_of(u)))
    call model%read_selected("material", part, material, n, s)
    call say(" material " // num32(s) // " " // num(n) // " " // checksum(material))
  end subroutine step_selections

  subroutine step_samples(model)
    type(vbgpd_model), intent(in) :: model
    real(c_double), parameter :: places(2, 3) = reshape([5d0, 5d0, 20d0, 4d0, 20d0, 14d0], [2, 3])
    real(c_double) :: points(4, 3), line(4, 6), grid(1, 12)
    real(c_double), allocatable :: ground(:, :)
    real(c_double), pointer :: ux(:), uy(:)
    integer(c_int64_t) :: inside(12), lease
    integer(c_int32_t) :: s
    call model%sample("stress", places, points, inside(1:3), s)
    call begin("31 points " // num32(s) // " " // checksum(words_of(points(:, 1:2))) // " " // checksum(inside(1:3)))
    call model%sample_line("stress", [2d0, 1d0], [12d0, 11d0], line, stat=s)
    call begin(" line " // num32(s) // " " // checksum(words_of(line)))
    call model%sample_grid("plastic_strain", [1d0, 1d0], [3d0, 1d0], 4_c_int64_t, 3_c_int64_t, grid, inside, s)
    call begin(" grid " // num32(s) // " " // checksum(words_of(grid)) // " " // checksum(inside))
    call model%ground_surface(ground, s)
    call say(" ground " // num32(s) // " " // num(size(ground, 2, c_int64_t)) // " " // checksum(words_of(ground)))
    call model%view("displacement", lease, ux, uy, s)
    call begin("   view " // num32(s) // hexes([min(0d0, minval(ux), minval(uy))]) // ", held: ")
    call model%step(1_c_int64_t, stat=s)
    call model_failed(model, s)
    call model%release(lease, s)
    call say("   released " // num32(s))
  end subroutine step_samples

  subroutine step_outside(model)
    type(vbgpd_model), intent(in) :: model
    real(c_double), parameter :: places(2, 3) = reshape([0d0, 0d0, 40d0, 0d0, 0d0, 15d0], [2, 3])
    integer(c_int64_t), target :: id(1) = 3
    type(vbgpd_selection) :: one
    real(c_double) :: force(2)
    integer(c_int64_t) :: b
    integer(c_int32_t) :: s(4)
    one%kind = VBGPD_SELECT_IDS
    one%ids = c_loc(id)
    one%ids_stride = 8
    one%n_ids = 1
    call model%write_points("pore_pressure", places, [60d3, 20d3, -10d3], s(1))
    call model%write("external_force", reshape([-1d3, 2d3], [2, 1]), one, s(2))
    call model%set_load(0_c_int64_t, 7d3, 9d3, s(3))
    call model%set("kh", 0.0625_c_double, s(4))
    call begin("32 from outside " // num32(s(1)) // " " // num32(s(2)) // " " // num32(s(3)) // " " // num32(s(4)) // &
               ", a fixed boundary: ")
    call model%set_boundary_velocity(0_c_int64_t, [1d0, 0d0], s(1))
    call model_failed(model, s(1))
    call say_advance("   then", model, 0.09375_c_double)
    do b = 0, 2
      call model%boundary_reaction(b, force, s(1))
      call say("   reaction " // num32(s(1)) // hexes(force))
    end do
    call model%set_layer_active(0_c_int64_t, .true., s(1))
    call begin("   layer on " // num32(s(1)) // ", the only one off: ")
    call model%set_layer_active(0_c_int64_t, .false., s(1))
    call model_failed(model, s(1))
  end subroutine step_outside

  subroutine step_events(model)
    type(vbgpd_model), intent(in) :: model
    type(vbgpd_event), allocatable :: list(:)
    integer(c_int32_t) :: s
    integer :: i
    call model%events(0_c_int64_t, list, s)
    call begin("   events " // num32(s))
    do i = 1, size(list)
      call begin(" " // num32(list(i)%kind) // " " // num(list(i)%sequence) // " " // num(list(i)%step) // &
                 hexes([list(i)%time]) // " " // num(list(i)%id_a) // " " // num(list(i)%id_b) // &
                 hexes([list(i)%x, list(i)%y, list(i)%value]))
    end do
    call say("")
  end subroutine step_events

  subroutine step_checkpoint(context, profile, model)
    type(vbgpd_context), intent(in) :: context
    type(vbgpd_profile), intent(in) :: profile
    type(vbgpd_model), intent(in) :: model
    type(vbgpd_model) :: other
    integer(c_int8_t), allocatable :: bytes(:), scene(:)
    integer(c_int32_t) :: s
    call model%checkpoint(bytes, s)
    call begin("33 checkpoint " // num32(s) // " " // num(size(bytes, kind=c_int64_t)))
    call other%create_from_checkpoint(context, bytes, s)
    call begin(" made " // num32(s))
    call say_hash(other)
    call say_advance("   both", model, 0.125_c_double)
    call say_advance("   both", other, 0.125_c_double)
    call model%restore_checkpoint(bytes, s)
    call begin("   back " // num32(s))
    call say_hash(model)
    call begin("   cut short: ")
    call model%restore_checkpoint(bytes(:size(bytes)/2), s)
    call model_failed(model, s)
    call profile%to_flatbuffer(scene, s)
    call begin("   profile " // num32(s) // " " // num(size(scene, kind=c_int64_t)))
    call model%snapshot(bytes, s)
    call say(" snapshot " // num32(s) // " " // num(size(bytes, kind=c_int64_t)))
  end subroutine step_checkpoint

  subroutine hear(line, text)
    type(vbgpd_log_line), intent(in) :: line
    character(*), intent(in) :: text
    lines_heard = lines_heard + 1
    call say("   heard level " // num32(line%level) // ": " // text)
  end subroutine hear

  subroutine step_log(context, model)
    type(vbgpd_context), intent(inout) :: context
    type(vbgpd_model), intent(in) :: model
    type(vbgpd_model) :: other
    integer(c_int8_t), allocatable :: bytes(:)
    integer(c_int32_t) :: s(3)
    lines_heard = 0
    call model%checkpoint(bytes, s(1))
    call context%set_log(hear, stat=s(1))
    call other%create_from_checkpoint(context, bytes, s(2))
    call context%set_log(stat=s(3))
    call say("   told " // num32(s(1)) // " " // num32(s(2)) // " " // num32(s(3)) // ", " // num32(lines_heard) // " lines")
  end subroutine step_log

  subroutine step_memory(context, model)
    type(vbgpd_context), intent(in) :: context
    type(vbgpd_model), intent(in) :: model
    type(vbgpd_log_line) :: line
    type(vbgpd_memory) :: m
    character(:), allocatable :: text, ignored
    integer(c_int32_t) :: s
    call context%log_next(0_c_int64_t, line, text, s)
    call begin("   log " // num32(s) // " level " // num32(line%level) // " sequence " // num(line%sequence) // ": " // text)
    call context%log_next(4000_c_int64_t, line, ignored, s)
    call say(" then " // num32(s))
    call model%memory(m, s)
    call say("   memory " // num32(s) // " " // num(m%bytes) // " " // num(m%model) // " " // num(m%state) // " " // &
             num(m%scratch) // " " // num(m%copies) // " " // num(m%outside) // " " // num(m%saved))
  end subroutine step_memory

  subroutine step_coupling(context, profile)
    type(vbgpd_context), intent(in) :: context
    type(vbgpd_profile), intent(in) :: profile
    type(vbgpd_model) :: model
    call profile%set("spacing", 1.25_c_double)
    call model%create(context, profile)
    call step_states(model)
    call step_selections(model)
    call step_samples(model)
    call step_outside(model)
    call step_events(model)
    call step_checkpoint(context, profile, model)
  end subroutine step_coupling

  ! Parents first; the job still answers. A destroyed handle is known as such, NULL may be destroyed.
  subroutine step_endings(context, profile, model, job)
    type(vbgpd_context), intent(inout) :: context
    type(vbgpd_profile), intent(inout) :: profile
    type(vbgpd_model), intent(inout) :: model
    type(vbgpd_job), intent(inout) :: job
    integer(c_int64_t) :: n
    real(c_double) :: value
    integer(c_int32_t) :: s, t
    type(c_ptr) :: gone
    gone = profile%handle
    call profile%destroy(s)
    call begin("34 destroyed " // num32(s) // " " // num32(vbgpd_profile_count(gone, VBGPD_OBJECT_LAYER, n)))
    call begin(" NULL " // num32(vbgpd_model_item_count(c_null_ptr, VBGPD_AT_BOND, n)) // " " // &
               num32(vbgpd_job_get_f64(c_null_ptr, "steps", 5_c_int64_t, value)) // " " // &
               num32(vbgpd_profile_destroy(c_null_ptr)))
    call say(" foreign " // num32(vbgpd_model_item_count(context%handle, VBGPD_AT_BOND, n)))
    call context%destroy(s)
    call model%destroy(t)
    call begin("35 destroyed " // num32(s) // " " // num32(t) // ", job still has")
    call say_job_numbers(job, ["factor_of_safety"])
    call job%destroy(s)
    call say(" " // num32(s))
  end subroutine step_endings
end module transcript_steps

program transcript
  use transcript_steps
  implicit none
  type(vbgpd_context) :: context
  type(vbgpd_profile) :: profile
  type(vbgpd_model) :: model
  type(vbgpd_job) :: job
  integer(c_int32_t) :: s
  call step_tables()
  call step_context(context)
  call profile%create(context)
  call step_profile(context, profile)
  call step_parts(profile)
  call model%create(context, profile, s)
  call begin("15 model " // num32(s))
  call say_numbers(model, [character(10) :: "particles", "bonds", "area", "height", "total_mass", "spacing_x", &
                           "spacing_y"])
  call say_hash(model)
  call step_memory(context, model)
  call step_log(context, model)
  call step_equilibrium(model)
  call step_fields(model)
  call step_dynamics(model)
  call step_plan(model)
  call model%create(context, profile)
  call job%create_strength_reduction(model)
  call step_strength_reduction(model, job)
  call step_progress(context, profile)
  call step_coupling(context, profile)
  call step_endings(context, profile, model, job)
end program transcript
