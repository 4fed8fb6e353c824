! SPDX-License-Identifier: BSD-3-Clause
! Penalty contact of lines as C has it: grit/contact_penalty.h. Places in a history count from 1.
module grit_penalty_interface
   use, intrinsic :: iso_c_binding
   use grit_base, only: grit_error, grit_view, grit_mutable_view
   implicit none
   public

   integer(c_int), parameter :: grit_penalty_tangential_traction = 1
   integer(c_int), parameter :: grit_penalty_normal_traction = 2, grit_penalty_history_size = 2
   integer(c_int), parameter :: grit_penalty_open = 0, grit_penalty_stick = 1, grit_penalty_slip = 2

   type, bind(c) :: grit_penalty_options
      integer(c_size_t) :: struct_size = 56
      integer(c_int) :: axisymmetric, validate_only
      real(c_double) :: normal_stiffness      ! eps_n [stress / length]
      real(c_double) :: tangential_stiffness  ! eps_t [stress / length]
      real(c_double) :: friction_coefficient  ! mu [-]
      real(c_double) :: depth_max             ! [length]
      real(c_double) :: time_step             ! dt [time]
   end type

   type, bind(c) :: grit_penalty_report
      integer(c_int) :: state = 0, reserved = 0
      integer(c_ptrdiff_t) :: segment = -1  ! from 0; -1: open
      real(c_double) :: place = 0, gap = 0, normal(2) = 0, area = 0
      real(c_double) :: normal_traction = 0, tangential_traction = 0, slip_rate = 0
   end type

   type, bind(c) :: grit_penalty_surface
      integer(c_size_t) :: struct_size = 152
      integer(c_int) :: closed = 0, reserved = 0
      integer(c_ptrdiff_t) :: count = 0
      type(grit_view) :: position, velocity
      type(grit_mutable_view) :: history, force, stiffness
      type(c_ptr) :: reports = c_null_ptr
   end type

   type, bind(c) :: grit_penalty_totals
      integer(c_size_t) :: struct_size = 136
      real(c_double) :: force_on_a(2) = 0, force_on_b(2) = 0, moment_on_a = 0, moment_on_b = 0
      real(c_double) :: contact_area = 0, normal_force = 0, energy_normal = 0
      real(c_double) :: energy_tangential = 0, dissipation = 0, largest_penetration = 0
      integer(c_ptrdiff_t) :: contacts_a = 0, contacts_b = 0, slips = 0, tests = 0
   end type

   type, bind(c) :: grit_penalty_remeshing
      integer(c_size_t) :: struct_size = 168
      integer(c_int) :: closed = 0, reserved = 0
      real(c_double) :: longest = 0, shortest = 0, tolerance = 0
      integer(c_ptrdiff_t) :: count = 0
      type(grit_view) :: position, history
      integer(c_ptrdiff_t) :: capacity = 0
      type(grit_mutable_view) :: new_position, new_history
      type(c_ptr) :: parents = c_null_ptr, weight = c_null_ptr
   end type

   interface
      integer(c_int) function c_penalty_options_init(options, struct_size) &
         bind(c, name='grit_penalty_options_init')
         import
         type(grit_penalty_options), intent(inout) :: options
         integer(c_size_t), value :: struct_size
      end function
      integer(c_int) function grit_penalty_stiffness(multiple, modulus, cell_size, normal_stiffness) &
         bind(c)
         import
         real(c_double), value :: multiple, modulus, cell_size
         real(c_double), intent(inout) :: normal_stiffness
      end function
      integer(c_size_t) function grit_penalty_workspace_size(n_a, n_b) bind(c)
         import
         integer(c_ptrdiff_t), value :: n_a, n_b
      end function
      integer(c_int) function c_penalty_forces(options, a, b, workspace, workspace_size, totals, &
                                               error) bind(c, name='grit_penalty_forces')
         import
         type(grit_penalty_options), intent(in) :: options
         type(grit_penalty_surface), intent(in) :: a, b
         type(c_ptr), value :: workspace
         integer(c_size_t), value :: workspace_size
         type(grit_penalty_totals), intent(inout), optional :: totals
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function grit_penalty_flush_stiffness(options, surface, error) bind(c)
         import
         type(grit_penalty_options), intent(in) :: options
         type(grit_penalty_surface), intent(in) :: surface
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function c_penalty_stable_step(n_a, mass_a, stiffness_a, n_b, mass_b, &
                                                    stiffness_b, step, error) &
         bind(c, name='grit_penalty_stable_step')
         import
         integer(c_ptrdiff_t), value :: n_a, n_b
         type(grit_view), intent(in) :: mass_a, stiffness_a, mass_b, stiffness_b
         real(c_double), intent(inout) :: step
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_size_t) function grit_penalty_remesh_workspace_size(count) bind(c)
         import
         integer(c_ptrdiff_t), value :: count
      end function
      integer(c_int) function c_penalty_remesh(remeshing, workspace, workspace_size, new_count, &
                                               error) bind(c, name='grit_penalty_remesh')
         import
         type(grit_penalty_remeshing), intent(in) :: remeshing
         type(c_ptr), value :: workspace
         integer(c_size_t), value :: workspace_size
         integer(c_ptrdiff_t), intent(inout) :: new_count
         type(grit_error), intent(inout), optional :: error
      end function
   end interface
end module
