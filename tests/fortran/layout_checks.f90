! SPDX-License-Identifier: BSD-3-Clause
! What the program layout, which is generated from tests/abi, asks.
module layout_checks
   use, intrinsic :: iso_c_binding
   implicit none
   integer, private :: checked = 0, wrong = 0
contains
   subroutine same(what, found, expected)
      character(*), intent(in) :: what
      integer, intent(in) :: found, expected
      checked = checked + 1
      if (found == expected) return
      wrong = wrong + 1
      write (*, '(2a,i0,a,i0)') what, ' is ', found, ', in C ', expected
   end subroutine
   subroutine place(what, member, whole, expected)
      character(*), intent(in) :: what
      type(c_ptr), intent(in) :: member, whole
      integer, intent(in) :: expected
      call same('place of '//what, &
                int(transfer(member, 0_c_intptr_t) - transfer(whole, 0_c_intptr_t)), expected)
   end subroutine
   ! At least so many checks must have been made: a generator that finds nothing is no test.
   subroutine finish(least)
      integer, intent(in) :: least
      write (*, '(i0,a,i0,a)') checked, ' checks, ', wrong, ' differences'
      if (wrong > 0 .or. checked < least) error stop 1
   end subroutine
end module
