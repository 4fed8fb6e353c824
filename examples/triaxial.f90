! SPDX-License-Identifier: BSD-3-Clause
! A drained triaxial test of dense Lausitz sand (e 0.55, 100 kPa) to 20 % axial strain, as a Fortran
! host runs it: each increment, Newton's method finds the radial strain that keeps the radial stress.
program triaxial
   use grit
   implicit none
   integer, parameter :: increments = 400
   real(c_double), parameter :: pressure = 100d0, axial = -0.2d0/increments  ! kPa, compression < 0
   type(grit_sand_parameters) :: parameters
   type(grit_sand) :: sand
   type(grit_sand_options) :: options
   type(grit_error) :: error
   real(c_double) :: stress(6), state(grit_sand_state_size) = 0, strain(6) = 0, substep = 0
   integer :: i

   call check(grit_sand_parameters_init(parameters))
   call check(grit_sand_record_parameters(grit_sand_record_find('lausitz'), 1d0, parameters))
   call check(grit_sand_prepare(parameters, sand, error))
   call check(grit_sand_options_init(options))
   options%tolerance = 1d-5
   stress = [-pressure, -pressure, -pressure, 0d0, 0d0, 0d0]
   state(grit_sand_void_ratio) = 0.55d0
   call check(grit_sand_mobilise(sand, [-1d0, -1d0, -1d0, 0d0, 0d0, 0d0], 1d0, state))

   do i = 1, increments
      call increment()
      if (mod(i, increments/4) == 0) write (*, '(a,f7.3,a,f11.5,a,f9.6)') 'axial strain', i*axial, &
         '  stress 11', stress(1), ' kPa  void ratio', state(grit_sand_void_ratio)
   end do

contains

   ! One increment of axial strain; the radial one of the last increment is the first guess.
   subroutine increment()
      real(c_double) :: trial(6), trial_state(grit_sand_state_size), tangent(6, 6), advice, off
      integer :: k
      strain(1) = axial
      do k = 1, 25
         trial = stress
         trial_state = state
         advice = substep
         call check(grit_sand_update(sand, strain, trial, trial_state, tangent, substep=advice, &
                                     options=options, error=error))
         off = -pressure - trial(2)
         if (abs(off) <= 1d-10*norm2(trial)) exit
         strain(2:3) = strain(2:3) + off/(tangent(2, 2) + tangent(2, 3))
      end do
      if (k > 25) error stop 'the radial stress was not found'
      stress = trial
      state = trial_state
      substep = advice
   end subroutine

   subroutine check(status)
      integer(c_int), intent(in) :: status
      if (status == grit_ok) return
      write (*, '(a)') grit_message(error)
      error stop 1
   end subroutine
end program
