! SPDX-License-Identifier: BSD-3-Clause
! Normals and distances as C has them: grit/contact_normals.h and grit/contact_distance.h.
module grit_geometry_interface
   use, intrinsic :: iso_c_binding
   use grit_base, only: grit_error, grit_view, grit_mutable_view, grit_matrix_view
   implicit none
   public

   integer(c_int), parameter :: grit_contact_body_a = 0, grit_contact_body_b = 1
   integer(c_int), parameter :: grit_contact_fixed_1 = 1, grit_contact_fixed_2 = 2
   integer(c_int), parameter :: grit_contact_fixed_3 = 4
   integer(c_int), parameter :: grit_contact_normal_of_a = 0, grit_contact_normal_of_b = 1
   integer(c_int), parameter :: grit_contact_normal_average = 2, grit_contact_normal_given = 3
   integer(c_int), parameter :: grit_contact_support = 0, grit_contact_edge = 1
   integer(c_int), parameter :: grit_contact_nearest_centre = 2

   type, bind(c) :: grit_contact_normal_counts
      integer(c_size_t) :: struct_size = 32
      integer(c_ptrdiff_t) :: defined = 0, undefined = 0, failed = 0
   end type

   type, bind(c) :: grit_contact_gradients
      integer(c_size_t) :: struct_size = 176
      integer(c_int) :: components = 0, source = 0
      type(c_ptr) :: index = c_null_ptr
      type(grit_view) :: gradient_a, gradient_b, given, scale
      real(c_double) :: threshold = 0
      type(c_ptr) :: fixed = c_null_ptr
      integer(c_ptrdiff_t) :: fixed_stride = 0
      type(c_ptr) :: status = c_null_ptr
      type(grit_mutable_view) :: normal
   end type

   type, bind(c) :: grit_contact_clouds
      integer(c_size_t) :: struct_size = 184
      integer(c_int) :: components = 0, instruction_set = 0
      type(c_ptr) :: index = c_null_ptr, offset = c_null_ptr, particle = c_null_ptr
      integer(c_ptrdiff_t) :: particles = 0
      type(grit_view) :: position
      type(c_ptr) :: body = c_null_ptr
      integer(c_ptrdiff_t) :: body_stride = 0
      type(grit_view) :: weight
      real(c_double) :: length = 0, ridge = 0
      integer(c_int) :: iteration_limit = 0, reserved = 0
      type(c_ptr) :: fixed = c_null_ptr
      integer(c_ptrdiff_t) :: fixed_stride = 0
      type(c_ptr) :: status = c_null_ptr
      type(grit_mutable_view) :: normal
   end type

   type, bind(c) :: grit_contact_surfaces
      integer(c_size_t) :: struct_size = 120
      integer(c_int) :: components = 0, reserved = 0
      integer(c_ptrdiff_t) :: nodes = 0
      type(grit_view) :: position, normal
      type(grit_mutable_view) :: surface, centre
   end type

   type, bind(c) :: grit_contact_domains
      integer(c_size_t) :: struct_size = 104
      integer(c_int) :: body = 0, sides = 0
      type(c_ptr) :: index = c_null_ptr, offset = c_null_ptr
      integer(c_ptrdiff_t) :: nodes_each = 0
      type(c_ptr) :: node = c_null_ptr
      type(grit_view) :: position
      type(grit_matrix_view) :: side
   end type

   type, bind(c) :: grit_contact_distances
      integer(c_size_t) :: struct_size = 72
      integer(c_int) :: stiffer = 0, measure = 0
      type(c_ptr) :: index = c_null_ptr
      type(grit_mutable_view) :: distance, gap
   end type

   interface
      integer(c_int) function c_contact_normals_from_gradients(n, gradients, counts, error) &
         bind(c, name='grit_contact_normals_from_gradients')
         import
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_gradients), intent(in) :: gradients
         type(grit_contact_normal_counts), intent(inout), optional :: counts
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_size_t) function grit_contact_regression_workspace_size(most_particles_per_node, &
                                                                       components) bind(c)
         import
         integer(c_ptrdiff_t), value :: most_particles_per_node
         integer(c_int), value :: components
      end function
      integer(c_int) function c_contact_normals_by_regression(n, clouds, workspace, workspace_size, &
                                                              counts, error) &
         bind(c, name='grit_contact_normals_by_regression')
         import
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_clouds), intent(in) :: clouds
         type(c_ptr), value :: workspace
         integer(c_size_t), value :: workspace_size
         type(grit_contact_normal_counts), intent(inout), optional :: counts
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function grit_contact_surfaces_reset(surfaces, error) bind(c)
         import
         type(grit_contact_surfaces), intent(in) :: surfaces
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function c_contact_surfaces_add(surfaces, n, domains, error) &
         bind(c, name='grit_contact_surfaces_add')
         import
         type(grit_contact_surfaces), intent(in) :: surfaces
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_domains), intent(in) :: domains
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function grit_contact_surfaces_merge(into, from, error) bind(c)
         import
         type(grit_contact_surfaces), intent(in) :: into, from
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function c_contact_surfaces_finish(surfaces, n, distances, error) &
         bind(c, name='grit_contact_surfaces_finish')
         import
         type(grit_contact_surfaces), intent(in) :: surfaces
         integer(c_ptrdiff_t), value :: n
         type(grit_contact_distances), intent(in) :: distances
         type(grit_error), intent(inout), optional :: error
      end function
   end interface
end module
