! SPDX-License-Identifier: BSD-3-Clause
! The array forms of the sand against each other, against C's views and against rotation.
program sand_arrays
   use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
   use grit
   use expect
   implicit none
   integer, parameter :: n = 5
   type(grit_sand) :: sand
   type(grit_sand_options) :: options
   type(grit_sand_report) :: reports(n), some(2), one
   type(grit_error) :: error
   type(grit_sand_points) :: points
   real(c_double), target :: strain(6, n), stress(6, n), state(8, n), tangent(6, 6, n), substep(n)
   real(c_double), target :: stress_c(6, n), state_c(8, n), rows(36, n), start(6), start_state(8)
   integer :: i, j

   sand = lausitz()
   call holds('no sand of this name', grit_sand_record_find('lausit') == -1)
   start = [-100d0, -60d0, -70d0, 10d0, -5d0, 3d0]
   start_state = 0
   start_state(grit_sand_void_ratio) = 0.62d0
   call holds('mobilise', grit_sand_mobilise(sand, [-1d0, -1d0, -1d0, 0.3d0, 0d0, 0d0], 0.9d0, &
                                            start_state) == grit_ok)
   do i = 1, n
      strain(:, i) = i*[-1d-4, 3d-5, 2d-5, 1d-4, -5d-5, 7d-5]
   end do

   ! As C has it, with views: row-major tangents.
   call holds('options', grit_sand_options_init(options) == grit_ok)
   options%tangent = grit_tangent_consistent
   call begin(stress_c, state_c)
   points%strain_increment = grit_view_of(strain)
   points%stress = grit_view_of(stress_c)
   points%state = grit_view_of(state_c)
   points%tangent = grit_mutable_matrix_view(c_loc(rows), 36, 6, 1)
   call holds('views', grit_sand_update(sand, options, int(n, c_ptrdiff_t), points) == grit_ok)

   ! The same bits from arrays, from sections with gaps, and from one point at a time.
   call begin(stress, state)
   substep = 0
   call holds('arrays', grit_sand_update(sand, strain, stress, state, tangent, substep=substep, &
                                         reports=reports, error=error) == grit_ok)
   call holds('stress of arrays', all(stress == stress_c) .and. all(state == state_c))
   do i = 1, n
      call holds('tangent(i, j) is d stress(i) / d strain(j)', &
                 all(tangent(:, :, i) == transpose(reshape(rows(:, i), [6, 6]))))
   end do
   call holds('it is not symmetric', maxval(abs(tangent(:, :, n) - transpose(tangent(:, :, n)))) > 1)
   call holds('reports', all(reports%evaluations > 0) .and. all(reports%step_reduction == 1))
   call holds('advice', all(substep > 0))
   call sections()
   do i = 1, n
      call begin(stress, state)
      call holds('one point', grit_sand_update(sand, strain(:, i), stress(:, i), state(:, i), &
                                               tangent(:, :, 1), report=one) == grit_ok)
      call holds('bits of one point', all(stress(:, i) == stress_c(:, i)) .and. &
                 all(transpose(tangent(:, :, 1)) == reshape(rows(:, i), [6, 6])))
   end do
   call holds('report of one point', one%evaluations == reports(n)%evaluations)

   call begin(stress, state)
   call holds('index', grit_sand_update(sand, strain, stress, state, index=[3_c_ptrdiff_t, &
                                        1_c_ptrdiff_t], reports=some) == grit_ok)
   do i = 1, n
      call holds('points of the index only', &
                 all(stress(:, i) == merge(stress_c(:, i), start, i == 4 .or. i == 2)))
   end do
   call tangents()
   call rotations()
   call plane()
   call operators()
   call refusals()
   call finish()

contains

   subroutine begin(stress, state)
      real(c_double), intent(out) :: stress(:, :), state(:, :)
      stress = spread(start(:size(stress, 1)), 2, size(stress, 2))
      state = spread(start_state, 2, size(state, 2))
   end subroutine

   subroutine sections()
      real(c_double) :: wide(2, 6, 2*n), wide_state(3, 8, n)
      wide = -1
      wide_state = -1
      call begin(wide(2, :, 1:2*n:2), wide_state(2, :, :))
      call holds('gaps', grit_sand_update(sand, strain, wide(2, :, 1:2*n:2), wide_state(2, :, :)) == &
                 grit_ok)
      call holds('bits of gaps', all(wide(2, :, 1:2*n:2) == stress_c) .and. &
                 all(wide_state(2, :, :) == state_c))
      call begin(wide(2, :, 1:1), wide_state(2, :, 1:1))
      call holds('gaps in one point', grit_sand_update(sand, strain(:, 1), wide(2, :, 1), &
                                                       wide_state(2, :, 1)) == grit_ok)
      call holds('bits of one point', all(wide(2, :, 1) == stress_c(:, 1)))
      call holds('what lies between', all(wide(1, :, :) == -1) .and. all(wide(2, :, 2:2*n:2) == -1) &
                 .and. all(wide_state(1:3:2, :, :) == -1))
      call begin(stress, state)
      call holds('backwards', grit_sand_update(sand, strain(:, n:1:-1), stress(:, n:1:-1), &
                                               state(:, n:1:-1)) == grit_ok)
      call holds('bits of backwards', all(stress == stress_c) .and. all(state == state_c))
   end subroutine

   ! A tangent that is present is written, whatever the options say; one that is not cannot be.
   subroutine tangents()
      type(grit_sand_options) :: none, continuum, consistent
      real(c_double) :: M(6, 6, n), one(6, 6)
      consistent = options
      none = options
      none%tangent = grit_tangent_none
      none%tolerance = 1d-6
      consistent%tolerance = none%tolerance
      continuum = none
      continuum%tangent = grit_tangent_continuum
      call begin(stress, state)
      call holds('consistent', grit_sand_update(sand, strain, stress, state, tangent, &
                                                options=consistent) == grit_ok)
      M = -7
      call begin(stress, state)
      call holds('none', grit_sand_update(sand, strain, stress, state, M, options=none) == grit_ok)
      call holds('none is the consistent one', all(M == tangent))
      one = -7
      call begin(stress, state)
      call holds('none, one point', grit_sand_update(sand, strain(:, 2), stress(:, 2), state(:, 2), &
                                                     one, options=none) == grit_ok)
      call holds('none is the consistent one of one point', all(one == tangent(:, :, 2)))
      call begin(stress, state)
      call holds('continuum', grit_sand_update(sand, strain, stress, state, M, options=continuum) == &
                 grit_ok)
      call holds('the continuum''s is another', maxval(abs(M - tangent)) > 1)
      call begin(stress, state)
      call holds('no tangent', grit_sand_update(sand, strain, stress, state, options=none) == grit_ok)
      call refused(grit_sand_update(sand, strain, stress, state, options=consistent, error=error), &
                   error, 'tangent 2 is asked for')
   end subroutine

   ! Q by columns, as Fortran writes it: turning about 3 by 90 degrees takes 11 to 22.
   subroutine rotations()
      real(c_double), parameter :: Q(3, 3) = reshape([0d0, 1d0, 0d0, -1d0, 0d0, 0d0, 0d0, 0d0, 1d0], &
                                                     [3, 3])
      real(c_double) :: turned(6), none(6, n)
      turned = [start(2), start(1), start(3), -start(4), -start(6), start(5)]
      call begin(stress, state)
      none = 0
      call holds('rotate', grit_sand_update(sand, none, stress, state, &
                                            rotation_increment=spread(Q, 3, n)) == grit_ok)
      do j = 1, n
         call holds('the stress turns with Q', maxval(abs(stress(:, j) - turned)) < 1d-12)
      end do
      stress(:, 1) = start
      call holds('rotate', grit_sand_rotate(Q, stress(:, 1)) == grit_ok)
      call holds('by itself too', maxval(abs(stress(:, 1) - turned)) < 1d-12)
      stress(:, 1) = start
      state(:, 1) = start_state
      call holds('one', grit_sand_update(sand, none(:, 1), stress(:, 1), state(:, 1), &
                                         rotation_increment=Q) == grit_ok)
      call holds('one point too', maxval(abs(stress(:, 1) - turned)) < 1d-12)
   end subroutine

   subroutine plane()
      real(c_double) :: four(4, n), state_4(8, n), six(6, n), state_6(8, n), tangent_4(4, 4, n)
      real(c_double) :: flat(6, n)
      flat = strain
      flat(5:6, :) = 0
      call begin(six, state_6)
      six(5:6, :) = 0
      four = six(:4, :)
      state_4 = state_6
      call holds('six', grit_sand_update(sand, flat, six, state_6, tangent) == grit_ok)
      call holds('four', grit_sand_update(sand, flat(:4, :), four, state_4, tangent_4) == grit_ok)
      call holds('four components of six', all(four == six(:4, :)) .and. all(state_4 == state_6) &
                 .and. all(tangent_4 == tangent(:4, :4, :)))
   end subroutine

   ! M(i, j) D(j) is the stress rate, which the transposed M does not give.
   subroutine operators()
      real(c_double) :: M(6, 6), L(6, 6), N_6(6), rate(6), state_rate(8), D(6)
      D = strain(:, 1)/norm2(strain(:, 1))
      call holds('M', grit_sand_intergranular_stiffness(sand, start, start_state, D, M) == grit_ok)
      call holds('rate', grit_sand_rate(sand, 0_c_int, start, start_state, D, rate, &
                                        state_rate) == grit_ok)
      call holds('M D is the rate', maxval(abs(matmul(M, D) - rate)) < 1d-9*norm2(rate))
      call holds('not M^T D', maxval(abs(matmul(D, M) - rate)) > 1d-6*norm2(rate))
      call holds('L and N', grit_sand_stiffness(sand, start, 0.62d0, L, N_6) == grit_ok)
      call holds('L alone', grit_sand_stiffness(sand, start, 0.62d0, L) == grit_ok)
      call holds('rate without memory', grit_sand_rate(sand, 1_c_int, start, start_state, D, rate, &
                                                      state_rate) == grit_ok)
      call holds('L D + N |D|', maxval(abs(matmul(L, D) + N_6*length(D) - rate)) < 1d-9*norm2(rate))
      call holds('at rest', grit_sand_stress_at_rest(sand, 10d0, 2d0, 0d0, 0.4d0, 3, rate) == grit_ok)
      call holds('axis 3 is vertical', all(abs(rate - [-8d0, -8d0, -20d0, 0d0, 0d0, 0d0]) < 1d-12))
   end subroutine

   ! Of a strain with engineering shear.
   real(c_double) function length(D)
      real(c_double), intent(in) :: D(6)
      length = sqrt(sum(D(:3)**2) + sum(D(4:)**2)/2)
   end function

   subroutine refusals()
      real(c_double) :: kept(6, n), kept_state(8, n)
      call begin(stress, state)
      kept = stress
      kept_state = state
      call refused(grit_sand_update(sand, strain(:5, :), stress(:5, :), state, error=error), error, &
                   'strain_increment must be (6, 5), got (5, 5)')
      call refused(grit_sand_update(sand, strain, stress(:, :4), state, error=error), error, &
                   'stress must be (6, 5), got (6, 4)')
      call refused(grit_sand_update(sand, strain, stress, state(:7, :), error=error), error, &
                   'state must be (8, 5), got (7, 5)')
      call refused(grit_sand_update(sand, strain, stress, state, tangent(:, :3, :), error=error), &
                   error, 'tangent must be (6, 6, 5), got (6, 3, 5)')
      call refused(grit_sand_update(sand, strain, stress, state, substep=substep(:2), error=error), &
                   error, 'substep must be (5), got (2)')
      call refused(grit_sand_update(sand, strain, stress, state, index=[5_c_ptrdiff_t], error=error), &
                   error, 'index must be in [0, 5), counted from 0, got 5')
      call refused(grit_sand_update(sand, strain, stress, state, reports=some, error=error), error, &
                   'reports must be (5), got (2)')
      call holds('without error', grit_sand_update(sand, strain, stress, state(:7, :)) /= grit_ok)
      strain(4, 3) = ieee_value(1d0, ieee_quiet_nan)
      call holds('NaN', grit_sand_update(sand, strain(:, 3:3), stress(:, 3:3), state(:, 3:3), &
                                         error=error) == grit_bad_call)
      call holds('message of NaN: '//grit_message(error), grit_message(error) == &
                 'point 0: strain_increment 12 must be finite, got nan')
      call holds('nothing changed', all(stress == kept) .and. all(state == kept_state))
      call holds('no points', grit_sand_update(sand, strain(:, :0), stress(:, :0), state(:, :0)) == &
                 grit_ok)
   end subroutine
end program
