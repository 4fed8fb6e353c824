! SPDX-License-Identifier: BSD-3-Clause
! Contact in one step of a material-point code, from particles to corrected nodal velocities: a plate
! (A) slides over and presses on the ground (B), plane strain, 4 x 4 nodes. contact_step.c does the
! same in C and prints the same numbers.
program contact_step
   use grit_interface, only: grit_error, grit_view, grit_matrix_view, grit_ok
   use grit_contact_interface
   implicit none
   integer, parameter :: columns = 4, nodes = 16, particles = 3, corners = 4
   integer(c_ptrdiff_t), parameter :: n = nodes
   real(c_double), target :: position(2, nodes), mass(nodes, 2) = 0, velocity(2, nodes, 2)
   real(c_double), target :: gradient(2, nodes, 2) = 0, normal(2, nodes), surface(2, nodes)
   real(c_double), target :: distance(nodes), gap(nodes), spacing(2) = 1
   ! Domains of 1 x 0.5: the plate's lower face is at 1.48, the ground's upper face at 1.5.
   real(c_double), target :: x(2, particles, 2)
   real(c_double), target :: side(2, 2) = reshape([0.5d0, 0d0, 0d0, 0.25d0], [2, 2])
   integer(c_ptrdiff_t), target :: node(corners, particles, 2)  ! counted from 0, as C does
   ! The plate goes on to both sides: no normal has a first component.
   integer(c_int), target :: fixed(nodes) = contact_fixed_1
   type(grit_contact_gradients) :: normals
   type(grit_contact_surfaces) :: surfaces
   type(grit_contact_domains) :: domains
   type(grit_contact_distances) :: distances
   type(grit_contact_options) :: options
   type(grit_contact_nodes) :: views
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
   normals%struct_size = c_sizeof(normals)
   normals%components = 2
   normals%gradient_a = vector(c_loc(gradient(1, 1, 1)))
   normals%fixed = c_loc(fixed)
   normals%normal = vector(c_loc(normal))
   call check(grit_contact_normals_from_gradients(n, normals, c_null_ptr, error))

   ! (C3), (C4): distances of both surfaces to the nodes, from the domains of the particles.
   surfaces%struct_size = c_sizeof(surfaces)
   surfaces%components = 2
   surfaces%nodes = n
   surfaces%position = vector(c_loc(position))
   surfaces%normal = vector(c_loc(normal))
   surfaces%surface = vector(c_loc(surface))
   call check(grit_contact_surfaces_reset(surfaces, error))
   domains%struct_size = c_sizeof(domains)
   domains%sides = 2
   domains%nodes_each = corners
   domains%side = grit_matrix_view(c_loc(side), 0, 2, 1)
   do body = 1, 2
      domains%body = body - 1
      domains%node = c_loc(node(1, 1, body))
      domains%position = vector(c_loc(x(1, 1, body)))
      call check(grit_contact_surfaces_add(surfaces, int(particles, c_ptrdiff_t), domains, error))
   end do
   distances%struct_size = c_sizeof(distances)
   distances%distance = scalar(c_loc(distance))
   distances%gap = scalar(c_loc(gap))
   call check(grit_contact_surfaces_finish(surfaces, n, distances, error))

   ! (C1) to (C6).
   call check(grit_contact_options_init(options, c_sizeof(options)))
   options%components = 2
   options%penalty_power = 6
   options%friction_coefficient = 0.3d0
   options%time_step = 1d-3
   options%allow_zero_normal = 1
   views%struct_size = c_sizeof(views)
   views%mass_a = scalar(c_loc(mass(1, 1)))
   views%mass_b = scalar(c_loc(mass(1, 2)))
   views%normal = vector(c_loc(normal))
   views%distance = scalar(c_loc(distance))
   views%gap = scalar(c_loc(gap))
   views%spacing = grit_view(c_loc(spacing), 0, 1)
   views%velocity_a = vector(c_loc(velocity(1, 1, 1)))
   views%velocity_b = vector(c_loc(velocity(1, 1, 2)))
   call check(grit_contact_correct(options, n, views, reports, sums, error))

   do i = 5, 12
      write (*, '(a,i3,a,i2,a,f9.6,2(a,2f10.6))') 'node', i - 1, '  state', reports(i)%state, &
         '  f_p', reports(i)%penalty_factor, '  v_A', velocity(:, i, 1), '  v_B', velocity(:, i, 2)
   end do
   totals%struct_size = c_sizeof(totals)
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

   ! Arrays of one number and of two components per node.
   type(grit_view) function scalar(first)
      type(c_ptr), intent(in) :: first
      scalar = grit_view(first, 1, 1)
   end function
   type(grit_view) function vector(first)
      type(c_ptr), intent(in) :: first
      vector = grit_view(first, 2, 1)
   end function

   subroutine check(status)
      integer(c_int), intent(in) :: status
      if (status == grit_ok) return
      write (*, '(256a)') error%message
      error stop
   end subroutine
end program
