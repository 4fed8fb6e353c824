! SPDX-License-Identifier: BSD-3-Clause
! Surface contact on arrays: two squares of one particle and four nodes each that run into each other, and three.
program surface_arrays
   use grit
   use expect
   implicit none
   type(grit_surface_options) :: options, of_pairs(2)
   type(grit_surface_totals) :: totals, of_pair(2)
   type(grit_surface_report), target :: reports(4)
   type(grit_surface) :: a, b, below(2), above(2)
   type(grit_error) :: error
   real(c_double), target :: vertex(2, 4, 2), mass(4, 2), v(2, 4, 2), v_old(2, 4, 2), weight(4, 4)
   integer(c_ptrdiff_t), target :: facet(2, 4, 2), node(4, 4), owner(4)
   integer(c_ptrdiff_t) :: vertices, facets
   integer :: i, body

   ! Nodes at the corners: a vertex moves as its node does.
   weight = 0
   do i = 1, 4
      node(:, i) = [0, 1, 2, 3]
      weight(i, i) = 1
   end do
   do body = 1, 2
      call holds('free edges', grit_surface_find_free( &
                 reshape([0.5d0, 0.5d0 + (body - 1)*1.001d0], [2, 1]), &
                 reshape([0.5d0, 0d0, 0d0, 0.5d0], [2, 2, 1]), 0.25d0, vertex(:, :, body), &
                 facet(:, :, body), vertices, facets, owner) == grit_ok)
      call holds('four of them', vertices == 4 .and. facets == 4 .and. all(owner == 0))
      mass(:, body) = body
      v(1, :, body) = 0.2d0
      v(2, :, body) = merge(1d0, -1d0, body == 1)
   end do
   v_old = v
   call holds('options', grit_surface_options_init(options) == grit_ok)
   options%time_step = 1d-3
   options%spacing = 1
   options%reach = 0.5d0
   options%sweep_tolerance = 1d-12
   a = grit_surface_of(vertex(:, :, 1), facet(:, :, 1), node, weight, mass(:, 1), v(:, :, 1), v_old(:, :, 1))
   b = grit_surface_of(vertex(:, :, 2), facet(:, :, 2), node, weight, mass(:, 2), v(:, :, 2), v_old(:, :, 2))
   call holds('correct', grit_surface_correct(options, a, b, reports, totals, error) == grit_ok)
   ! The gap of 1e-3 takes 1 of the 2 of the approach; the two nodes of each side share m_r = 2/3.
   call holds('impulse', abs(totals%impulse_on_b(2) - 2*2d0/3d0) < 1d-9)
   call holds('action and reaction', all(totals%impulse_on_a == -totals%impulse_on_b))
   call holds('velocities', all(abs(v(2, 3:4, 1) - v(2, 1:2, 2) - 1) < 1d-9))
   call holds('momentum', abs(sum(v(2, :, 1)) + 2*sum(v(2, :, 2)) + 4) < 1d-12)
   call holds('along the side nothing', all(v(1, :, :) == 0.2d0))
   call holds('reports', abs(sum(reports%normal_force)*options%time_step - totals%normal_impulse) < 1d-9)
   call holds('gap', abs(totals%smallest_gap - 1d-3) < 1d-12)
   options%reach = 0
   call refused(grit_surface_correct(options, a, b, error=error), error, 'reach')
   options%reach = 0.5d0
   call refused(grit_surface_correct(options, a, b, reports(1:3), error=error), error, 'reports')
   call three_squares()
   call finish()
contains
   ! One at rest between two that run into it from both sides, all at once: none of them moves into another.
   subroutine three_squares()
      real(c_double), target :: top(2, 4), v_top(2, 4)
      top = vertex(:, :, 2)
      top(2, :) = top(2, :) + 1.001d0
      v(:, :, 1) = spread([0d0, 2d0], 2, 4)
      v(:, :, 2) = 0
      v_top = spread([0d0, -1d0], 2, 4)
      options%time_step = 1d-3
      of_pairs = options
      below = grit_surface_of(vertex(:, :, 1), facet(:, :, 1), node, weight, mass(:, 1), v(:, :, 1))
      below(2) = grit_surface_of(vertex(:, :, 2), facet(:, :, 2), node, weight, mass(:, 2), v(:, :, 2))
      above(1) = below(2)
      above(2) = grit_surface_of(top, facet(:, :, 2), node, weight, mass(:, 1), v_top)
      above(1)%body = 2
      below(2)%body = 2
      call holds('pairs', grit_surface_correct_pairs(of_pairs, below, above, of_pair, error) == grit_ok)
      ! The gaps of 1e-3 take 1: of 2 and of 1. The middle one, of twice their mass, has lost 2 for the other's 1.
      call holds('the lower pair', all(abs(v(2, 3:4, 1) - v(2, 1:2, 2) - 1) < 1d-9))
      call holds('the upper pair', all(v(2, 3:4, 2) - v_top(2, 1:2) < 1 + 1d-9))
      call holds('momentum of three', abs(sum(v(2, :, 1)) + 2*sum(v(2, :, 2)) + sum(v_top(2, :)) - 4) < 1d-12)
      of_pairs(2)%reach = 0
      call refused(grit_surface_correct_pairs(of_pairs, below, above, of_pair, error), error, 'pair 1: reach')
   end subroutine
end program
