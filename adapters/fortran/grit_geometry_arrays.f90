! SPDX-License-Identifier: BSD-3-Clause
! Normals and distances on the arrays of a Fortran host: shapes are checked, nothing is copied. Ids
! (of nodes, particles, bodies) count from 0 everywhere.
module grit_geometry_arrays
   use, intrinsic :: iso_c_binding
   use grit_base
   use grit_geometry_interface
   implicit none
   private
   public :: grit_contact_normals_from_gradients, grit_contact_normals_by_regression
   public :: grit_contact_surfaces_of, grit_contact_surfaces_add, grit_contact_surfaces_finish

   ! status = grit_contact_normals_from_gradients(source, normal [, gradient_a, gradient_b, given,
   !    scale, fixed, threshold, index, status_of, counts, error]); vectors (c, n), the others (n).
   interface grit_contact_normals_from_gradients
      procedure from_gradients, c_contact_normals_from_gradients
   end interface
   ! status = grit_contact_normals_by_regression(position, body, offset, length, normal [, particle,
   !    weight, ridge, iteration_limit, fixed, status_of, counts, error]): position (c, particles),
   !    body, weight (particles), offset (n + 1), normal (c, n).
   interface grit_contact_normals_by_regression
      procedure by_regression, c_contact_normals_by_regression
   end interface
   ! status = grit_contact_surfaces_add(surfaces, body, position, node [, side, error]): position
   !    (c, n), node (corners, n), side (c, sides) of all particles or (c, sides, n).
   interface grit_contact_surfaces_add
      procedure add_points, add_same_domains, add_domains, c_contact_surfaces_add
   end interface
   ! status = grit_contact_surfaces_finish(surfaces [, distance, gap, stiffer, measure, error]):
   !    distance, gap (nodes).
   interface grit_contact_surfaces_finish
      procedure finish, c_contact_surfaces_finish
   end interface

contains

   integer(c_int) function from_gradients(source, normal, gradient_a, gradient_b, given, scale, &
                                          fixed, threshold, index, status_of, counts, error) &
      result(status)
      integer(c_int), intent(in) :: source
      real(c_double), intent(inout), target :: normal(:, :)
      real(c_double), intent(in), target, optional :: gradient_a(:, :), gradient_b(:, :), given(:, :)
      real(c_double), intent(in), target, optional :: scale(:)
      integer(c_int), intent(in), target, contiguous, optional :: fixed(:)
      real(c_double), intent(in), optional :: threshold
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: index(:)
      integer(c_int), intent(inout), target, contiguous, optional :: status_of(:)
      type(grit_contact_normal_counts), intent(inout), optional :: counts
      type(grit_error), intent(inout), optional :: error
      type(grit_contact_gradients) :: views
      integer :: n, taken

      status = grit_bad_call
      n = size(normal, 2)
      taken = n
      views%components = size(normal, 1)
      views%source = source
      views%normal = grit_view_of(normal)
      if (present(gradient_a)) then
         if (.not. grit_fits('gradient_a', shape(gradient_a), shape(normal), error)) return
         views%gradient_a = grit_view_of(gradient_a)
      end if
      if (present(gradient_b)) then
         if (.not. grit_fits('gradient_b', shape(gradient_b), shape(normal), error)) return
         views%gradient_b = grit_view_of(gradient_b)
      end if
      if (present(given)) then
         if (.not. grit_fits('given', shape(given), shape(normal), error)) return
         views%given = grit_view_of(given)
      end if
      if (present(scale)) then
         if (.not. grit_fits('scale', shape(scale), [n], error)) return
         views%scale = grit_view_of(scale)
      end if
      if (present(fixed)) then
         if (.not. grit_fits('fixed', shape(fixed), [n], error)) return
         if (n > 0) views%fixed = c_loc(fixed)
      end if
      if (present(threshold)) views%threshold = threshold
      if (present(index)) then
         if (.not. grit_within('index', index, n, error)) return
         taken = size(index)
         if (taken > 0) views%index = c_loc(index)
      end if
      if (present(status_of)) then
         if (.not. grit_fits('status_of', shape(status_of), [taken], error)) return
         if (taken > 0) views%status = c_loc(status_of)
      end if
      status = c_contact_normals_from_gradients(int(taken, c_ptrdiff_t), views, counts, error)
   end function

   integer(c_int) function by_regression(position, body, offset, length, normal, particle, weight, &
                                         ridge, iteration_limit, fixed, status_of, counts, error) &
      result(status)
      real(c_double), intent(in), target :: position(:, :)
      integer(c_int), intent(in), target, contiguous :: body(:)
      integer(c_ptrdiff_t), intent(in), target, contiguous :: offset(:)
      real(c_double), intent(in) :: length
      real(c_double), intent(inout), target :: normal(:, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous, optional :: particle(:)
      real(c_double), intent(in), target, optional :: weight(:)
      real(c_double), intent(in), optional :: ridge
      integer, intent(in), optional :: iteration_limit
      integer(c_int), intent(in), target, contiguous, optional :: fixed(:)
      integer(c_int), intent(inout), target, contiguous, optional :: status_of(:)
      type(grit_contact_normal_counts), intent(inout), optional :: counts
      type(grit_error), intent(inout), optional :: error
      type(grit_contact_clouds) :: clouds
      real(c_double), allocatable, target :: workspace(:)
      integer(c_size_t) :: bytes
      integer(c_ptrdiff_t) :: last, most
      integer :: c, n, particles

      status = grit_bad_call
      c = size(normal, 1)
      n = size(normal, 2)
      particles = size(position, 2)
      if (.not. grit_fits('position', shape(position), [c, particles], error)) return
      if (.not. grit_fits('body', shape(body), [particles], error)) return
      if (.not. grit_fits('offset', shape(offset), [n + 1], error)) return
      clouds%components = c
      clouds%particles = particles
      clouds%position = grit_view_of(position)
      clouds%normal = grit_view_of(normal)
      clouds%offset = c_loc(offset)
      clouds%length = length
      if (particles > 0) clouds%body = c_loc(body)
      last = particles
      if (present(particle)) then
         last = size(particle)
         if (last > 0) clouds%particle = c_loc(particle)
      end if
      ! What C cannot know: the lists end.
      if (.not. grit_within('offset', offset, int(last + 1), error)) return
      if (present(weight)) then
         if (.not. grit_fits('weight', shape(weight), [particles], error)) return
         clouds%weight = grit_view_of(weight)
      end if
      if (present(ridge)) clouds%ridge = ridge
      if (present(iteration_limit)) clouds%iteration_limit = iteration_limit
      if (present(fixed)) then
         if (.not. grit_fits('fixed', shape(fixed), [n], error)) return
         if (n > 0) clouds%fixed = c_loc(fixed)
      end if
      if (present(status_of)) then
         if (.not. grit_fits('status_of', shape(status_of), [n], error)) return
         if (n > 0) clouds%status = c_loc(status_of)
      end if
      most = 1
      if (n > 0) most = max(1_c_ptrdiff_t, maxval(offset(2:) - offset(:n)))
      bytes = grit_contact_regression_workspace_size(most, int(c, c_int))
      allocate (workspace(bytes/8 + 1))
      status = c_contact_normals_by_regression(int(n, c_ptrdiff_t), clouds, c_loc(workspace), bytes, &
                                               counts, error)
   end function

   ! Views of position, normal (c, nodes), surface, centre (2, nodes), which are targets for as long as
   ! the surfaces are used. struct_size 0, which every call refuses, if the shapes do not fit.
   type(grit_contact_surfaces) function grit_contact_surfaces_of(position, normal, surface, centre, &
                                                                 error) result(surfaces)
      real(c_double), intent(in), target :: position(:, :), normal(:, :)
      real(c_double), intent(inout), target :: surface(:, :)
      real(c_double), intent(inout), target, optional :: centre(:, :)
      type(grit_error), intent(inout), optional :: error
      integer :: n
      n = size(position, 2)
      surfaces%struct_size = 0
      if (.not. grit_fits('normal', shape(normal), shape(position), error)) return
      if (.not. grit_fits('surface', shape(surface), [2, n], error)) return
      if (present(centre)) then
         if (.not. grit_fits('centre', shape(centre), [2, n], error)) return
         surfaces%centre = grit_view_of(centre)
      end if
      surfaces%struct_size = c_sizeof(surfaces)
      surfaces%components = size(position, 1)
      surfaces%nodes = n
      surfaces%position = grit_view_of(position)
      surfaces%normal = grit_view_of(normal)
      surfaces%surface = grit_view_of(surface)
   end function

   integer(c_int) function add_points(surfaces, body, position, node, error) result(status)
      type(grit_contact_surfaces), intent(in) :: surfaces
      integer(c_int), intent(in) :: body
      real(c_double), intent(in), target :: position(:, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous :: node(:, :)
      type(grit_error), intent(inout), optional :: error
      type(grit_matrix_view) :: none
      status = add(surfaces, body, position, node, none, 0, error)
   end function

   integer(c_int) function add_same_domains(surfaces, body, position, node, side, error) &
      result(status)
      type(grit_contact_surfaces), intent(in) :: surfaces
      integer(c_int), intent(in) :: body
      real(c_double), intent(in), target :: position(:, :), side(:, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous :: node(:, :)
      type(grit_error), intent(inout), optional :: error
      integer :: sides
      status = grit_bad_call
      sides = size(side, 2)
      if (.not. grit_fits('side', shape(side), [size(position, 1), sides], error)) return
      status = add(surfaces, body, position, node, by_side(grit_matrix_view_of(side)), sides, error)
   end function

   integer(c_int) function add_domains(surfaces, body, position, node, side, error) result(status)
      type(grit_contact_surfaces), intent(in) :: surfaces
      integer(c_int), intent(in) :: body
      real(c_double), intent(in), target :: position(:, :), side(:, :, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous :: node(:, :)
      type(grit_error), intent(inout), optional :: error
      integer :: sides
      status = grit_bad_call
      sides = size(side, 2)
      if (.not. grit_fits('side', shape(side), [size(position, 1), sides, size(position, 2)], error)) &
         return
      status = add(surfaces, body, position, node, by_side(grit_matrix_view_of(side)), sides, error)
   end function

   integer(c_int) function add(surfaces, body, position, node, side, sides, error) result(status)
      type(grit_contact_surfaces), intent(in) :: surfaces
      integer(c_int), intent(in) :: body
      real(c_double), intent(in), target :: position(:, :)
      integer(c_ptrdiff_t), intent(in), target, contiguous :: node(:, :)
      type(grit_matrix_view), intent(in) :: side
      integer, intent(in) :: sides
      type(grit_error), intent(inout), optional :: error
      type(grit_contact_domains) :: domains
      integer :: n
      status = grit_bad_call
      n = size(position, 2)
      if (.not. grit_fits('position', shape(position), [surfaces%components, n], error)) return
      if (.not. grit_fits('node', shape(node), [size(node, 1), n], error)) return
      domains%body = body
      domains%sides = sides
      domains%nodes_each = size(node, 1)
      if (size(node) > 0) domains%node = c_loc(node)
      domains%position = grit_view_of(position)
      domains%side = side
      status = c_contact_surfaces_add(surfaces, int(n, c_ptrdiff_t), domains, error)
   end function

   ! Fortran's columns are C's rows.
   type(grit_matrix_view) function by_side(columns) result(rows)
      type(grit_matrix_view), intent(in) :: columns
      rows = grit_matrix_view(columns%base, columns%point_stride, columns%column_stride, &
                              columns%row_stride)
   end function

   integer(c_int) function finish(surfaces, distance, gap, stiffer, measure, error) result(status)
      type(grit_contact_surfaces), intent(in) :: surfaces
      real(c_double), intent(inout), target, optional :: distance(:), gap(:)
      integer(c_int), intent(in), optional :: stiffer, measure
      type(grit_error), intent(inout), optional :: error
      type(grit_contact_distances) :: wanted
      status = grit_bad_call
      if (present(distance)) then
         if (.not. grit_fits('distance', shape(distance), [int(surfaces%nodes)], error)) return
         wanted%distance = grit_view_of(distance)
      end if
      if (present(gap)) then
         if (.not. grit_fits('gap', shape(gap), [int(surfaces%nodes)], error)) return
         wanted%gap = grit_view_of(gap)
      end if
      if (present(stiffer)) wanted%stiffer = stiffer
      if (present(measure)) wanted%measure = measure
      status = c_contact_surfaces_finish(surfaces, surfaces%nodes, wanted, error)
   end function
end module
