! SPDX-License-Identifier: BSD-3-Clause
! Surface contact on the arrays of a Fortran host: shapes are checked, workspaces are its own.
module grit_surface_arrays
   use, intrinsic :: iso_c_binding
   use grit_base
   use grit_surface_interface
   implicit none
   private
   public :: grit_surface_options_init, grit_surface_of, grit_surface_correct, grit_surface_correct_pairs, &
             grit_surface_find_free

   ! status = grit_surface_correct(options, a, b [, reports, totals, error])
   interface grit_surface_correct
      procedure correct, c_surface_correct
   end interface
   ! status = grit_surface_correct_pairs(options, a, b [, totals, error]): arrays of as many pairs.
   interface grit_surface_correct_pairs
      procedure correct_pairs, c_surface_correct_pairs
   end interface
   ! status = grit_surface_find_free(position, side, tolerance, vertex, facet, vertices, facets
   !    [, owner, error]): position (2, n), side (2, 2, n) with side(:, j, p) = r_j, vertex (2, 4 n),
   !    facet (2, 4 n) and owner (4 n) from 0.
   interface grit_surface_find_free
      procedure find_free, c_surface_find_free
   end interface

contains

   integer(c_int) function grit_surface_options_init(options) result(status)
      type(grit_surface_options), intent(inout) :: options
      status = c_surface_options_init(options, c_sizeof(options))
   end function

   ! Of a body with nodes: position (c, vertices), facet (c, facets) from 0, node (k, vertices) from 0,
   ! weight (k, vertices), mass (nodes), velocity (c, nodes), previous_velocity alike, fixed (nodes); of
   ! a rigid one: position, facet, vertex_velocity (c, vertices); of surface a also spacing (facets).
   ! All are targets for as long as the surface is used. struct_size 0, which every call refuses, if the
   ! shapes do not fit.
   type(grit_surface) function grit_surface_of(position, facet, node, weight, mass, velocity, &
                                               previous_velocity, fixed, vertex_velocity, &
                                               spacing, error) &
      result(surface)
      real(c_double), intent(in), target :: position(:, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous :: facet(:, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: node(:, :)
      real(c_double), intent(in), target, contiguous, optional :: weight(:, :)
      real(c_double), intent(in), target, optional :: mass(:)
      real(c_double), intent(inout), target, optional :: velocity(:, :)
      real(c_double), intent(in), target, optional :: previous_velocity(:, :), vertex_velocity(:, :)
      integer(c_int), intent(in), target, contiguous, optional :: fixed(:)
      real(c_double), intent(in), target, contiguous, optional :: spacing(:)
      type(grit_error), intent(inout), optional :: error
      integer :: c, n
      c = size(position, 1)
      n = size(position, 2)
      surface%struct_size = 0
      if (.not. grit_fits('facet', shape(facet), [c, size(facet, 2)], error)) return
      surface%vertices = n
      surface%facets = size(facet, 2)
      surface%position = grit_view_of(position)
      if (size(facet) > 0) surface%facet = c_loc(facet)
      if (present(vertex_velocity)) then
         if (.not. grit_fits('vertex_velocity', shape(vertex_velocity), [c, n], error)) return
         surface%rigid = 1
         surface%vertex_velocity = grit_view_of(vertex_velocity)
      end if
      if (present(node) .and. present(weight)) then
         if (.not. grit_fits('node', shape(node), [size(node, 1), n], error)) return
         if (.not. grit_fits('weight', shape(weight), shape(node), error)) return
         surface%nodes_each = size(node, 1)
         if (n > 0) surface%node = c_loc(node)
         if (n > 0) surface%weight = c_loc(weight)
      end if
      if (present(mass)) then
         surface%nodes = size(mass)
         surface%mass = grit_view_of(mass)
      end if
      if (present(velocity)) then
         if (.not. grit_fits('velocity', shape(velocity), [c, int(surface%nodes)], error)) return
         surface%velocity = grit_view_of(velocity)
      end if
      if (present(previous_velocity)) then
         if (.not. grit_fits('previous_velocity', shape(previous_velocity), &
                             [c, int(surface%nodes)], error)) return
         surface%previous_velocity = grit_view_of(previous_velocity)
      end if
      if (present(fixed)) then
         if (.not. grit_fits('fixed', shape(fixed), [int(surface%nodes)], error)) return
         if (size(fixed) > 0) surface%fixed = c_loc(fixed)
      end if
      if (present(spacing)) then
         if (.not. grit_fits('spacing', shape(spacing), [size(facet, 2)], error)) return
         if (size(spacing) > 0) surface%spacing = c_loc(spacing)
      end if
      surface%struct_size = c_sizeof(surface)
   end function

   integer(c_int) function correct(options, a, b, reports, totals, error) result(status)
      type(grit_surface_options), intent(in) :: options
      type(grit_surface), intent(in) :: a, b
      type(grit_surface_report), intent(inout), target, contiguous, optional :: reports(:)
      type(grit_surface_totals), intent(inout), optional :: totals
      type(grit_error), intent(inout), optional :: error
      real(c_double), allocatable, target :: workspace(:)
      type(c_ptr) :: to
      integer(c_size_t) :: bytes
      status = grit_bad_call
      to = c_null_ptr
      if (present(reports)) then
         if (.not. grit_fits('reports', shape(reports), [int(a%facets)], error)) return
         if (size(reports) > 0) to = c_loc(reports)
      end if
      bytes = grit_surface_workspace_size(a, b)
      ! Surfaces that meet in many places ask for more.
      do
         if (allocated(workspace)) deallocate (workspace)
         allocate (workspace(bytes/8 + 1))
         status = c_surface_correct(options, a, b, c_loc(workspace), 8*size(workspace, kind=c_size_t), &
                                    bytes, to, totals, error)
         if (bytes == 0) exit
      end do
      if (present(totals)) call forget_rows(totals)
   end function

   integer(c_int) function correct_pairs(options, a, b, totals, error) result(status)
      type(grit_surface_options), intent(in), target, contiguous :: options(:)
      type(grit_surface), intent(in), target, contiguous :: a(:), b(:)
      type(grit_surface_totals), intent(inout), target, contiguous, optional :: totals(:)
      type(grit_error), intent(inout), optional :: error
      type(grit_surface_pair) :: pairs(size(a))
      real(c_double), allocatable, target :: workspace(:)
      integer(c_size_t) :: bytes
      integer :: p
      status = grit_bad_call
      if (.not. grit_fits('options', shape(options), shape(a), error)) return
      if (.not. grit_fits('b', shape(b), shape(a), error)) return
      if (present(totals)) then
         if (.not. grit_fits('totals', shape(totals), shape(a), error)) return
      end if
      do p = 1, size(a)
         pairs(p)%options = c_loc(options(p))
         pairs(p)%a = c_loc(a(p))
         pairs(p)%b = c_loc(b(p))
         if (present(totals)) pairs(p)%totals = c_loc(totals(p))
      end do
      bytes = grit_surface_pairs_workspace_size(pairs, size(a, kind=c_ptrdiff_t))
      do
         if (allocated(workspace)) deallocate (workspace)
         allocate (workspace(bytes/8 + 1))
         status = c_surface_correct_pairs(pairs, size(a, kind=c_ptrdiff_t), c_loc(workspace), &
                                          8*size(workspace, kind=c_size_t), bytes, error)
         if (bytes == 0) exit
      end do
      if (present(totals)) call forget_rows(totals)
   end function

   ! They were in the workspace of the call.
   elemental subroutine forget_rows(totals)
      type(grit_surface_totals), intent(inout) :: totals
      totals%row = c_null_ptr
      totals%term = c_null_ptr
      totals%rows = 0
   end subroutine

   integer(c_int) function find_free(position, side, tolerance, vertex, facet, vertices, facets, owner, &
                                     error) result(status)
      real(c_double), intent(in), target, contiguous :: position(:, :), side(:, :, :)
      real(c_double), intent(in) :: tolerance
      real(c_double), intent(inout), target, contiguous :: vertex(:, :)
      integer(c_ptrdiff_t), intent(inout), target, contiguous :: facet(:, :)
      integer(c_ptrdiff_t), intent(inout) :: vertices, facets
      integer(c_ptrdiff_t), intent(inout), target, contiguous, optional :: owner(:)
      type(grit_error), intent(inout), optional :: error
      type(grit_surface_domains) :: domains
      real(c_double), allocatable, target :: workspace(:)
      type(c_ptr) :: to
      integer(c_size_t) :: bytes
      integer :: n
      status = grit_bad_call
      n = size(position, 2)
      if (.not. grit_fits('position', shape(position), [2, n], error)) return
      if (.not. grit_fits('side', shape(side), [2, 2, n], error)) return
      if (.not. grit_fits('vertex', shape(vertex), [2, 4*n], error)) return
      if (.not. grit_fits('facet', shape(facet), [2, 4*n], error)) return
      to = c_null_ptr
      if (present(owner)) then
         if (.not. grit_fits('owner', shape(owner), [4*n], error)) return
         if (n > 0) to = c_loc(owner)
      end if
      domains%n = n
      domains%tolerance = tolerance
      domains%position = grit_view_of(position)
      domains%side%base = c_loc(side)
      domains%side%point_stride = 4
      domains%side%row_stride = 2
      domains%side%column_stride = 1
      bytes = grit_surface_find_free_workspace_size(int(n, c_ptrdiff_t))
      allocate (workspace(bytes/8 + 1))
      status = c_surface_find_free(domains, c_loc(workspace), bytes, c_loc(vertex), c_loc(facet), to, &
                                   vertices, facets, error)
   end function
end module
