! SPDX-License-Identifier: BSD-3-Clause
! Grit for Fortran: everything in include/grit, on arrays.
!
!   type(grit_sand) :: sand                 ! once, from parameters; shareable between threads
!   status = grit_sand_update(sand, strain_increment, stress, state)    ! (6, n), (6, n), (8, n)
!
! Functions and derived types have the names they have in C; what they do, in which units and signs,
! is said in include/grit. Every function returns a status, grit_ok or why not, and takes an optional
! error whose text grit_message(error) gives. A shape that does not fit is GRIT_BAD_CALL and changes
! nothing. Derived types come with struct_size set and all views off. Ids and error%point count from
! 0, as in the messages; places in a state or a history count from 1.
module grit
   use grit_base
   use grit_sand_interface
   use grit_sand_arrays
   use grit_contact_interface
   use grit_contact_arrays
   use grit_geometry_interface
   use grit_geometry_arrays
   use grit_penalty_interface
   use grit_penalty_arrays
   use grit_surface_interface
   use grit_surface_arrays
   implicit none
   public
end module
