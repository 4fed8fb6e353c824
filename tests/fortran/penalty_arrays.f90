! SPDX-License-Identifier: BSD-3-Clause
! Penalty contact on arrays: two flat lines pressed into each other by a known depth.
program penalty_arrays
   use grit
   use expect
   implicit none
   integer, parameter :: n = 5
   real(c_double), parameter :: depth = 0.01d0, eps = 2d4
   type(grit_penalty_options) :: options
   type(grit_penalty_surface) :: a, b
   type(grit_penalty_totals) :: totals
   type(grit_penalty_report), target :: reports(n)
   type(grit_error) :: error
   real(c_double), target :: upper(2, n), lower(2, n), force_a(2, n) = 0, force_b(2, n) = 0
   real(c_double), target :: stiffness_a(n) = 0, stiffness_b(n) = 0
   real(c_double) :: step, modulus
   integer :: i

   call holds('stiffness', grit_penalty_stiffness(2d0, 1d4, 1d0, modulus) == grit_ok)
   call holds('multiple of the modulus over a cell', modulus == eps)
   call holds('options', grit_penalty_options_init(options) == grit_ok)
   options%normal_stiffness = modulus
   options%depth_max = 0.5d0
   ! The body lies on the left of the direction of travel: A above travels right, B below left.
   do i = 1, n
      upper(:, i) = [i - 1d0, -depth]
      lower(:, i) = [n - real(i, c_double), 0d0]
   end do
   a = grit_penalty_surface_of(upper, force_a, stiffness=stiffness_a, reports=reports)
   b = grit_penalty_surface_of(lower, force_b, stiffness=stiffness_b)
   call holds('forces', grit_penalty_forces(options, a, b, totals, error) == grit_ok)
   call holds('pressure over the length', abs(totals%force_on_a(2) - eps*depth*(n - 1)) < 1d-9)
   call holds('action and reaction', maxval(abs(sum(force_a, 2) + sum(force_b, 2))) < 1d-9)
   call holds('the forces themselves', abs(sum(force_a(2, :)) - totals%force_on_a(2)) < 1d-9)
   call holds('reports', all(abs(reports%gap + depth) < 1d-14) .and. &
              all(reports%state == grit_penalty_slip))
   call holds('step', grit_penalty_stable_step(spread(2d0, 1, n), stiffness_a, spread(2d0, 1, n), &
                                               stiffness_b, step) == grit_ok)
   call holds('of the stiffest node', abs(step - 2/sqrt((maxval(stiffness_a) + maxval(stiffness_b))/2)) &
              < 1d-12)
   stiffness_a = 0
   call holds('flush', grit_penalty_flush_stiffness(options, a) == grit_ok)
   call holds('half its two segments', abs(stiffness_a(2) - eps) < 1d-9)
   call holds('half of the one it has', abs(stiffness_a(1) - eps/2) < 1d-9)
   call remeshed()
   call refusals()
   call finish()

contains

   subroutine remeshed()
      real(c_double) :: new(2, 20), old_history(2, n), history(2, 20), weight(20)
      integer(c_ptrdiff_t) :: count, parents(2, 20)
      old_history = reshape([(real(i, c_double), i=1, 2*n)], [2, n])
      call holds('remesh', grit_penalty_remesh(.false., 0.5d0, 0d0, 0d0, upper, new, count, old_history, &
                                               history, parents, weight, error) == grit_ok)
      call holds('twice as fine', count == 2*n - 1)
      call holds('halves', all(abs(new(1, :count) - [(0.5d0*i, i=0, 2*n - 2)]) < 1d-14))
      call holds('history between', abs(history(grit_penalty_normal_traction, 2) - 3) < 1d-14)
      call holds('parents from 0', all(parents(:, 2) == [0, 1]) .and. abs(weight(2) - 0.5d0) < 1d-14)
      call holds('without parents', grit_penalty_remesh(.false., 0.5d0, 0d0, 0d0, upper, new, count) == &
                 grit_ok)
      call holds('too small', grit_penalty_remesh(.false., 0.5d0, 0d0, 0d0, upper, new(:, :3), count) == &
                 grit_bad_call .and. count == 2*n - 1)
   end subroutine

   subroutine refusals()
      a = grit_penalty_surface_of(upper, force_a(:, :2), error=error)
      call holds('force: '//grit_message(error), grit_message(error) == &
                 'force must be (2, 5), got (2, 2)')
      error = grit_error()
      a = grit_penalty_surface_of(upper, force_a, stiffness=stiffness_a(:4), error=error)
      call holds('stiffness: '//grit_message(error), grit_message(error) == &
                 'stiffness must be (5), got (4)')
      force_b = 0
      call holds('what did not fit is refused', grit_penalty_forces(options, a, b) == grit_bad_call)
      call holds('nothing changed', all(force_b == 0))
      error = grit_error()
      call refused(grit_penalty_stable_step(stiffness_a(:2), stiffness_a, stiffness_b, stiffness_b, &
                                            step, error), error, 'stiffness_a must be (2), got (5)')
   end subroutine
end program
