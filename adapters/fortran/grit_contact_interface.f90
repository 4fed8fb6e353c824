! SPDX-License-Identifier: BSD-3-Clause
! Contact at grid nodes as C has it: grit/contact.h, which says what each member means.
module grit_contact_interface
   use, intrinsic :: iso_c_binding
   use grit_base, only: grit_error, grit_view, grit_mutable_view
   implicit none
   public

   integer(c_int), parameter :: grit_contact_geo = 0, grit_contact_frictional = 1
   integer(c_int), parameter :: grit_contact_none_rigid = 0, grit_contact_a_rigid = 1
   integer(c_int), parameter :: grit_contact_b_rigid = 2
   integer(c_int), parameter :: grit_contact_inactive = 0, grit_contact_open = 1
   integer(c_int), parameter :: grit_contact_stick = 2, grit_contact_slip = 3
   integer(c_int), parameter :: grit_contact_sums_words = 1200, grit_contact_most_bodies = 8

   type, bind(c) :: grit_contact_options
      integer(c_size_t) :: struct_size = 96
      integer(c_int) :: components, law
      real(c_double) :: penalty_power         ! k [-]
      real(c_double) :: friction_coefficient  ! mu [-]
      real(c_double) :: adhesion              ! c_a [stress]
      real(c_double) :: time_step             ! dt [time]
      real(c_double) :: mass_tolerance        ! [-]
      real(c_double) :: gap_tolerance         ! [length]
      integer(c_int) :: rigid, allow_zero_normal, instruction_set, validate_only
      real(c_double) :: relaxation_time       ! tau [time]
      real(c_double) :: contact_stiffness     ! epsilon [stress/length]
   end type

   type, bind(c) :: grit_contact_nodes
      integer(c_size_t) :: struct_size = 400
      type(c_ptr) :: index = c_null_ptr
      type(grit_view) :: mass_a, mass_b, normal, distance, cell_size, spacing, gap, contact_area
      type(grit_mutable_view) :: velocity_a, velocity_b, acceleration_a, acceleration_b
      type(grit_view) :: previous_velocity_a, previous_velocity_b, position, pore_impulse
   end type

   type, bind(c) :: grit_contact_report
      integer(c_int) :: status = 0, state = 0
      real(c_double) :: penalty_factor = 0           ! f_p [-]
      real(c_double) :: impulse(3) = 0, force(3) = 0  ! on B
      real(c_double) :: trial_energy_normal = 0, trial_energy_tangential = 0
      real(c_double) :: dissipation_normal = 0, dissipation_tangential = 0
      real(c_double) :: reserved(4) = 0
   end type

   type, bind(c) :: grit_contact_sums
      integer(c_int64_t) :: word(grit_contact_sums_words) = 0
   end type

   type, bind(c) :: grit_contact_totals
      integer(c_size_t) :: struct_size = 224
      real(c_double), dimension(3) :: impulse_on_a, impulse_on_b, force_on_a, force_on_b
      real(c_double), dimension(3) :: moment_on_a, moment_on_b
      real(c_double) :: trial_energy_normal, trial_energy_tangential
      real(c_double) :: dissipation_normal, dissipation_tangential
      integer(c_ptrdiff_t) :: inactive, open, stick, slip, failed
   end type

   type, bind(c) :: grit_contact_pair
      integer(c_size_t) :: struct_size = 192
      integer(c_int) :: a = 0, b = 0
      type(c_ptr) :: options = c_null_ptr
      type(grit_view) :: normal, distance, cell_size, spacing, gap, contact_area, pore_impulse
   end type

   type, bind(c) :: grit_contact_bodies
      integer(c_size_t) :: struct_size = 104
      integer(c_int) :: components = 0, count = 0
      type(c_ptr) :: index = c_null_ptr
      type(c_ptr) :: mass = c_null_ptr, velocity = c_null_ptr  ! arrays of views, one per body
      type(c_ptr) :: acceleration = c_null_ptr, previous_velocity = c_null_ptr
      type(grit_view) :: position
      real(c_double) :: sweep_tolerance = 0
      integer(c_int) :: sweep_limit = 0, instruction_set = 0, validate_only = 0, reserved = 0
   end type

   interface
      integer(c_int) function c_contact_options_init(options, struct_size) &
         bind(c, name='grit_contact_options_init')
         import
         type(grit_contact_options), intent(inout) :: options
         integer(c_size_t), value :: struct_size
      end function
      integer(c_int) function c_contact_correct(options, n, nodes, reports, sums, error) &
         bind(c, name='grit_contact_correct')
         import
         type(grit_contact_options), intent(in), optional :: options
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_nodes), intent(in) :: nodes
         type(grit_contact_report), intent(inout), optional :: reports(*)
         type(grit_contact_sums), intent(inout), optional :: sums
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function c_contact_correct_many(bodies, pair_count, pairs, n, reports, sums, &
                                                     error) bind(c, name='grit_contact_correct_many')
         import
         type(grit_contact_bodies), intent(in) :: bodies
         integer(c_int), value :: pair_count
         type(grit_contact_pair), intent(in) :: pairs(*)
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_report), intent(inout), optional :: reports(*)
         type(grit_contact_sums), intent(inout), optional :: sums(*)
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function grit_contact_sums_add(into, from) bind(c)
         import
         type(grit_contact_sums), intent(inout) :: into
         type(grit_contact_sums), intent(in) :: from
      end function
      integer(c_int) function grit_contact_sums_read(sums, totals) bind(c)
         import
         type(grit_contact_sums), intent(in) :: sums
         type(grit_contact_totals), intent(inout) :: totals
      end function
      integer(c_int) function grit_contact_penalty_factor(s, d, k, f_p) bind(c)
         import
         real(c_double), value :: s, d, k
         real(c_double), intent(inout) :: f_p
      end function
   end interface
end module
