! SPDX-License-Identifier: BSD-3-Clause
! Undrained sand on arrays: against C's views, against the drained update and its water, one point against many.
program undrained_arrays
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use grit
   use expect
   implicit none
   integer, parameter :: n = 5
   real(c_double), parameter :: K_w = 2.2d6
   type(grit_sand) :: sand
   type(grit_sand_water) :: water
   type(grit_sand_options) :: options
   type(grit_sand_report) :: reports(n), some(2), one
   type(grit_error) :: error
   type(grit_sand_points) :: points
   real(c_double), target :: strain(6, n), stress(6, n), state(8, n), p_w(n), total(6, n), tangent(6, 6, n)
   real(c_double), target :: stress_c(6, n), state_c(8, n), p_w_c(n), total_c(6, n), rows(36, n)
   real(c_double) :: drained(6, n), drained_state(8, n), C(6, 6, n), K, e, start(6)
   integer :: i

   sand = lausitz()
   start = [-100d0, -60d0, -70d0, 10d0, -5d0, 3d0]
   do i = 1, n
      strain(:, i) = i*[-1d-4, 3d-5, 2d-5, 1d-4, -5d-5, 7d-5]
   end do
   strain(1, n) = 5d-3  ! cavitates
   call holds('water', grit_sand_water_init(water) == grit_ok)
   call holds('it never cavitates', water%largest_tension > huge(1d0))
   water%bulk_modulus = K_w
   water%largest_tension = 100

   ! As C has it, with views.
   call holds('options', grit_sand_options_init(options) == grit_ok)
   options%tangent = grit_tangent_consistent
   call begin(stress_c, state_c, p_w_c, total_c)
   points%strain_increment = grit_view_of(strain)
   points%stress = grit_view_of(stress_c)
   points%state = grit_view_of(state_c)
   points%tangent = grit_mutable_matrix_view(c_loc(rows), 36, 6, 1)
   water%pore_pressure = grit_view_of(p_w_c)
   water%total_stress = grit_view_of(total_c)
   call holds('views', grit_sand_update_undrained(sand, options, water, int(n, c_ptrdiff_t), &
                                                  points) == grit_ok)

   ! Whatever views the water has.
   call begin(stress, state, p_w, total)
   call holds('arrays', grit_sand_update_undrained(sand, water, strain, stress, state, p_w, total, &
                                                   tangent, reports=reports, error=error) == grit_ok)
   call holds('bits of arrays', all(stress == stress_c) .and. all(state == state_c) .and. &
              all(p_w == p_w_c) .and. all(total == total_c))
   call begin(drained, drained_state, p_w, total)
   call holds('drained', grit_sand_update(sand, strain, drained, drained_state, C) == grit_ok)
   call holds('its grains', all(drained == stress) .and. all(drained_state == state))
   do i = 1, n
      call holds('tangent', all(tangent(:, :, i) == transpose(reshape(rows(:, i), [6, 6]))))
      e = state(grit_sand_void_ratio, i)
      call holds('pressure', abs(p_w_c(i) - (50 - K_w*log(e/0.62d0))) < 1d-6)
      call holds('total stress', &
                 all(abs(stress(:3, i) - total_c(:3, i) - max(p_w_c(i), -100d0)) < 1d-9) &
                 .and. all(stress(4:, i) == total_c(4:, i)))
      call holds('stiffness', grit_sand_water_stiffness(water, p_w_c(i), e, K) == grit_ok)
      call holds('of the pores', abs(K - merge(K_w*(1 + e)/e, 0d0, i < n)) < 1d-6)
      call holds('water of the tangent', maxval(abs(tangent(:3, :3, i) - C(:3, :3, i) - K)) < 1d-6 &
                 .and. all(tangent(4:, :, i) == C(4:, :, i)))
      call holds('flag', iand(reports(i)%flags, grit_sand_cavitated) == &
                 merge(grit_sand_cavitated, 0, i == n))
   end do
   do i = 1, n
      call begin(stress, state, p_w, total)
      call holds('one point', grit_sand_update_undrained( &
                 sand, water, strain(:, i), stress(:, i), state(:, i), p_w(i), total(:, i), &
                 tangent(:, :, i), report=one) == grit_ok)
      call holds('bits of one point', all(stress(:, i) == stress_c(:, i)) .and. p_w(i) == p_w_c(i) &
                 .and. all(total(:, i) == total_c(:, i)) &
                 .and. all(transpose(tangent(:, :, i)) == reshape(rows(:, i), [6, 6])))
      call holds('report of one point', one%flags == reports(i)%flags)
   end do
   call begin(stress, state, p_w, total)
   call holds('index', grit_sand_update_undrained(sand, water, strain, stress, state, p_w, &
                                                  index=[3_c_ptrdiff_t, 1_c_ptrdiff_t], &
                                                  reports=some) == grit_ok)
   do i = 1, n
      call holds('points of the index only', p_w(i) == merge(p_w_c(i), 50d0, i == 4 .or. i == 2))
   end do
   call refusals()
   call finish()

contains

   subroutine begin(stress, state, p_w, total)
      real(c_double), intent(out) :: stress(:, :), state(:, :), p_w(:), total(:, :)
      stress = spread(start, 2, n)
      state = 0
      state(grit_sand_void_ratio, :) = 0.62d0
      p_w = 50
      total = 0
   end subroutine

   subroutine refusals()
      real(c_double) :: kept(6, n)
      call begin(stress, state, p_w, total)
      kept = stress
      call refused(grit_sand_update_undrained(sand, water, strain, stress, state(:7, :), p_w, &
                                              error=error), error, 'state must be (8, 5), got (7, 5)')
      call refused(grit_sand_update_undrained(sand, water, strain, stress, state, p_w(:4), &
                                              error=error), error, 'pore_pressure must be (5), got (4)')
      call refused(grit_sand_update_undrained(sand, water, strain, stress, state, p_w, total(:4, :), &
                                              error=error), error, &
                   'total_stress must be (6, 5), got (4, 5)')
      call refused(grit_sand_update_undrained(sand, water, strain(:, 1), stress(:, 1), state(:, 1), &
                                              p_w(1), total(:4, 1), error=error), error, &
                   'total_stress must be (6), got (4)')
      p_w(3) = ieee_value(1d0, ieee_quiet_nan)
      call holds('NaN', grit_sand_update_undrained(sand, water, strain(:, 3:3), stress(:, 3:3), &
                                                   state(:, 3:3), p_w(3:3), error=error) == &
                 grit_bad_state)
      call holds('message of NaN: '//grit_message(error), grit_message(error) == &
                 'point 0: pore_pressure must be finite, got nan')
      water%bulk_modulus = -1
      call holds('bulk modulus', grit_sand_update_undrained(sand, water, strain, stress, state, p_w, &
                                                           error=error) == grit_bad_parameter)
      call holds('nothing changed', all(stress == kept))
   end subroutine
end program
