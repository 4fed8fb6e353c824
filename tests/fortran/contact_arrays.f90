! SPDX-License-Identifier: BSD-3-Clause
! Contact, normals and distances on arrays: hand-worked, and against C's views.
program contact_arrays
   use grit
   use expect
   implicit none
   integer, parameter :: n = 3
   type(grit_contact_options) :: options
   type(grit_contact_report) :: reports(n)
   type(grit_contact_sums) :: sums
   type(grit_contact_totals) :: totals
   type(grit_error) :: error
   real(c_double) :: mass_a(n), mass_b(n), velocity_a(2, n), velocity_b(2, n)
   real(c_double) :: distance(n), spacing(2, 1) = reshape([0.5d0, 2d0], [2, 1]), f_p
   real(c_double), target :: normal(2, n)

   call holds('options', grit_contact_options_init(options) == grit_ok)
   options%components = 2
   options%time_step = 0.1d0
   call meet()
   ! Masses 1 and 3 approach along 11 with 4; f_p = 1 at s = 0, 1 - 0.5^6 at half the cell of 0.5.
   call holds('correct', grit_contact_correct(mass_a, mass_b, normal, velocity_a, velocity_b, distance, &
                                              spacing=spacing, options=options, reports=reports, &
                                              sums=sums, error=error) == grit_ok)
   call holds('f_p', grit_contact_penalty_factor(0.25d0, 0.5d0, 6d0, f_p) == grit_ok)
   call holds('common velocity', all(abs([velocity_a(1, 1), velocity_b(1, 1)] - 0d0) < 1d-14))
   call holds('half a cell away', abs(velocity_a(1, 2) - (3 - 3*f_p)) < 1d-14 .and. &
              abs(velocity_b(1, 2) - (-1 + f_p)) < 1d-14)
   call holds('a cell away', velocity_a(1, 3) == 3 .and. velocity_b(1, 3) == -1)
   call holds('tangents stay', all(velocity_a(2, :) == 7) .and. all(velocity_b(2, :) == 7))
   call holds('states', all(reports%state == [grit_contact_slip, grit_contact_slip, &
                                              grit_contact_open]))
   call holds('sums', grit_contact_sums_read(sums, totals) == grit_ok)
   call holds('force on B', abs(totals%force_on_b(1) - 30*(1 + f_p)) < 1d-12 .and. totals%slip == 2)
   call in_time()
   call saturated()
   call chosen_nodes()
   call many()
   call normals()
   call distances()
   call refusals()
   call finish()

contains

   subroutine meet()
      mass_a = 1
      mass_b = 3
      velocity_a = spread([3d0, 7d0], 2, n)
      velocity_b = spread([-1d0, 7d0], 2, n)
      normal = spread([1d0, 0d0], 2, n)
      distance = [0d0, 0.25d0, 0.5d0]
   end subroutine

   ! In four steps of a quarter of its time the approach of 4 falls to that of one step of it.
   subroutine in_time()
      integer :: i
      call meet()
      options%relaxation_time = 4*options%time_step
      do i = 1, 4
         call holds('a quarter', grit_contact_correct(mass_a, mass_b, normal, velocity_a, velocity_b, &
                                                      distance, spacing=spacing, &
                                                      options=options) == grit_ok)
      end do
      call holds('relaxation', all(abs(velocity_a(1, :) - velocity_b(1, :) &
                                   - 4*[0d0, 1 - f_p, 1d0]) < 1d-14))
      options%relaxation_time = 0
      call holds('stiffness of none', options%contact_stiffness == 0)
   end subroutine

   ! Water that carries half of the normal impulse does not rub.
   subroutine saturated()
      call meet()
      velocity_a(2, :) = 0
      options%friction_coefficient = 0.1d0
      call holds('saturated', grit_contact_correct(mass_a, mass_b, normal, velocity_a, velocity_b, distance, &
                                                   spacing=spacing, options=options, reports=reports, &
                                                   pore_impulse=1.5d0*[1d0, f_p, 0d0]) == grit_ok)
      call holds('friction', all(abs(reports%impulse(2) + 0.15d0*[1d0, f_p, 0d0]) < 1d-14))
      options%friction_coefficient = 0
   end subroutine

   subroutine chosen_nodes()
      real(c_double) :: body_velocity(2, 2, n)
      call meet()
      body_velocity(:, 1, :) = velocity_a
      body_velocity(:, 2, :) = velocity_b
      call holds('sections', grit_contact_correct(mass_a, mass_b, normal, body_velocity(:, 1, :), &
                                                 body_velocity(:, 2, :), distance, spacing=spacing, &
                                                 index=[1_c_ptrdiff_t], options=options) == grit_ok)
      call holds('node 1 alone', abs(body_velocity(1, 1, 2) - (3 - 3*f_p)) < 1d-14)
      call holds('not node 0', body_velocity(1, 1, 1) == 3)
   end subroutine

   ! One pair of two bodies is what the pair's own call makes of it; three bodies in a row end alike.
   subroutine many()
      real(c_double) :: masses(n, 3), velocities(2, n, 3), pair_normals(2, n, 2), away(n, 2)
      type(grit_contact_report) :: pair_reports(2, n)
      integer :: body
      call meet()
      masses = 1
      masses(:, 2) = 3
      velocities(:, :, 1) = velocity_a
      velocities(:, :, 2) = velocity_b
      velocities(:, :, 3) = velocity_b
      pair_normals = spread(normal, 3, 2)
      away(:, 1) = distance
      away(:, 2) = 0
      call holds('one pair', grit_contact_correct_many(reshape([0, 1], [2, 1]), masses(:, :2), &
                 velocities(:, :, :2), pair_normals(:, :, :1), [options], away(:, :1), &
                 spacing=spacing(:, 1)) == grit_ok)
      call holds('pair alone', grit_contact_correct(mass_a, mass_b, normal, velocity_a, velocity_b, &
                                                   distance, spacing=spacing, options=options) == &
                 grit_ok)
      call holds('as the pair alone', all(velocities(:, :, 1) == velocity_a) .and. &
                 all(velocities(:, :, 2) == velocity_b))
      velocities(1, :, :) = spread([5d0, 0d0, -5d0], 1, n)
      call holds('three', grit_contact_correct_many(reshape([0, 1, 1, 2], [2, 2]), masses, velocities, &
                 pair_normals, [options, options], away*0, spacing=spacing(:, 1), &
                 reports=pair_reports, error=error) == grit_ok)
      do body = 1, 3
         call holds('three stop', all(abs(velocities(1, :, body)) < 1d-2))
      end do
      call holds('reports of pairs', all(pair_reports%state == grit_contact_slip))
   end subroutine

   ! Body A at the left of x = 0, B at the right: every source says +1.
   subroutine normals()
      real(c_double) :: gradient_a(2, n), gradient_b(2, n), x(2, 8)
      type(grit_contact_normal_counts) :: counts
      integer(c_int) :: body(8), status_of(n)
      integer :: i
      gradient_a = spread([2d0, 0d0], 2, n)
      gradient_a(:, 3) = 0
      gradient_b = -gradient_a
      normal = 9
      call holds('gradients', grit_contact_normals_from_gradients(grit_contact_normal_average, normal, &
                 gradient_a, gradient_b, status_of=status_of, counts=counts) == grit_ok)
      call holds('point from A to B', all(normal(:, 1) == [1d0, 0d0]) .and. all(normal(:, 3) == 0))
      call holds('counts', counts%defined == 2 .and. counts%undefined == 1)
      do i = 1, 8
         x(:, i) = [merge(-0.5d0, 0.5d0, i <= 4), 0.25d0*mod(i, 4)]
         body(i) = merge(grit_contact_body_a, grit_contact_body_b, i <= 4)
      end do
      normal = 9
      call holds('regression', grit_contact_normals_by_regression(x, body, [0_c_ptrdiff_t, &
                 8_c_ptrdiff_t], 1d0, normal(:, 1:1), error=error) == grit_ok)
      call holds('of two clouds', all(abs(normal(:, 1) - [1d0, 0d0]) < 1d-10) .and. normal(1, 2) == 9)
      call refused(grit_contact_normals_by_regression(x, body, [0_c_ptrdiff_t, 9_c_ptrdiff_t], 1d0, &
                                                      normal(:, 1:1), error=error), error, &
                   'offset must be in [0, 9), counted from 0, got 9')
   end subroutine

   ! One particle of each body, domains turned so that sides by rows would give other distances.
   subroutine distances()
      real(c_double), target :: position(2, 1) = 0, surface(2, 1)
      real(c_double) :: side(2, 2), d(1), gap(1)
      type(grit_contact_surfaces) :: surfaces
      integer(c_ptrdiff_t) :: node(1, 1) = 0
      normal(:, 1) = [1d0, 0d0]
      surfaces = grit_contact_surfaces_of(position, normal(:, 1:1), surface)
      call holds('reset', grit_contact_surfaces_reset(surfaces) == grit_ok)
      side(:, 1) = [0.1d0, 0.3d0]
      side(:, 2) = [0d0, 0.2d0]
      call holds('A', grit_contact_surfaces_add(surfaces, grit_contact_body_a, &
                 reshape([-0.5d0, 0d0], [2, 1]), node, side) == grit_ok)
      call holds('B', grit_contact_surfaces_add(surfaces, grit_contact_body_b, &
                 reshape([0.7d0, 0d0], [2, 1]), node, reshape(side, [2, 2, 1])) == grit_ok)
      call holds('finish', grit_contact_surfaces_finish(surfaces, d, gap) == grit_ok)
      call holds('sides are columns', abs(d(1) - 0.4d0) < 1d-14 .and. abs(gap(1) - 1d0) < 1d-14)
      call holds('points', grit_contact_surfaces_add(surfaces, grit_contact_body_b, &
                 reshape([0.5d0, 0d0], [2, 1]), node) == grit_ok)
      call holds('finish', grit_contact_surfaces_finish(surfaces, gap=gap) == grit_ok)
      call holds('the nearest counts', abs(gap(1) - 0.9d0) < 1d-14)
   end subroutine

   subroutine refusals()
      type(grit_contact_surfaces) :: surfaces
      real(c_double), target :: surface(3, n)
      call meet()
      call refused(correct(velocity_a(:, :2), normal), error, 'velocity_a must be (2, 3), got (2, 2)')
      call refused(correct(velocity_a, normal(:1, :)), error, 'normal must be (2, 3), got (1, 3)')
      call refused(grit_contact_correct(mass_a, mass_b, normal, velocity_a, velocity_b, distance(:1), &
                                        spacing=spacing, options=options, error=error), error, &
                   'distance must be (3), got (1)')
      surface = 0
      surfaces = grit_contact_surfaces_of(normal, normal, surface, error=error)
      call holds('surface: '//grit_message(error), grit_message(error) == &
                 'surface must be (2, 3), got (3, 3)')
      call holds('what did not fit is refused', grit_contact_surfaces_reset(surfaces) == grit_bad_call)
      call holds('nothing changed', all(velocity_a(1, :) == 3) .and. all(velocity_b(1, :) == -1))
   end subroutine

   integer(c_int) function correct(v, along)
      real(c_double), intent(inout), target :: v(:, :)
      real(c_double), intent(in), target :: along(:, :)
      correct = grit_contact_correct(mass_a, mass_b, along, v, velocity_b, distance, spacing=spacing, &
                                     options=options, error=error)
   end function
end program
