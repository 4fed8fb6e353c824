! SPDX-License-Identifier: BSD-3-Clause
! Surface contact as C has it: grit/contact_surface.h. Ids of facets, vertices and nodes count from 0.
module grit_surface_interface
   use, intrinsic :: iso_c_binding
   use grit_base, only: grit_error, grit_view, grit_mutable_view, grit_matrix_view
   implicit none
   public

   type, bind(c) :: grit_surface_options
      integer(c_size_t) :: struct_size = 88
      integer(c_int) :: components, axisymmetric, validate_only, sweep_limit
      real(c_double) :: sweep_tolerance       ! [-]
      real(c_double) :: friction_coefficient  ! mu [-]
      real(c_double) :: time_step             ! dt [time]
      real(c_double) :: spacing               ! [length]
      real(c_double) :: reach                 ! [length]
      real(c_double) :: end_spacings          ! [-]
      real(c_double) :: contact_stiffness     ! eps [stress / length]
      real(c_double) :: relaxation_time       ! tau [time]
   end type

   ! facet (components, facets), node and weight (nodes_each, vertices), fixed, water_fixed and number (nodes), spacing and
   ! pore_pressure (facets): c_loc of arrays. pores (3, nodes): mass of water, drag, porosity.
   type, bind(c) :: grit_surface
      integer(c_size_t) :: struct_size = 304
      integer(c_int) :: rigid = 0, nodes_each = 0
      integer(c_ptrdiff_t) :: vertices = 0, facets = 0
      type(grit_view) :: position
      type(c_ptr) :: facet = c_null_ptr, node = c_null_ptr, weight = c_null_ptr
      integer(c_ptrdiff_t) :: nodes = 0
      type(grit_view) :: mass
      type(c_ptr) :: fixed = c_null_ptr
      type(grit_mutable_view) :: velocity
      type(grit_view) :: previous_velocity, vertex_velocity
      type(c_ptr) :: spacing = c_null_ptr
      type(grit_view) :: pores
      type(c_ptr) :: water_fixed = c_null_ptr
      type(grit_mutable_view) :: seepage
      type(grit_view) :: previous_seepage
      type(c_ptr) :: pore_pressure = c_null_ptr
      integer(c_int) :: body = 0
      type(c_ptr) :: number = c_null_ptr
   end type

   ! c_loc of grit_surface_options, grit_surface, reports (facets of a) and grit_surface_totals.
   type, bind(c) :: grit_surface_pair
      type(c_ptr) :: options = c_null_ptr, a = c_null_ptr, b = c_null_ptr
      type(c_ptr) :: reports = c_null_ptr, totals = c_null_ptr
   end type

   type, bind(c) :: grit_surface_report
      real(c_double) :: area = 0, gap = 0, normal_force = 0, friction_force = 0, force(3) = 0
   end type

   type, bind(c) :: grit_surface_totals
      integer(c_size_t) :: struct_size = 160
      real(c_double) :: impulse_on_a(3) = 0, impulse_on_b(3) = 0, normal_impulse = 0, area = 0
      real(c_double) :: dissipation_normal = 0, dissipation_tangential = 0, smallest_gap = 0
      real(c_double) :: largest_approach = 0, residual = 0
      integer(c_ptrdiff_t) :: points = 0, pressures = 0, sweeps = 0
      ! Of grit_surface_row and grit_surface_term, in the caller's workspace; null where the call has its own.
      type(c_ptr) :: row = c_null_ptr, term = c_null_ptr
      integer(c_ptrdiff_t) :: rows = 0
   end type

   type, bind(c) :: grit_surface_row
      integer(c_ptrdiff_t) :: first_term, terms
      real(c_double) :: bound, rigid(3), impulse(3), water_impulse(2)
   end type

   type, bind(c) :: grit_surface_term
      integer(c_ptrdiff_t) :: node
      integer(c_int) :: of_b
      real(c_double) :: direction(3, 3)
   end type

   type, bind(c) :: grit_surface_domains
      integer(c_size_t) :: struct_size = 88
      integer(c_ptrdiff_t) :: n = 0
      type(c_ptr) :: index = c_null_ptr
      type(grit_view) :: position
      type(grit_matrix_view) :: side
      real(c_double) :: tolerance = 0
   end type

   interface
      integer(c_int) function c_surface_options_init(options, struct_size) &
         bind(c, name='grit_surface_options_init')
         import
         type(grit_surface_options), intent(inout) :: options
         integer(c_size_t), value :: struct_size
      end function
      integer(c_size_t) function grit_surface_workspace_size(a, b) bind(c)
         import
         type(grit_surface), intent(in) :: a, b
      end function
      integer(c_int) function c_surface_correct(options, a, b, workspace, workspace_size, needed, &
                                                reports, totals, error) &
         bind(c, name='grit_surface_correct')
         import
         type(grit_surface_options), intent(in) :: options
         type(grit_surface), intent(in) :: a, b
         type(c_ptr), value :: workspace
         integer(c_size_t), value :: workspace_size
         integer(c_size_t), intent(inout), optional :: needed
         type(c_ptr), value :: reports
         type(grit_surface_totals), intent(inout), optional :: totals
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_size_t) function grit_surface_pairs_workspace_size(pairs, n) bind(c)
         import
         type(grit_surface_pair), intent(in) :: pairs(*)
         integer(c_ptrdiff_t), value :: n
      end function
      integer(c_int) function c_surface_correct_pairs(pairs, n, workspace, workspace_size, needed, error) &
         bind(c, name='grit_surface_correct_pairs')
         import
         type(grit_surface_pair), intent(in) :: pairs(*)
         integer(c_ptrdiff_t), value :: n
         type(c_ptr), value :: workspace
         integer(c_size_t), value :: workspace_size
         integer(c_size_t), intent(inout), optional :: needed
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_size_t) function grit_surface_find_free_workspace_size(n) bind(c)
         import
         integer(c_ptrdiff_t), value :: n
      end function
      integer(c_int) function c_surface_find_free(domains, workspace, workspace_size, position, facet, &
                                                  owner, vertices, facets, error) &
         bind(c, name='grit_surface_find_free')
         import
         type(grit_surface_domains), intent(in) :: domains
         type(c_ptr), value :: workspace
         integer(c_size_t), value :: workspace_size
         type(c_ptr), value :: position, facet, owner
         integer(c_ptrdiff_t), intent(inout) :: vertices, facets
         type(grit_error), intent(inout), optional :: error
      end function
   end interface
end module
