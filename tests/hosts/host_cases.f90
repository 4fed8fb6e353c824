! SPDX-License-Identifier: BSD-3-Clause
! The cases of reference.cpp as a Fortran host runs them, over arrays of points: three alike, the
! middle one is looked at. Prints what reference prints.
program host_cases
   use grit
   implicit none
   integer, parameter :: points = 3, free = 1, fixed = 2, isochoric = 3
   type(grit_sand_parameters) :: parameters
   type(grit_sand) :: sand
   type(grit_error) :: error
   real(c_double) :: stress(6, points), state(grit_sand_state_size, points), substep(points)
   integer :: turn

   call check(grit_sand_parameters_init(parameters))
   call check(grit_sand_record_parameters(grit_sand_record_find('lausitz'), 1d0, parameters))
   call check(grit_sand_prepare(parameters, sand, error))
   call begin(10d0, 0.7d0)
   call stage(fixed, -0.02d0, 200)
   call stage(fixed, 0.002d0, 200)
   call stage(fixed, -0.01d0, 200)
   call finish('oedometer', 0d0)
   call begin(100d0, 0.55d0)
   call stage(free, -0.2d0, 400)
   call finish('drained', 0d0)
   call begin(100d0, 0.7d0)
   call stage(isochoric, -0.1d0, 400)
   call finish('undrained', stress(2, 2) + 100)  ! total radial stress -100 kPa
   call begin(100d0, 0.6d0)
   call stage(free, -1d-3, 200)
   do turn = 1, 5
      call stage(free, merge(2d-3, -2d-3, mod(turn, 2) == 1), 200)
   end do
   call finish('cyclic', 0d0)

contains

   subroutine begin(pressure, void_ratio)
      real(c_double), intent(in) :: pressure, void_ratio
      integer :: i
      stress = spread([-pressure, -pressure, -pressure, 0d0, 0d0, 0d0], 2, points)
      state = 0
      state(grit_sand_void_ratio, :) = void_ratio
      substep = 0
      do i = 1, points
         call check(grit_sand_mobilise(sand, [-1d0, -1d0, -1d0, 0d0, 0d0, 0d0], 1d0, state(:, i)))
      end do
   end subroutine

   subroutine stage(radial, change, increments)
      integer, intent(in) :: radial, increments
      real(c_double), intent(in) :: change
      real(c_double) :: trial(6, points), trial_state(grit_sand_state_size, points), advice(points)
      real(c_double) :: strain(6, points), tangent(6, 6, points), radial_stress, off(points)
      integer :: i, k
      radial_stress = stress(2, 2)
      strain = 0
      strain(1, :) = change/increments
      if (radial == isochoric) strain(2:3, :) = -strain(1, 1)/2
      do i = 1, increments
         do k = 1, 25
            trial = stress
            trial_state = state
            advice = substep
            call check(grit_sand_update(sand, strain, trial, trial_state, tangent, substep=advice, &
                                        error=error))
            off = radial_stress - trial(2, :)
            if (radial /= free .or. maxval(abs(off)) <= 1d-10*norm2(trial(:, 2))) exit
            strain(2, :) = strain(2, :) + off/(tangent(2, 2, :) + tangent(2, 3, :))
            strain(3, :) = strain(2, :)
         end do
         if (k > 25) error stop 'the radial stress was not found'
         stress = trial
         state = trial_state
         substep = advice
      end do
   end subroutine

   subroutine finish(name, pore_pressure)
      character(*), intent(in) :: name
      real(c_double), intent(in) :: pore_pressure
      write (*, '(a10,4(1x,es23.16))') name, stress(1, 2), stress(2, 2), &
         state(grit_sand_void_ratio, 2), pore_pressure
   end subroutine

   subroutine check(status)
      integer(c_int), intent(in) :: status
      if (status == grit_ok) return
      write (*, '(a)') grit_message(error)
      error stop 1
   end subroutine
end program
