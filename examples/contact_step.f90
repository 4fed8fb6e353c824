! SPDX-License-Identifier: BSD-3-Clause
! Contact in one step of a material-point code, from particles to corrected nodal velocities: a plate
! (A) slides over and presses on the ground (B), plane strain, 4 x 4 nodes. contact_step.c does the
! same in C and prints the same numbers.
program contact_step
   use grit
   implicit none
   integer, parameter :: columns = 4, nodes = 16, particles = 3, corners = 4
   real(c_double) :: mass(nodes, 2) = 0, velocity(2, nodes, 2), gradient(2, nodes, 2) = 0
   real(c_double), target :: position(2, nodes), normal(2, nodes), surface(2, nodes)
   real(c_double) :: distance(nodes), gap(nodes), spacing(2, 1) = 1
   ! Domains of 1 x 0.5: the plate's lower face is at 1.48, the ground's upper face at 1.5.
   real(c_double) :: x(2, particles, 2)
   real(c_double) :: side(2, 2) = reshape([0.5d0, 0d0, 0d0, 0.25d0], [2, 2])
   integer(c_ptrdiff_t) :: node(corners, particles, 2)  ! counted from 0, as C does
   ! The plate goes on to both sides: no normal has a first component.
   integer(c_int) :: fixed(nodes) = grit_contact_fixed_1
   type(grit_contact_surfaces) :: surfaces
   type(grit_contact_options) :: options
   type(grit_contact_report) :: reports(nodes)
   type(grit_contact_sums) :: sums
   type(grit_contact_totals) :: totals
   type(grit_error) :: error
   integer :: i, body

   do i = 1, nodes
      position(:, i) = [real(mod(i - 1, columns), c_double), real((i - 1)/columns, c_double)]
   end do
   do i = 1, particles
      x(:, i, 1) = [i - 0.5d0, 1.73d0]
      x(:, i, 2) = [i - 0.5d0, 1.25d0]
   end do
   call gather(1, 1000d0, [1d0, -0.5d0])
   call gather(2, 850d0, [0d0, 0d0])

   ! (C2): the plate is the stiffer body. Nodes where it is not get a zero normal.
   call check(grit_contact_normals_from_gradients(grit_contact_normal_of_a, normal, &
                                                  gradient(:, :, 1), fixed=fixed, error=error))

   ! (C3), (C4): distances of both surfaces to the nodes, from the domains of the particles.
   surfaces = grit_contact_surfaces_of(position, normal, surface, error=error)
   call check(grit_contact_surfaces_reset(surfaces, error))
   do body = 1, 2
      call check(grit_contact_surfaces_add(surfaces, int(body - 1, c_int), x(:, :, body), &
                                           node(:, :, body), side, error))
   end do
   call check(grit_contact_surfaces_finish(surfaces, distance, gap, error=error))

   ! (C1) to (C6).
   call check(grit_contact_options_init(options))
   options%components = 2
   options%penalty_power = 6
   options%friction_coefficient = 0.3d0
   options%time_step = 1d-3
   options%allow_zero_normal = 1
   call check(grit_contact_correct(mass(:, 1), mass(:, 2), normal, velocity(:, :, 1), &
                                   velocity(:, :, 2), distance, spacing=spacing, gap=gap, &
                                   options=options, reports=reports, sums=sums, error=error))

   do i = 5, 12
      write (*, '(a,i3,a,i2,a,f9.6,2(a,2f10.6))') 'node', i - 1, '  state', reports(i)%state, &
         '  f_p', reports(i)%penalty_factor, '  v_A', velocity(:, i, 1), '  v_B', velocity(:, i, 2)
   end do
   call check(grit_contact_sums_read(sums, totals))
   write (*, '(a,f10.3,f12.3,a)') 'force on the ground', totals%force_on_b(1:2), ' N/m'

contains

   ! Particles of one body to the nodes: mass, velocity and the gradient of (C2), bilinear weights.
   subroutine gather(b, m, v)
      integer, intent(in) :: b
      real(c_double), intent(in) :: m, v(2)
      real(c_double) :: place(2), along(2), dN(2)
      integer :: p, k, c, corner(2), cell(2), at
      do p = 1, particles
         cell = floor(x(:, p, b))
         place = x(:, p, b) - cell
         do k = 1, corners
            corner = [mod(k - 1, 2), (k - 1)/2]
            along = merge(place, 1 - place, corner == 1)
            dN = merge(1d0, -1d0, corner == 1)*along(2:1:-1)
            at = 1 + (cell(2) + corner(2))*columns + cell(1) + corner(1)
            node(k, p, b) = at - 1
            mass(at, b) = mass(at, b) + product(along)*m
            gradient(:, at, b) = gradient(:, at, b) + 0.5d0*dN
         end do
      end do
      do c = 1, 2
         velocity(c, :, b) = merge(v(c), 0d0, mass(:, b) > 0)
      end do
   end subroutine

   subroutine check(status)
      integer(c_int), intent(in) :: status
      if (status == grit_ok) return
      write (*, '(a)') grit_message(error)
      error stop
   end subroutine
end program
