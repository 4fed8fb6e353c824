! SPDX-License-Identifier: BSD-3-Clause
! Derivatives by parameters on arrays: against C's views, one point against many, and central differences.
program differentiated_arrays
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use grit
   use expect
   implicit none
   integer, parameter :: n = 4, k = 3
   integer(c_int), parameter :: of_h_s = 1
   integer(c_int), target :: parameters(k) = [of_h_s, grit_sand_no_parameter, grit_sand_no_parameter]
   type(grit_sand) :: sand
   type(grit_sand_parameters) :: p
   type(grit_sand_options) :: options
   type(grit_sand_points) :: points
   type(grit_sand_derivatives) :: derivatives
   type(grit_sand_report) :: reports(n), one
   type(grit_error) :: error
   real(c_double), target :: strain(6, n), stress(6, n), state(8, n), strain_slope(6, k, n)
   real(c_double), target :: T(6, k, n), S(8, k, n), stress_c(6, n), state_c(8, n), T_c(6, k, n), S_c(8, k, n)
   real(c_double) :: up(6, n), down(6, n), h_s, step, spoilt(8, k, n)
   integer :: i

   sand = lausitz()
   call holds('parameters', grit_sand_parameters_init(p) == grit_ok)
   call holds('of the sand', grit_sand_parameters_of(sand, p) == grit_ok)
   call holds('options', grit_sand_options_init(options) == grit_ok)
   options%tolerance = 1d-11
   do i = 1, n
      strain(:, i) = i*[-1d-4, 3d-5, 2d-5, 1d-4, -5d-5, 7d-5]
   end do
   strain_slope = 0
   strain_slope(1, 3, :) = 1

   call begin(stress_c, state_c, T_c, S_c)
   points%strain_increment = grit_view_of(strain)
   points%stress = grit_view_of(stress_c)
   points%state = grit_view_of(state_c)
   derivatives%count = k
   derivatives%parameters = c_loc(parameters)
   derivatives%strain_increment = grit_matrix_view_of(strain_slope)
   derivatives%stress = grit_matrix_view_of(T_c)
   derivatives%state = grit_matrix_view_of(S_c)
   call holds('views', grit_sand_update_differentiated(sand, options, derivatives, int(n, c_ptrdiff_t), &
                                                       points) == grit_ok)

   call begin(stress, state, T, S)
   call holds('arrays', grit_sand_update_differentiated(sand, parameters, strain, stress, state, T, S, &
                                                        strain_slope, options=options, &
                                                        reports=reports, error=error) == grit_ok)
   call holds('bits of arrays', all(stress == stress_c) .and. all(state == state_c) .and. &
              all(T == T_c) .and. all(S == S_c))
   call begin(up, state, T, S)
   call holds('without', grit_sand_update(sand, strain, up, state, options=options) == grit_ok)
   call holds('bits without', all(up == stress_c) .and. all(state == state_c))
   do i = 1, n
      call begin(stress, state, T, S)
      call holds('one point', grit_sand_update_differentiated( &
                 sand, parameters, strain(:, i), stress(:, i), state(:, i), T(:, :, i), S(:, :, i), &
                 strain_slope(:, :, i), options=options, report=one) == grit_ok)
      call holds('bits of one point', all(T(:, :, i) == T_c(:, :, i)) .and. &
                 all(S(:, :, i) == S_c(:, :, i)) .and. one%evaluations == reports(i)%evaluations)
   end do

   ! The void ratio is known in closed form, e = (1 + e_0) exp(tr) - 1.
   do i = 1, n
      call holds('void ratio', abs(S_c(grit_sand_void_ratio, 2, i) - exp(sum(strain(:3, i)))) < 1d-14)
      call holds('by the strain', &
                 abs(S_c(grit_sand_void_ratio, 3, i) - 1 - state_c(grit_sand_void_ratio, i)) < 1d-14)
   end do
   h_s = p%granulate_hardness
   step = 1d-3*h_s
   call at(h_s + step, up)
   call at(h_s - step, down)
   call holds('central differences', maxval(abs((up - down)/(2*step) - T_c(:, 1, :))) < &
              1d-5*maxval(abs(T_c(:, 1, :))))
   call refusals()
   call finish()

contains

   subroutine begin(stress, state, T, S)
      real(c_double), intent(out) :: stress(:, :), state(:, :), T(:, :, :), S(:, :, :)
      stress = spread([-100d0, -60d0, -70d0, 10d0, -5d0, 3d0], 2, n)
      state = 0
      state(grit_sand_void_ratio, :) = 0.62d0
      T = 0
      S = 0
      S(grit_sand_void_ratio, 2, :) = 1
   end subroutine

   subroutine at(hardness, stress)
      real(c_double), intent(in) :: hardness
      real(c_double), intent(out), target :: stress(:, :)
      type(grit_sand) :: other
      real(c_double) :: T(6, k, n), S(8, k, n)
      p%granulate_hardness = hardness
      call holds('prepare', grit_sand_prepare(p, other) == grit_ok)
      call begin(stress, state, T, S)
      call holds('update', grit_sand_update(other, strain, stress, state, options=options) == grit_ok)
   end subroutine

   subroutine refusals()
      call begin(stress, state, T, S)
      call refused(grit_sand_update_differentiated(sand, parameters, strain, stress, state, T(:, :2, :), &
                                                   S, error=error), error, &
                   'stress_slope must be (6, 3, 4), got (6, 2, 4)')
      call refused(grit_sand_update_differentiated(sand, parameters, strain, stress, state, T, &
                                                   S(:7, :, :), error=error), error, &
                   'state_slope must be (8, 3, 4), got (7, 3, 4)')
      call refused(grit_sand_update_differentiated(sand, parameters, strain, stress, state, T, S, &
                                                   strain_slope(:, :, :3), error=error), error, &
                   'strain_slope must be (6, 3, 4), got (6, 3, 3)')
      call refused(grit_sand_update_differentiated(sand, parameters, strain(:, 1), stress(:, 1), &
                                                   state(:, 1), T(:, :2, 1), S(:, :, 1), &
                                                   error=error), error, &
                   'stress_slope must be (6, 3), got (6, 2)')
      call refused(grit_sand_update_differentiated(sand, [14_c_int, 0_c_int, 0_c_int], strain, stress, &
                                                   state, T, S, error=error), error, &
                   'parameter 0 of the derivatives must be in [0, 14), or -1, got 14')
      spoilt = S
      spoilt(1, 1, 2) = ieee_value(1d0, ieee_quiet_nan)
      call refused(grit_sand_update_differentiated(sand, parameters, strain, stress, state, T, spoilt, &
                                                   error=error), error, &
                   'point 1: derivatives of stress, state and strain increment must be finite')
   end subroutine
end program
