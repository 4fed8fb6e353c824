! SPDX-License-Identifier: BSD-3-Clause
! The sand on the arrays of a Fortran host: shapes are checked, nothing but rotations is copied.
module grit_sand_arrays
   use, intrinsic :: iso_c_binding
   use grit_base
   use grit_sand_interface
   implicit none
   private
   public :: grit_sand_update, grit_sand_update_undrained, grit_sand_update_differentiated
   public :: grit_sand_parameters_init, grit_sand_options_init, grit_sand_water_init
   public :: grit_sand_parameter_describe, grit_sand_parameter_get, grit_sand_parameter_set
   public :: grit_sand_record_find, grit_sand_record_at, grit_sand_stiffness
   public :: grit_sand_intergranular_stiffness, grit_sand_rotate, grit_sand_stress_at_rest

   ! status = grit_sand_update(sand, strain_increment, stress, state [, tangent, rotation_increment,
   !                           substep, index, options, reports, error])
   !   n points: strain_increment, stress (c, n), c = 6 or 4; state (8, n); tangent (c, c, n);
   !             rotation_increment (3, 3, n); substep (n); reports (n), with index of its size
   !   one point: strain_increment, stress (c); state (8); tangent (c, c); rotation (3, 3)
   ! tangent(i, j) = d stress(i) / d strain(j): where it is present it is written, the consistent one
   ! unless the options ask for the continuum's.
   ! index: points to be taken, from 0. Sections of arrays are used in place. As C has it, with views:
   ! grit_sand_update(sand, options, n, points, reports, error).
   interface grit_sand_update
      procedure update_points, update_point, c_sand_update
   end interface

   ! status = grit_sand_update_undrained(sand, water, strain_increment, stress, state, pore_pressure
   !                                     [, total_stress, tangent, rotation_increment, substep, index,
   !                                     options, reports, error])
   ! Undrained points: stress is effective, pore_pressure (n), or one number, in and out; total_stress, as stress,
   ! is written; the tangent is that of the total stress. Views in water are not looked at. As C has it:
   ! grit_sand_update_undrained(sand, options, water, n, points, reports, error).
   interface grit_sand_update_undrained
      procedure update_undrained_points, update_undrained_point, c_sand_update_undrained
   end interface

   ! status = grit_sand_update_differentiated(sand, parameters, strain_increment, stress, state, stress_slope, state_slope
   !                                          [, strain_slope, rotation_increment, substep, index, options,
   !                                          reports, error])
   ! parameters (k): of each direction, from 0 as grit_sand_parameter_describe counts them, or
   ! grit_sand_no_parameter. Of n points: stress_slope (c, k, n), state_slope (8, k, n), in and out, and
   ! strain_slope (c, k, n), 0 where it is left out; of one: (c, k), (8, k), (c, k). As C has it:
   ! grit_sand_update_differentiated(sand, options, derivatives, n, points, reports, error).
   interface grit_sand_update_differentiated
      procedure differentiated_points, differentiated_point, c_sand_update_differentiated
   end interface

contains

   integer(c_int) function update_points(sand, strain_increment, stress, state, tangent, &
                                         rotation_increment, substep, index, options, reports, &
                                         error) result(status)
      type(grit_sand), intent(in) :: sand
      real(c_double), intent(in), target :: strain_increment(:, :)
      real(c_double), intent(inout), target :: stress(:, :), state(:, :)
      real(c_double), intent(inout), target, optional :: tangent(:, :, :), substep(:)
      real(c_double), intent(in), optional :: rotation_increment(:, :, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: index(:)
      type(grit_sand_options), intent(in), optional :: options
      type(grit_sand_report), intent(inout), target, contiguous, optional :: reports(:)
      type(grit_error), intent(inout), optional :: error
      type(grit_sand_points) :: points
      real(c_double), allocatable, target :: rows(:, :)
      integer :: taken

      status = view_points(points, taken, rows, strain_increment, stress, state, tangent, &
                           rotation_increment, substep, index, reports, error)
      if (status == grit_ok) &
         status = c_sand_update(sand, with_tangent(options, present(tangent)), &
                                int(taken, c_ptrdiff_t), points, reports, error)
   end function

   integer(c_int) function update_point(sand, strain_increment, stress, state, tangent, &
                                        rotation_increment, substep, options, report, error) &
      result(status)
      type(grit_sand), intent(in) :: sand
      real(c_double), intent(in), target :: strain_increment(:)
      real(c_double), intent(inout), target :: stress(:), state(:)
      real(c_double), intent(inout), target, optional :: tangent(:, :), substep
      real(c_double), intent(in), optional :: rotation_increment(:, :)
      type(grit_sand_options), intent(in), optional :: options
      type(grit_sand_report), intent(inout), optional :: report
      type(grit_error), intent(inout), optional :: error
      type(grit_sand_points) :: points
      type(grit_sand_report) :: reports(1)
      real(c_double), target :: rows(9, 1)

      status = view_point(points, rows, strain_increment, stress, state, tangent, &
                          rotation_increment, substep, error)
      if (status /= grit_ok) return
      if (present(report)) reports(1) = report
      status = c_sand_update(sand, with_tangent(options, present(tangent)), 1_c_ptrdiff_t, points, &
                             reports, error)
      if (present(report)) report = reports(1)
   end function

   integer(c_int) function update_undrained_points(sand, water, strain_increment, stress, state, &
                                                   pore_pressure, total_stress, tangent, &
                                                   rotation_increment, substep, index, options, &
                                                   reports, error) result(status)
      type(grit_sand), intent(in) :: sand
      type(grit_sand_water), intent(in) :: water
      real(c_double), intent(in), target :: strain_increment(:, :)
      real(c_double), intent(inout), target :: stress(:, :), state(:, :), pore_pressure(:)
      real(c_double), intent(inout), target, optional :: total_stress(:, :)
      real(c_double), intent(inout), target, optional :: tangent(:, :, :), substep(:)
      real(c_double), intent(in), optional :: rotation_increment(:, :, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: index(:)
      type(grit_sand_options), intent(in), optional :: options
      type(grit_sand_report), intent(inout), target, contiguous, optional :: reports(:)
      type(grit_error), intent(inout), optional :: error
      type(grit_sand_points) :: points
      type(grit_sand_water) :: wet
      real(c_double), allocatable, target :: rows(:, :)
      integer :: c, n, taken

      status = view_points(points, taken, rows, strain_increment, stress, state, tangent, &
                           rotation_increment, substep, index, reports, error)
      if (status /= grit_ok) return
      status = grit_bad_call
      c = size(stress, 1)
      n = size(stress, 2)
      wet = water
      if (.not. grit_fits('pore_pressure', shape(pore_pressure), [n], error)) return
      wet%pore_pressure = grit_view_of(pore_pressure)
      wet%total_stress = grit_mutable_view()
      if (present(total_stress)) then
         if (.not. grit_fits('total_stress', shape(total_stress), [c, n], error)) return
         wet%total_stress = grit_view_of(total_stress)
      end if
      status = c_sand_update_undrained(sand, with_tangent(options, present(tangent)), wet, &
                                       int(taken, c_ptrdiff_t), points, reports, error)
   end function

   integer(c_int) function update_undrained_point(sand, water, strain_increment, stress, state, &
                                                  pore_pressure, total_stress, tangent, &
                                                  rotation_increment, substep, options, report, &
                                                  error) result(status)
      type(grit_sand), intent(in) :: sand
      type(grit_sand_water), intent(in) :: water
      real(c_double), intent(in), target :: strain_increment(:)
      real(c_double), intent(inout), target :: stress(:), state(:), pore_pressure
      real(c_double), intent(inout), target, optional :: total_stress(:)
      real(c_double), intent(inout), target, optional :: tangent(:, :), substep
      real(c_double), intent(in), optional :: rotation_increment(:, :)
      type(grit_sand_options), intent(in), optional :: options
      type(grit_sand_report), intent(inout), optional :: report
      type(grit_error), intent(inout), optional :: error
      type(grit_sand_points) :: points
      type(grit_sand_water) :: wet
      type(grit_sand_report) :: reports(1)
      real(c_double), target :: rows(9, 1)

      status = view_point(points, rows, strain_increment, stress, state, tangent, &
                          rotation_increment, substep, error)
      if (status /= grit_ok) return
      wet = water
      wet%pore_pressure = grit_mutable_view(c_loc(pore_pressure), 1, 1)
      wet%total_stress = grit_mutable_view()
      if (present(total_stress)) then
         status = grit_bad_call
         if (.not. grit_fits('total_stress', shape(total_stress), shape(stress), error)) return
         wet%total_stress = components_of(total_stress)
      end if
      if (present(report)) reports(1) = report
      status = c_sand_update_undrained(sand, with_tangent(options, present(tangent)), wet, &
                                       1_c_ptrdiff_t, points, reports, error)
      if (present(report)) report = reports(1)
   end function

   integer(c_int) function differentiated_points(sand, parameters, strain_increment, stress, state, &
                                                 stress_slope, state_slope, strain_slope, &
                                                 rotation_increment, substep, index, options, &
                                                 reports, error) result(status)
      type(grit_sand), intent(in) :: sand
      integer(c_int), intent(in), target, contiguous :: parameters(:)
      real(c_double), intent(in), target :: strain_increment(:, :)
      real(c_double), intent(inout), target :: stress(:, :), state(:, :)
      real(c_double), intent(inout), target :: stress_slope(:, :, :), state_slope(:, :, :)
      real(c_double), intent(in), target, optional :: strain_slope(:, :, :)
      real(c_double), intent(in), optional :: rotation_increment(:, :, :)
      real(c_double), intent(inout), target, optional :: substep(:)
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: index(:)
      type(grit_sand_options), intent(in), optional :: options
      type(grit_sand_report), intent(inout), target, contiguous, optional :: reports(:)
      type(grit_error), intent(inout), optional :: error
      type(grit_sand_points) :: points
      type(grit_sand_derivatives) :: derivatives
      real(c_double), allocatable, target :: rows(:, :)
      integer :: c, k, n, taken

      status = view_points(points, taken, rows, strain_increment, stress, state, &
                           rotation_increment=rotation_increment, substep=substep, index=index, &
                           reports=reports, error=error)
      if (status /= grit_ok) return
      status = grit_bad_call
      c = size(stress, 1)
      n = size(stress, 2)
      k = size(parameters)
      if (.not. grit_fits('stress_slope', shape(stress_slope), [c, k, n], error)) return
      if (.not. grit_fits('state_slope', shape(state_slope), [8, k, n], error)) return
      derivatives%count = k
      if (k > 0) derivatives%parameters = c_loc(parameters)
      derivatives%stress = grit_matrix_view_of(stress_slope)
      derivatives%state = grit_matrix_view_of(state_slope)
      if (present(strain_slope)) then
         if (.not. grit_fits('strain_slope', shape(strain_slope), [c, k, n], error)) return
         derivatives%strain_increment = grit_matrix_view_of(strain_slope)
      end if
      status = c_sand_update_differentiated(sand, options, derivatives, int(taken, c_ptrdiff_t), &
                                            points, reports, error)
   end function

   integer(c_int) function differentiated_point(sand, parameters, strain_increment, stress, state, &
                                                stress_slope, state_slope, strain_slope, &
                                                rotation_increment, substep, options, report, &
                                                error) result(status)
      type(grit_sand), intent(in) :: sand
      integer(c_int), intent(in), target, contiguous :: parameters(:)
      real(c_double), intent(in), target :: strain_increment(:)
      real(c_double), intent(inout), target :: stress(:), state(:)
      real(c_double), intent(inout), target :: stress_slope(:, :), state_slope(:, :)
      real(c_double), intent(in), target, optional :: strain_slope(:, :)
      real(c_double), intent(in), optional :: rotation_increment(:, :)
      real(c_double), intent(inout), target, optional :: substep
      type(grit_sand_options), intent(in), optional :: options
      type(grit_sand_report), intent(inout), optional :: report
      type(grit_error), intent(inout), optional :: error
      type(grit_sand_points) :: points
      type(grit_sand_derivatives) :: derivatives
      type(grit_sand_report) :: reports(1)
      real(c_double), target :: rows(9, 1)
      integer :: c, k

      status = view_point(points, rows, strain_increment, stress, state, &
                          rotation_increment=rotation_increment, substep=substep, error=error)
      if (status /= grit_ok) return
      status = grit_bad_call
      c = size(stress)
      k = size(parameters)
      if (.not. grit_fits('stress_slope', shape(stress_slope), [c, k], error)) return
      if (.not. grit_fits('state_slope', shape(state_slope), [8, k], error)) return
      derivatives%count = k
      if (k > 0) derivatives%parameters = c_loc(parameters)
      derivatives%stress = grit_matrix_view_of(stress_slope)
      derivatives%state = grit_matrix_view_of(state_slope)
      if (present(strain_slope)) then
         if (.not. grit_fits('strain_slope', shape(strain_slope), [c, k], error)) return
         derivatives%strain_increment = grit_matrix_view_of(strain_slope)
      end if
      if (present(report)) reports(1) = report
      status = c_sand_update_differentiated(sand, options, derivatives, 1_c_ptrdiff_t, points, &
                                            reports, error)
      if (present(report)) report = reports(1)
   end function

   ! The views of a call on arrays whose shapes fit; rows keeps the rotations for as long as the call lasts.
   integer(c_int) function view_points(points, taken, rows, strain_increment, stress, state, tangent, &
                                       rotation_increment, substep, index, reports, error) &
      result(status)
      type(grit_sand_points), intent(out) :: points
      integer, intent(out) :: taken
      real(c_double), allocatable, target, intent(out) :: rows(:, :)
      real(c_double), intent(in), target :: strain_increment(:, :)
      real(c_double), intent(inout), target :: stress(:, :), state(:, :)
      real(c_double), intent(inout), target, optional :: tangent(:, :, :), substep(:)
      real(c_double), intent(in), optional :: rotation_increment(:, :, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: index(:)
      type(grit_sand_report), intent(in), optional :: reports(:)
      type(grit_error), intent(inout), optional :: error
      integer :: c, n

      status = grit_bad_call
      c = merge(4, 6, size(strain_increment, 1) == 4)
      n = size(strain_increment, 2)
      taken = n
      if (.not. grit_fits('strain_increment', shape(strain_increment), [c, n], error)) return
      if (.not. grit_fits('stress', shape(stress), [c, n], error)) return
      if (.not. grit_fits('state', shape(state), [8, n], error)) return
      points%components = c
      points%strain_increment = grit_view_of(strain_increment)
      points%stress = grit_view_of(stress)
      points%state = grit_view_of(state)
      if (present(tangent)) then
         if (.not. grit_fits('tangent', shape(tangent), [c, c, n], error)) return
         points%tangent = grit_matrix_view_of(tangent)
      end if
      if (present(substep)) then
         if (.not. grit_fits('substep', shape(substep), [n], error)) return
         points%substep = grit_view_of(substep)
      end if
      if (present(rotation_increment)) then
         if (.not. grit_fits('rotation_increment', shape(rotation_increment), [3, 3, n], error)) &
            return
         rows = by_rows(rotation_increment)
         points%rotation_increment = grit_view_of(rows)
      end if
      if (present(index)) then
         if (.not. grit_within('index', index, n, error)) return
         taken = size(index)
         if (taken > 0) points%index = c_loc(index)
      end if
      if (present(reports)) then
         if (.not. grit_fits('reports', shape(reports), [taken], error)) return
      end if
      status = grit_ok
   end function

   integer(c_int) function view_point(points, rows, strain_increment, stress, state, tangent, &
                                      rotation_increment, substep, error) result(status)
      type(grit_sand_points), intent(out) :: points
      real(c_double), target, intent(out) :: rows(9, 1)
      real(c_double), intent(in), target :: strain_increment(:)
      real(c_double), intent(inout), target :: stress(:), state(:)
      real(c_double), intent(inout), target, optional :: tangent(:, :), substep
      real(c_double), intent(in), optional :: rotation_increment(:, :)
      type(grit_error), intent(inout), optional :: error
      integer :: c

      status = grit_bad_call
      c = merge(4, 6, size(strain_increment) == 4)
      if (.not. grit_fits('strain_increment', shape(strain_increment), [c], error)) return
      if (.not. grit_fits('stress', shape(stress), [c], error)) return
      if (.not. grit_fits('state', shape(state), [8], error)) return
      points%components = c
      points%strain_increment = components_of(strain_increment)
      points%stress = components_of(stress)
      points%state = components_of(state)
      if (present(tangent)) then
         if (.not. grit_fits('tangent', shape(tangent), [c, c], error)) return
         points%tangent = grit_matrix_view_of(tangent)
      end if
      if (present(substep)) points%substep = grit_mutable_view(c_loc(substep), 1, 1)
      if (present(rotation_increment)) then
         if (.not. grit_fits('rotation_increment', shape(rotation_increment), [3, 3], error)) return
         rows = by_rows(reshape(rotation_increment, [3, 3, 1]))
         points%rotation_increment = grit_view_of(rows)
      end if
      status = grit_ok
   end function

   ! The components of one point, which grit_view_of takes for one component of many points.
   type(grit_view) function components_of(a) result(view)
      real(c_double), intent(in), target :: a(:)
      type(grit_view) :: along
      along = grit_view_of(a)
      view = grit_view(along%base, 0, along%point_stride)
   end function

   function by_rows(Q) result(rows)
      real(c_double), intent(in) :: Q(:, :, :)
      real(c_double), allocatable :: rows(:, :)
      integer :: i
      allocate (rows(9, size(Q, 3)))
      do i = 1, size(Q, 3)
         rows(:, i) = reshape(transpose(Q(:, :, i)), [9])
      end do
   end function

   type(grit_sand_options) function with_tangent(options, wanted) result(out)
      type(grit_sand_options), intent(in), optional :: options
      logical, intent(in) :: wanted
      integer(c_int) :: status
      if (present(options)) then
         out = options
      else
         status = grit_sand_options_init(out)
      end if
      if (wanted .and. out%tangent == grit_tangent_none) out%tangent = grit_tangent_consistent
   end function

   integer(c_int) function grit_sand_parameters_init(parameters) result(status)
      type(grit_sand_parameters), intent(inout) :: parameters
      status = c_sand_parameters_init(parameters, c_sizeof(parameters))
   end function

   integer(c_int) function grit_sand_options_init(options) result(status)
      type(grit_sand_options), intent(inout) :: options
      status = c_sand_options_init(options, c_sizeof(options))
   end function

   integer(c_int) function grit_sand_water_init(water) result(status)
      type(grit_sand_water), intent(inout) :: water
      status = c_sand_water_init(water, c_sizeof(water))
   end function

   ! Number index of grit_sand_parameters, from 0; null outside.
   function grit_sand_parameter_describe(index) result(info)
      integer(c_int), intent(in) :: index
      type(grit_sand_parameter_info), pointer :: info
      type(c_ptr) :: address
      address = c_sand_parameter_describe(index)
      nullify (info)
      if (c_associated(address)) call c_f_pointer(address, info)
   end function

   integer(c_int) function grit_sand_parameter_get(parameters, index, value) result(status)
      type(grit_sand_parameters), intent(in) :: parameters
      integer(c_int), intent(in) :: index
      real(c_double), intent(inout) :: value
      status = c_sand_parameter_get(parameters, index, value)
   end function

   integer(c_int) function grit_sand_parameter_set(parameters, index, value) result(status)
      type(grit_sand_parameters), intent(inout) :: parameters
      integer(c_int), intent(in) :: index
      real(c_double), intent(in) :: value
      status = c_sand_parameter_set(parameters, index, value)
   end function

   ! Index of a sand with published parameters, from 0; -1: there is none of this name.
   integer(c_int) function grit_sand_record_find(name) result(index)
      character(*), intent(in) :: name
      index = c_sand_record_find(trim(name)//c_null_char)
   end function

   ! Record index, from 0; null outside.
   function grit_sand_record_at(index) result(record)
      integer(c_int), intent(in) :: index
      type(grit_sand_record), pointer :: record
      type(c_ptr) :: address
      address = c_sand_record_at(index)
      nullify (record)
      if (c_associated(address)) call c_f_pointer(address, record)
   end function

   ! L of (H2), N of (H3).
   integer(c_int) function grit_sand_stiffness(sand, stress, void_ratio, L, N) result(status)
      type(grit_sand), intent(in) :: sand
      real(c_double), intent(in) :: stress(6), void_ratio
      real(c_double), intent(inout), optional :: L(6, 6), N(6)
      real(c_double) :: rows(36)
      status = c_sand_stiffness(sand, stress, void_ratio, rows, N)
      if (status == grit_ok .and. present(L)) L = transpose(reshape(rows, [6, 6]))
   end function

   ! M of (G1): M(i, j) takes D(j) to the stress rate i.
   integer(c_int) function grit_sand_intergranular_stiffness(sand, stress, state, D, M) &
      result(status)
      type(grit_sand), intent(in) :: sand
      real(c_double), intent(in) :: stress(6), state(8), D(6)
      real(c_double), intent(inout) :: M(6, 6)
      real(c_double) :: rows(36)
      status = c_sand_intergranular_stiffness(sand, stress, state, D, rows)
      if (status == grit_ok) M = transpose(reshape(rows, [6, 6]))
   end function

   ! Rotate stress and h of a point by Q(i, j).
   integer(c_int) function grit_sand_rotate(Q, stress, state) result(status)
      real(c_double), intent(in) :: Q(3, 3)
      real(c_double), intent(inout), optional :: stress(6), state(8)
      status = c_sand_rotate(reshape(transpose(Q), [9]), stress, state)
   end function

   ! axis: 1, 2 or 3.
   integer(c_int) function grit_sand_stress_at_rest(sand, unit_weight, depth, surcharge, K0, axis, &
                                                    stress) result(status)
      type(grit_sand), intent(in) :: sand
      real(c_double), intent(in) :: unit_weight, depth, surcharge, K0
      integer, intent(in) :: axis
      real(c_double), intent(inout) :: stress(6)
      status = c_sand_stress_at_rest(sand, unit_weight, depth, surcharge, K0, int(axis - 1, c_int), &
                                     stress)
   end function
end module
