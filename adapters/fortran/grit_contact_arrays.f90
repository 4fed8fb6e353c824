! SPDX-License-Identifier: BSD-3-Clause
! Contact at grid nodes on the arrays of a Fortran host: shapes are checked, nothing is copied.
module grit_contact_arrays
   use, intrinsic :: iso_c_binding
   use grit_base
   use grit_contact_interface
   implicit none
   private
   public :: grit_contact_correct, grit_contact_correct_many, grit_contact_options_init

   ! status = grit_contact_correct(mass_a, mass_b, normal, velocity_a, velocity_b [, distance,
   !    cell_size, spacing, gap, contact_area, acceleration_a, acceleration_b, previous_velocity_a,
   !    previous_velocity_b, position, pore_impulse, index, options, reports, sums, error])
   !   vectors (c, n), c = options%components; numbers per node (n); spacing (c, n) or (c, 1) for all;
   !   index: nodes to be taken, from 0; reports (n), with index of its size. Or with views, as C has it:
   !   grit_contact_correct(options, n, nodes, reports, sums, error).
   interface grit_contact_correct
      procedure correct_nodes, c_contact_correct
   end interface

   ! m bodies, p pairs: mass (n, m), velocity (c, n, m), pairs (2, p) bodies from 0, normal (c, n, p),
   ! distance, gap, contact_area, cell_size, pore_impulse (n, p), spacing (c), options (p), reports (p, n), sums (p).
   interface grit_contact_correct_many
      procedure correct_many, c_contact_correct_many
   end interface

contains

   integer(c_int) function grit_contact_options_init(options) result(status)
      type(grit_contact_options), intent(inout) :: options
      status = c_contact_options_init(options, c_sizeof(options))
   end function

   integer(c_int) function correct_nodes(mass_a, mass_b, normal, velocity_a, velocity_b, distance, &
                                         cell_size, spacing, gap, contact_area, acceleration_a, &
                                         acceleration_b, previous_velocity_a, previous_velocity_b, &
                                         position, index, options, reports, sums, error, &
                                         pore_impulse) &
      result(status)
      real(c_double), intent(in), target :: mass_a(:), mass_b(:), normal(:, :)
      real(c_double), intent(inout), target :: velocity_a(:, :), velocity_b(:, :)
      real(c_double), intent(in), target, optional :: distance(:), cell_size(:), spacing(:, :)
      real(c_double), intent(in), target, optional :: gap(:), contact_area(:), position(:, :)
      real(c_double), intent(in), target, optional :: pore_impulse(:)
      real(c_double), intent(inout), target, optional :: acceleration_a(:, :), acceleration_b(:, :)
      real(c_double), intent(in), target, optional :: previous_velocity_a(:, :)
      real(c_double), intent(in), target, optional :: previous_velocity_b(:, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: index(:)
      type(grit_contact_options), intent(in), optional :: options
      type(grit_contact_report), intent(inout), target, contiguous, optional :: reports(:)
      type(grit_contact_sums), intent(inout), optional :: sums
      type(grit_error), intent(inout), optional :: error
      type(grit_contact_nodes) :: nodes
      integer :: c, n, taken
      logical :: fit

      status = grit_bad_call
      c = 3
      if (present(options)) c = options%components
      n = size(mass_a)
      taken = n
      fit = .true.
      nodes%mass_a = numbers('mass_a', mass_a)
      nodes%mass_b = numbers('mass_b', mass_b)
      nodes%normal = vectors('normal', normal)
      nodes%velocity_a = vectors('velocity_a', velocity_a)
      nodes%velocity_b = vectors('velocity_b', velocity_b)
      nodes%distance = numbers('distance', distance)
      nodes%cell_size = numbers('cell_size', cell_size)
      nodes%gap = numbers('gap', gap)
      nodes%contact_area = numbers('contact_area', contact_area)
      nodes%acceleration_a = vectors('acceleration_a', acceleration_a)
      nodes%acceleration_b = vectors('acceleration_b', acceleration_b)
      nodes%previous_velocity_a = vectors('previous_velocity_a', previous_velocity_a)
      nodes%previous_velocity_b = vectors('previous_velocity_b', previous_velocity_b)
      nodes%position = vectors('position', position)
      nodes%pore_impulse = numbers('pore_impulse', pore_impulse)
      if (present(spacing)) then
         if (size(spacing, 2) == 1) then  ! of one cell: stride 0
            if (fit) fit = grit_fits('spacing', shape(spacing), [c, 1], error)
            nodes%spacing = grit_view_of(spacing)
         else
            nodes%spacing = vectors('spacing', spacing)
         end if
      end if
      if (.not. fit) return
      if (present(index)) then
         if (.not. grit_within('index', index, n, error)) return
         taken = size(index)
         if (taken > 0) nodes%index = c_loc(index)
      end if
      if (present(reports)) then
         if (.not. grit_fits('reports', shape(reports), [taken], error)) return
      end if
      status = c_contact_correct(options, int(taken, c_ptrdiff_t), nodes, reports, sums, error)

   contains

      type(grit_view) function numbers(name, a) result(view)
         character(*), intent(in) :: name
         real(c_double), intent(in), target, optional :: a(:)
         if (.not. (fit .and. present(a))) return
         fit = grit_fits(name, shape(a), [n], error)
         if (fit) view = grit_view_of(a)
      end function

      type(grit_view) function vectors(name, a) result(view)
         character(*), intent(in) :: name
         real(c_double), intent(in), target, optional :: a(:, :)
         if (.not. (fit .and. present(a))) return
         fit = grit_fits(name, shape(a), [c, n], error)
         if (fit) view = grit_view_of(a)
      end function
   end function

   integer(c_int) function correct_many(pairs, mass, velocity, normal, options, distance, gap, &
                                        contact_area, cell_size, spacing, acceleration, &
                                        previous_velocity, position, index, sweep_tolerance, &
                                        sweep_limit, reports, sums, error, pore_impulse) &
      result(status)
      integer, intent(in) :: pairs(:, :)
      real(c_double), intent(in), target :: mass(:, :), normal(:, :, :)
      real(c_double), intent(inout), target :: velocity(:, :, :)
      type(grit_contact_options), intent(in), target, contiguous :: options(:)
      real(c_double), intent(in), target, optional :: distance(:, :), gap(:, :)
      real(c_double), intent(in), target, optional :: contact_area(:, :), cell_size(:, :)
      real(c_double), intent(in), target, optional :: pore_impulse(:, :)
      real(c_double), intent(in), target, contiguous, optional :: spacing(:)
      real(c_double), intent(inout), target, optional :: acceleration(:, :, :)
      real(c_double), intent(in), target, optional :: previous_velocity(:, :, :), position(:, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: index(:)
      real(c_double), intent(in), optional :: sweep_tolerance
      integer, intent(in), optional :: sweep_limit
      type(grit_contact_report), intent(inout), contiguous, optional :: reports(:, :)
      type(grit_contact_sums), intent(inout), contiguous, optional :: sums(:)
      type(grit_error), intent(inout), optional :: error
      type(grit_contact_bodies) :: bodies
      type(grit_contact_pair) :: each(size(pairs, 2))
      type(grit_view), target :: masses(size(mass, 2)), previous(size(mass, 2))
      type(grit_mutable_view), target :: velocities(size(mass, 2)), accelerations(size(mass, 2))
      integer :: c, n, m, p, i, taken

      status = grit_bad_call
      c = size(velocity, 1)
      n = size(mass, 1)
      m = size(mass, 2)
      p = size(pairs, 2)
      taken = n
      if (.not. grit_fits('pairs', shape(pairs), [2, p], error)) return
      if (.not. grit_fits('options', shape(options), [p], error)) return
      if (.not. grit_fits('velocity', shape(velocity), [c, n, m], error)) return
      if (.not. grit_fits('normal', shape(normal), [c, n, p], error)) return
      if (.not. fits_pairs('distance', distance)) return
      if (.not. fits_pairs('gap', gap)) return
      if (.not. fits_pairs('contact_area', contact_area)) return
      if (.not. fits_pairs('cell_size', cell_size)) return
      if (.not. fits_pairs('pore_impulse', pore_impulse)) return
      if (present(spacing)) then
         if (.not. grit_fits('spacing', shape(spacing), [c], error)) return
      end if
      if (present(position)) then
         if (.not. grit_fits('position', shape(position), [c, n], error)) return
         bodies%position = grit_view_of(position)
      end if
      bodies%components = c
      bodies%count = m
      do i = 1, m
         masses(i) = grit_view_of(mass(:, i))
         velocities(i) = grit_view_of(velocity(:, :, i))
      end do
      bodies%mass = c_loc(masses)
      bodies%velocity = c_loc(velocities)
      if (present(acceleration)) then
         if (.not. grit_fits('acceleration', shape(acceleration), [c, n, m], error)) return
         do i = 1, m
            accelerations(i) = grit_view_of(acceleration(:, :, i))
         end do
         bodies%acceleration = c_loc(accelerations)
      end if
      if (present(previous_velocity)) then
         if (.not. grit_fits('previous_velocity', shape(previous_velocity), [c, n, m], error)) return
         do i = 1, m
            previous(i) = grit_view_of(previous_velocity(:, :, i))
         end do
         bodies%previous_velocity = c_loc(previous)
      end if
      if (present(sweep_tolerance)) bodies%sweep_tolerance = sweep_tolerance
      if (present(sweep_limit)) bodies%sweep_limit = sweep_limit
      do i = 1, p
         each(i)%a = pairs(1, i)
         each(i)%b = pairs(2, i)
         each(i)%options = c_loc(options(i))
         each(i)%normal = grit_view_of(normal(:, :, i))
         if (present(distance)) each(i)%distance = grit_view_of(distance(:, i))
         if (present(gap)) each(i)%gap = grit_view_of(gap(:, i))
         if (present(contact_area)) each(i)%contact_area = grit_view_of(contact_area(:, i))
         if (present(cell_size)) each(i)%cell_size = grit_view_of(cell_size(:, i))
         if (present(pore_impulse)) each(i)%pore_impulse = grit_view_of(pore_impulse(:, i))
         if (present(spacing)) each(i)%spacing = grit_view(c_loc(spacing), 0, 1)
      end do
      if (present(index)) then
         if (.not. grit_within('index', index, n, error)) return
         taken = size(index)
         if (taken > 0) bodies%index = c_loc(index)
      end if
      if (present(reports)) then
         if (.not. grit_fits('reports', shape(reports), [p, taken], error)) return
      end if
      if (present(sums)) then
         if (.not. grit_fits('sums', shape(sums), [p], error)) return
      end if
      status = c_contact_correct_many(bodies, int(p, c_int), each, int(taken, c_ptrdiff_t), &
                                      reports, sums, error)

   contains

      logical function fits_pairs(name, a)
         character(*), intent(in) :: name
         real(c_double), intent(in), optional :: a(:, :)
         fits_pairs = .true.
         if (present(a)) fits_pairs = grit_fits(name, shape(a), [n, p], error)
      end function
   end function
end module
