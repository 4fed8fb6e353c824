! SPDX-License-Identifier: BSD-3-Clause
! A host's loop over points: a column of two sands at rest, compressed and sheared in steps.
! Points are columns, as Fortran codes keep them; Grit reads and writes them in place. host_loop.c
! does the same in C and prints the same numbers.
program host_loop
   use grit
   implicit none
   integer, parameter :: points = 1000, steps = 50
   real(c_double) :: strain_increment(6, points) = 0, stress(6, points)
   real(c_double) :: state(grit_sand_state_size, points) = 0
   integer(c_ptrdiff_t) :: points_of(points/2, 2)  ! counted from 0, as C does
   type(grit_sand) :: sands(2)
   type(grit_sand_options) :: options
   type(grit_error) :: error
   integer :: i, s, step

   sands(1) = prepared('lausitz')
   sands(2) = prepared('hochstetten')
   do i = 1, points  ! every other point is of the same sand
      s = 1 + mod(i - 1, 2)
      points_of((i + 1)/2, s) = i - 1
      call initialise(sands(s), i)
   end do

   call check(grit_sand_options_init(options), 'options')
   options%tolerance = 1d-6

   do step = 1, steps
      strain_increment(3, :) = -2d-5  ! compression along 33
      strain_increment(6, :) = 1d-4   ! shear 23, engineering
      do s = 1, 2                     ! disjoint index lists: could be two threads
         call check(grit_sand_update(sands(s), strain_increment, stress, state, &
                                     index=points_of(:, s), options=options, error=error), 'update')
      end do
   end do
   do i = 1, points, 333
      write (*, '(a,i5,a,f13.6,a,f13.6,a,f12.9)') 'point', i - 1, '  sigma_33', stress(3, i), &
         '  sigma_23', stress(6, i), ' kPa  e', state(grit_sand_void_ratio, i)
   end do

contains

   function prepared(name) result(sand)
      character(*), intent(in) :: name
      type(grit_sand) :: sand
      type(grit_sand_parameters) :: parameters
      integer(c_int) :: record
      call check(grit_sand_parameters_init(parameters), name)
      record = grit_sand_record_find(name)
      call check(grit_sand_record_parameters(record, 1d0, parameters), name)  ! kPa
      call check(grit_sand_prepare(parameters, sand, error), name)
   end function

   ! At rest under 9 kN/m3 at depths 0.1 m ... 100 m, e from e_0 = 0.75 at zero pressure.
   subroutine initialise(sand, point)
      type(grit_sand), intent(in) :: sand
      integer, intent(in) :: point
      integer, parameter :: vertical = 3
      real(c_double) :: e
      call check(grit_sand_stress_at_rest(sand, 9d0, 0.1d0*point, 0d0, -1d0, vertical, &
                                          stress(:, point)), 'stress at rest')
      call check(grit_sand_void_ratio_at_pressure(sand, 0.75d0, -sum(stress(1:3, point))/3, e), &
                 'void ratio')
      state(grit_sand_void_ratio, point) = e
   end subroutine

   subroutine check(status, what)
      integer(c_int), intent(in) :: status
      character(*), intent(in) :: what
      if (status == grit_ok) return
      write (*, '(4a)') 'failed: ', what, ': ', grit_message(error)
      error stop 1
   end subroutine
end program
