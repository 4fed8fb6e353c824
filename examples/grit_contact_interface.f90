! SPDX-License-Identifier: BSD-3-Clause
! The part of Grit's C interface that contact_step.f90 uses, through ISO_C_BINDING. A mutable view has
! the layout of a view.
module grit_contact_interface
   use, intrinsic :: iso_c_binding
   use grit_interface, only: grit_error, grit_view, grit_matrix_view
   implicit none

   integer(c_int), parameter :: contact_fixed_1 = 1  ! bit of the first component

   type, bind(c) :: grit_contact_gradients
      integer(c_size_t) :: struct_size = 0
      integer(c_int) :: components = 0, source = 0  ! 0: body A is the stiffer one
      type(c_ptr) :: index = c_null_ptr
      type(grit_view) :: gradient_a, gradient_b, given, scale
      real(c_double) :: threshold = 0
      type(c_ptr) :: fixed = c_null_ptr
      integer(c_ptrdiff_t) :: fixed_stride = 0
      type(c_ptr) :: status = c_null_ptr
      type(grit_view) :: normal
   end type

   type, bind(c) :: grit_contact_surfaces
      integer(c_size_t) :: struct_size = 0
      integer(c_int) :: components = 0, reserved = 0
      integer(c_ptrdiff_t) :: nodes = 0
      type(grit_view) :: position, normal, surface, centre
   end type

   type, bind(c) :: grit_contact_domains
      integer(c_size_t) :: struct_size = 0
      integer(c_int) :: body = 0, sides = 0
      type(c_ptr) :: index = c_null_ptr, offset = c_null_ptr
      integer(c_ptrdiff_t) :: nodes_each = 0
      type(c_ptr) :: node = c_null_ptr
      type(grit_view) :: position
      type(grit_matrix_view) :: side
   end type

   type, bind(c) :: grit_contact_distances
      integer(c_size_t) :: struct_size = 0
      integer(c_int) :: stiffer = 0, measure = 0
      type(c_ptr) :: index = c_null_ptr
      type(grit_view) :: distance, gap
   end type

   type, bind(c) :: grit_contact_options
      integer(c_size_t) :: struct_size
      integer(c_int) :: components, law
      real(c_double) :: penalty_power, friction_coefficient, adhesion, time_step
      real(c_double) :: mass_tolerance, gap_tolerance
      integer(c_int) :: rigid, allow_zero_normal, instruction_set, validate_only
   end type

   type, bind(c) :: grit_contact_nodes
      integer(c_size_t) :: struct_size = 0
      type(c_ptr) :: index = c_null_ptr
      type(grit_view) :: mass_a, mass_b, normal, distance, cell_size, spacing, gap, contact_area
      type(grit_view) :: velocity_a, velocity_b, acceleration_a, acceleration_b
      type(grit_view) :: previous_velocity_a, previous_velocity_b, position
   end type

   type, bind(c) :: grit_contact_report
      integer(c_int) :: status, state
      real(c_double) :: penalty_factor, impulse(3), force(3)
      real(c_double) :: trial_energy(2), dissipation(2)  ! normal, tangential
      real(c_double) :: reserved(4)
   end type

   type, bind(c) :: grit_contact_sums
      integer(c_int64_t) :: word(1200) = 0
   end type

   type, bind(c) :: grit_contact_totals
      integer(c_size_t) :: struct_size = 0
      real(c_double), dimension(3) :: impulse_on_a, impulse_on_b, force_on_a, force_on_b
      real(c_double), dimension(3) :: moment_on_a, moment_on_b
      real(c_double) :: trial_energy(2), dissipation(2)
      integer(c_ptrdiff_t) :: inactive, open, stick, slip, failed
   end type

   interface
      integer(c_int) function grit_contact_normals_from_gradients(n, gradients, counts, error) bind(c)
         import
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_gradients), intent(in) :: gradients
         type(c_ptr), value :: counts
         type(grit_error), intent(inout) :: error
      end function
      integer(c_int) function grit_contact_surfaces_reset(surfaces, error) bind(c)
         import
         type(grit_contact_surfaces), intent(in) :: surfaces
         type(grit_error), intent(inout) :: error
      end function
      integer(c_int) function grit_contact_surfaces_add(surfaces, n, domains, error) bind(c)
         import
         type(grit_contact_surfaces), intent(in) :: surfaces
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_domains), intent(in) :: domains
         type(grit_error), intent(inout) :: error
      end function
      integer(c_int) function grit_contact_surfaces_finish(surfaces, n, distances, error) bind(c)
         import
         type(grit_contact_surfaces), intent(in) :: surfaces
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_distances), intent(in) :: distances
         type(grit_error), intent(inout) :: error
      end function
      integer(c_int) function grit_contact_options_init(options, struct_size) bind(c)
         import
         type(grit_contact_options), intent(out) :: options
         integer(c_size_t), value :: struct_size
      end function
      integer(c_int) function grit_contact_correct(options, n, nodes, reports, sums, error) bind(c)
         import
         type(grit_contact_options), intent(in) :: options
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_nodes), intent(in) :: nodes
         type(grit_contact_report), intent(out) :: reports(*)
         type(grit_contact_sums), intent(inout) :: sums
         type(grit_error), intent(inout) :: error
      end function
      integer(c_int) function grit_contact_sums_read(sums, totals) bind(c)
         import
         type(grit_contact_sums), intent(in) :: sums
         type(grit_contact_totals), intent(inout) :: totals
      end function
   end interface
end module
