! SPDX-License-Identifier: BSD-3-Clause
! The part of Grit's C interface that host_loop.f90 uses, through ISO_C_BINDING.
module grit_interface
   use, intrinsic :: iso_c_binding
   implicit none

   integer(c_int), parameter :: grit_ok = 0
   integer, parameter :: sand_state_size = 8, sand_void_ratio = 7  ! counted from 1

   type, bind(c) :: grit_error
      integer(c_int) :: status = 0, reserved = 0
      integer(c_ptrdiff_t) :: point = -1
      character(kind=c_char) :: message(256) = c_null_char
   end type

   type, bind(c) :: grit_sand_parameters
      integer(c_size_t) :: struct_size
      real(c_double) :: values(14)  ! in the order of grit/sand.h
   end type

   type, bind(c) :: grit_sand
      real(c_double) :: opaque(64)
   end type

   type, bind(c) :: grit_sand_options
      integer(c_size_t) :: struct_size
      real(c_double) :: tolerance
      integer(c_int) :: evaluation_limit, intergranular_off, tangent, instruction_set
      integer(c_int) :: stress_is_rotated, validate_only
   end type

   type, bind(c) :: grit_view
      type(c_ptr) :: base = c_null_ptr
      integer(c_ptrdiff_t) :: point_stride = 0, component_stride = 0
   end type

   type, bind(c) :: grit_matrix_view
      type(c_ptr) :: base = c_null_ptr
      integer(c_ptrdiff_t) :: point_stride = 0, row_stride = 0, column_stride = 0
   end type

   type, bind(c) :: grit_sand_points
      integer(c_size_t) :: struct_size = 0
      integer(c_int) :: components = 0, reserved = 0
      type(c_ptr) :: index = c_null_ptr
      type(grit_view) :: strain_increment, rotation_increment, stress, state
      type(grit_matrix_view) :: tangent
      type(grit_view) :: substep
   end type

   interface
      integer(c_int) function grit_sand_record_find(name) bind(c)
         import
         character(kind=c_char), intent(in) :: name(*)
      end function
      integer(c_int) function grit_sand_parameters_init(parameters, struct_size) bind(c)
         import
         type(grit_sand_parameters), intent(out) :: parameters
         integer(c_size_t), value :: struct_size
      end function
      integer(c_int) function grit_sand_record_parameters(index, stress_scale, parameters) bind(c)
         import
         integer(c_int), value :: index
         real(c_double), value :: stress_scale
         type(grit_sand_parameters), intent(inout) :: parameters
      end function
      integer(c_int) function grit_sand_prepare(parameters, sand, error) bind(c)
         import
         type(grit_sand_parameters), intent(in) :: parameters
         type(grit_sand), intent(out) :: sand
         type(grit_error), intent(inout) :: error
      end function
      integer(c_int) function grit_sand_stress_at_rest(sand, unit_weight, depth, surcharge, K0, &
                                                       axis, stress) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), value :: unit_weight, depth, surcharge, K0
         integer(c_int), value :: axis  ! counted from 0
         real(c_double), intent(out) :: stress(6)
      end function
      integer(c_int) function grit_sand_void_ratio_at_pressure(sand, e_0, p, void_ratio) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), value :: e_0, p
         real(c_double), intent(out) :: void_ratio
      end function
      integer(c_int) function grit_sand_options_init(options, struct_size) bind(c)
         import
         type(grit_sand_options), intent(out) :: options
         integer(c_size_t), value :: struct_size
      end function
      integer(c_int) function grit_sand_update(sand, options, n, points, reports, error) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         type(grit_sand_options), intent(in) :: options
         integer(c_ptrdiff_t), value :: n
         type(grit_sand_points), intent(in) :: points
         type(c_ptr), value :: reports
         type(grit_error), intent(inout) :: error
      end function
   end interface
end module
