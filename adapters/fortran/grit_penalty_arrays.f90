! SPDX-License-Identifier: BSD-3-Clause
! Penalty contact on the arrays of a Fortran host: shapes are checked, workspaces are its own.
module grit_penalty_arrays
   use, intrinsic :: iso_c_binding
   use grit_base
   use grit_penalty_interface
   implicit none
   private
   public :: grit_penalty_options_init, grit_penalty_surface_of, grit_penalty_forces
   public :: grit_penalty_stable_step, grit_penalty_remesh

   ! status = grit_penalty_forces(options, a, b [, totals, error])
   interface grit_penalty_forces
      procedure forces, c_penalty_forces
   end interface
   ! status = grit_penalty_stable_step(mass_a, stiffness_a, mass_b, stiffness_b, step [, error]), (n)
   interface grit_penalty_stable_step
      procedure stable_step, c_penalty_stable_step
   end interface
   ! status = grit_penalty_remesh(closed, longest, shortest, tolerance, position, new_position, count
   !    [, history, new_history, parents, weight, error]): position, history (2, old), the new ones
   !    (2, capacity), parents (2, capacity) from 0, weight (capacity).
   interface grit_penalty_remesh
      procedure remesh, c_penalty_remesh
   end interface

contains

   integer(c_int) function grit_penalty_options_init(options) result(status)
      type(grit_penalty_options), intent(inout) :: options
      status = c_penalty_options_init(options, c_sizeof(options))
   end function

   ! Views of position, velocity, history, force (2, n), stiffness (n), reports (n), which are targets
   ! for as long as the surface is used. struct_size 0, which every call refuses, if the shapes do not
   ! fit.
   type(grit_penalty_surface) function grit_penalty_surface_of(position, force, velocity, history, &
                                                               stiffness, closed, reports, error) &
      result(surface)
      real(c_double), intent(in), target :: position(:, :)
      real(c_double), intent(inout), target, optional :: force(:, :), history(:, :), stiffness(:)
      real(c_double), intent(in), target, optional :: velocity(:, :)
      logical, intent(in), optional :: closed
      type(grit_penalty_report), intent(inout), target, contiguous, optional :: reports(:)
      type(grit_error), intent(inout), optional :: error
      integer :: n
      n = size(position, 2)
      surface%struct_size = 0
      if (.not. grit_fits('position', shape(position), [2, n], error)) return
      surface%count = n
      surface%position = grit_view_of(position)
      if (present(force)) then
         if (.not. grit_fits('force', shape(force), [2, n], error)) return
         surface%force = grit_view_of(force)
      end if
      if (present(velocity)) then
         if (.not. grit_fits('velocity', shape(velocity), [2, n], error)) return
         surface%velocity = grit_view_of(velocity)
      end if
      if (present(history)) then
         if (.not. grit_fits('history', shape(history), [2, n], error)) return
         surface%history = grit_view_of(history)
      end if
      if (present(stiffness)) then
         if (.not. grit_fits('stiffness', shape(stiffness), [n], error)) return
         surface%stiffness = grit_view_of(stiffness)
      end if
      if (present(reports)) then
         if (.not. grit_fits('reports', shape(reports), [n], error)) return
         if (n > 0) surface%reports = c_loc(reports)
      end if
      if (present(closed)) surface%closed = merge(1, 0, closed)
      surface%struct_size = c_sizeof(surface)
   end function

   integer(c_int) function forces(options, a, b, totals, error) result(status)
      type(grit_penalty_options), intent(in) :: options
      type(grit_penalty_surface), intent(in) :: a, b
      type(grit_penalty_totals), intent(inout), optional :: totals
      type(grit_error), intent(inout), optional :: error
      real(c_double), allocatable, target :: workspace(:)
      integer(c_size_t) :: bytes
      bytes = grit_penalty_workspace_size(a%count, b%count)
      allocate (workspace(bytes/8 + 1))
      status = c_penalty_forces(options, a, b, c_loc(workspace), bytes, totals, error)
   end function

   integer(c_int) function stable_step(mass_a, stiffness_a, mass_b, stiffness_b, step, error) &
      result(status)
      real(c_double), intent(in), target :: mass_a(:), stiffness_a(:), mass_b(:), stiffness_b(:)
      real(c_double), intent(inout) :: step
      type(grit_error), intent(inout), optional :: error
      status = grit_bad_call
      if (.not. grit_fits('stiffness_a', shape(stiffness_a), shape(mass_a), error)) return
      if (.not. grit_fits('stiffness_b', shape(stiffness_b), shape(mass_b), error)) return
      status = c_penalty_stable_step(size(mass_a, kind=c_ptrdiff_t), grit_view_of(mass_a), &
                                     grit_view_of(stiffness_a), size(mass_b, kind=c_ptrdiff_t), &
                                     grit_view_of(mass_b), grit_view_of(stiffness_b), step, error)
   end function

   integer(c_int) function remesh(closed, longest, shortest, tolerance, position, new_position, &
                                  count, history, new_history, parents, weight, error) result(status)
      logical, intent(in) :: closed
      real(c_double), intent(in) :: longest, shortest, tolerance
      real(c_double), intent(in), target :: position(:, :)
      real(c_double), intent(inout), target :: new_position(:, :)
      integer(c_ptrdiff_t), intent(inout) :: count  ! of new vertices
      real(c_double), intent(in), target, optional :: history(:, :)
      real(c_double), intent(inout), target, optional :: new_history(:, :)
      integer(c_ptrdiff_t), intent(inout), target, contiguous, optional :: parents(:, :)
      real(c_double), intent(inout), target, contiguous, optional :: weight(:)
      type(grit_error), intent(inout), optional :: error
      type(grit_penalty_remeshing) :: line
      real(c_double), allocatable, target :: workspace(:), some_weight(:)
      integer(c_ptrdiff_t), allocatable, target :: some_parents(:, :)
      integer(c_size_t) :: bytes
      integer :: old, capacity

      status = grit_bad_call
      old = size(position, 2)
      capacity = size(new_position, 2)
      if (.not. grit_fits('position', shape(position), [2, old], error)) return
      if (.not. grit_fits('new_position', shape(new_position), [2, capacity], error)) return
      line%closed = merge(1, 0, closed)
      line%longest = longest
      line%shortest = shortest
      line%tolerance = tolerance
      line%count = old
      line%capacity = capacity
      line%position = grit_view_of(position)
      line%new_position = grit_view_of(new_position)
      if (present(history)) then
         if (.not. grit_fits('history', shape(history), [2, old], error)) return
         line%history = grit_view_of(history)
      end if
      if (present(new_history)) then
         if (.not. grit_fits('new_history', shape(new_history), [2, capacity], error)) return
         line%new_history = grit_view_of(new_history)
      end if
      ! C wants these two in any case.
      allocate (some_parents(2, capacity + 1), some_weight(capacity + 1))
      line%parents = c_loc(some_parents)
      line%weight = c_loc(some_weight)
      if (present(parents)) then
         if (.not. grit_fits('parents', shape(parents), [2, capacity], error)) return
         if (capacity > 0) line%parents = c_loc(parents)
      end if
      if (present(weight)) then
         if (.not. grit_fits('weight', shape(weight), [capacity], error)) return
         if (capacity > 0) line%weight = c_loc(weight)
      end if
      bytes = grit_penalty_remesh_workspace_size(line%count)
      allocate (workspace(bytes/8 + 1))
      status = c_penalty_remesh(line, c_loc(workspace), bytes, count, error)
   end function
end module
