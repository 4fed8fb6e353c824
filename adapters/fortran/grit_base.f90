! SPDX-License-Identifier: BSD-3-Clause
! Status, error, views and version of Grit: grit/status.h, grit/view.h, grit/version.h.
module grit_base
   use, intrinsic :: iso_c_binding
   implicit none
   private
   public :: grit_error, grit_view, grit_matrix_view, grit_mutable_view, grit_mutable_matrix_view
   public :: grit_message, grit_status_name, grit_version, grit_instruction_set
   public :: grit_view_of, grit_matrix_view_of, grit_text, grit_fits, grit_within

   integer(c_int), parameter, public :: grit_ok = 0
   integer(c_int), parameter, public :: grit_bad_call = 1       ! fix the call
   integer(c_int), parameter, public :: grit_bad_parameter = 2  ! fix the material
   integer(c_int), parameter, public :: grit_bad_state = 3      ! fix the state of that point
   integer(c_int), parameter, public :: grit_not_converged = 4  ! retry with a smaller increment
   integer(c_int), parameter, public :: grit_internal = 5       ! report a bug
   integer(c_int), parameter, public :: grit_message_size = 256
   integer(c_int), parameter, public :: grit_isa_best = 0, grit_isa_baseline = 1
   integer(c_int), parameter, public :: grit_isa_avx2 = 2, grit_isa_avx512 = 3

   ! Written on failure only. point counts from 0, as the message does.
   type, bind(c) :: grit_error
      integer(c_int) :: status = 0, reserved = 0
      integer(c_ptrdiff_t) :: point = -1
      character(kind=c_char) :: message(grit_message_size) = c_null_char
   end type

   ! Number c of point i at base + i point_stride + c component_stride [doubles].
   type, bind(c) :: grit_view
      type(c_ptr) :: base = c_null_ptr
      integer(c_ptrdiff_t) :: point_stride = 0, component_stride = 0
   end type
   type, bind(c) :: grit_mutable_view
      type(c_ptr) :: base = c_null_ptr
      integer(c_ptrdiff_t) :: point_stride = 0, component_stride = 0
   end type
   type, bind(c) :: grit_matrix_view
      type(c_ptr) :: base = c_null_ptr
      integer(c_ptrdiff_t) :: point_stride = 0, row_stride = 0, column_stride = 0
   end type
   type, bind(c) :: grit_mutable_matrix_view
      type(c_ptr) :: base = c_null_ptr
      integer(c_ptrdiff_t) :: point_stride = 0, row_stride = 0, column_stride = 0
   end type

   ! Where an array lies, sections included, without a copy: (n) one number per point, (c, n) c of
   ! them, an array without elements points nowhere in particular. The array must be a TARGET for as
   ! long as the view is used.
   interface grit_view_of
      module procedure view_of_scalars, view_of_vectors
   end interface
   ! (r, c, n): matrix(row, column) of each point, (r, c): of one point.
   interface grit_matrix_view_of
      module procedure view_of_matrices, view_of_matrix
   end interface
   interface assignment(=)
      module procedure view_for_writing, matrix_view_for_writing
   end interface
   public :: assignment(=)

   interface
      integer(c_int) function grit_version() bind(c)
         import
      end function
      integer(c_int) function grit_instruction_set() bind(c)
         import
      end function
      type(c_ptr) function status_name(status) bind(c, name='grit_status_name')
         import
         integer(c_int), value :: status
      end function
   end interface

   real(c_double), target, save :: nowhere(1) = 0

contains

   ! The message of an error, without what C puts behind it.
   pure function grit_message(error) result(text)
      type(grit_error), intent(in) :: error
      character(:), allocatable :: text
      integer :: i
      text = ''
      do i = 1, grit_message_size
         if (error%message(i) == c_null_char) exit
         text = text//error%message(i)
      end do
   end function

   function grit_status_name(status) result(name)
      integer(c_int), intent(in) :: status
      character(:), allocatable :: name
      name = grit_text(status_name(status))
   end function

   ! A string of C, '' for null.
   function grit_text(address) result(text)
      type(c_ptr), intent(in) :: address
      character(:), allocatable :: text
      character(kind=c_char), pointer :: letters(:)
      integer :: i
      text = ''
      if (.not. c_associated(address)) return
      call c_f_pointer(address, letters, [huge(1)])
      i = 1
      do while (letters(i) /= c_null_char)
         text = text//letters(i)
         i = i + 1
      end do
   end function

   type(grit_view) function view_of_scalars(a) result(view)
      real(c_double), intent(in), target :: a(:)
      view%base = c_loc(nowhere)
      if (size(a) > 0) view%base = c_loc(a(1))
      if (size(a) > 1) view%point_stride = doubles(c_loc(a(1)), c_loc(a(2)))
      view%component_stride = 1
   end function

   type(grit_view) function view_of_vectors(a) result(view)
      real(c_double), intent(in), target :: a(:, :)
      view%base = c_loc(nowhere)
      view%component_stride = 1
      if (size(a) == 0) return
      view%base = c_loc(a(1, 1))
      if (size(a, 1) > 1) view%component_stride = doubles(c_loc(a(1, 1)), c_loc(a(2, 1)))
      if (size(a, 2) > 1) view%point_stride = doubles(c_loc(a(1, 1)), c_loc(a(1, 2)))
   end function

   type(grit_matrix_view) function view_of_matrices(a) result(view)
      real(c_double), intent(in), target :: a(:, :, :)
      view%base = c_loc(nowhere)
      view%row_stride = 1
      view%column_stride = size(a, 1)
      if (size(a) == 0) return
      view = view_of_matrix(a(:, :, 1))
      if (size(a, 3) > 1) view%point_stride = doubles(c_loc(a(1, 1, 1)), c_loc(a(1, 1, 2)))
   end function

   type(grit_matrix_view) function view_of_matrix(a) result(view)
      real(c_double), intent(in), target :: a(:, :)
      view%base = c_loc(nowhere)
      view%row_stride = 1
      view%column_stride = size(a, 1)
      if (size(a) == 0) return
      view%base = c_loc(a(1, 1))
      if (size(a, 1) > 1) view%row_stride = doubles(c_loc(a(1, 1)), c_loc(a(2, 1)))
      if (size(a, 2) > 1) view%column_stride = doubles(c_loc(a(1, 1)), c_loc(a(1, 2)))
   end function

   elemental subroutine view_for_writing(to, from)
      type(grit_mutable_view), intent(out) :: to
      type(grit_view), intent(in) :: from
      to%base = from%base
      to%point_stride = from%point_stride
      to%component_stride = from%component_stride
   end subroutine

   elemental subroutine matrix_view_for_writing(to, from)
      type(grit_mutable_matrix_view), intent(out) :: to
      type(grit_matrix_view), intent(in) :: from
      to%base = from%base
      to%point_stride = from%point_stride
      to%row_stride = from%row_stride
      to%column_stride = from%column_stride
   end subroutine

   ! From address p to address q.
   integer(c_ptrdiff_t) function doubles(p, q)
      type(c_ptr), intent(in) :: p, q
      doubles = (transfer(q, 0_c_ptrdiff_t) - transfer(p, 0_c_ptrdiff_t))/8
   end function

   ! Is an array of the shape that the others ask for? If not, error says so.
   logical function grit_fits(name, found, wanted, error)
      character(*), intent(in) :: name
      integer, intent(in) :: found(:), wanted(:)
      type(grit_error), intent(inout), optional :: error
      grit_fits = all(found == wanted)
      if (.not. grit_fits) call complain(error, name//' must be ('//list(wanted)//'), got ('// &
                                         list(found)//')')
   end function

   ! Are ids in 0 ... n - 1?
   logical function grit_within(name, ids, n, error)
      character(*), intent(in) :: name
      integer(c_ptrdiff_t), intent(in) :: ids(:)
      integer, intent(in) :: n
      type(grit_error), intent(inout), optional :: error
      integer :: at
      character(80) :: text
      at = findloc(ids < 0 .or. ids >= n, .true., 1)
      grit_within = at == 0
      if (grit_within) return
      write (text, '(a,i0,a,i0,a)') ' must be in [0, ', n, '), counted from 0, got ', ids(at), ''
      call complain(error, name//trim(text))
   end function

   subroutine complain(error, text)
      type(grit_error), intent(inout), optional :: error
      character(*), intent(in) :: text
      integer :: i
      if (.not. present(error)) return
      error%status = grit_bad_call
      error%point = -1
      error%message = c_null_char
      do i = 1, min(len(text), grit_message_size - 1)
         error%message(i) = text(i:i)
      end do
   end subroutine

   pure function list(numbers) result(text)
      integer, intent(in) :: numbers(:)
      character(:), allocatable :: text
      character(12) :: each
      integer :: i
      text = ''
      do i = 1, size(numbers)
         write (each, '(i0)') numbers(i)
         text = text//trim(each)
         if (i < size(numbers)) text = text//', '
      end do
   end function
end module
