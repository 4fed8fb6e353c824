! SPDX-License-Identifier: BSD-3-Clause
module expect
   use grit
   implicit none
   integer, private :: wrong = 0
contains
   subroutine holds(what, condition)
      character(*), intent(in) :: what
      logical, intent(in) :: condition
      if (condition) return
      wrong = wrong + 1
      write (*, '(2a)') 'does not hold: ', what
   end subroutine
   ! The call was refused, and its message contains these words.
   subroutine refused(status, error, words)
      integer(c_int), intent(in) :: status
      type(grit_error), intent(inout) :: error
      character(*), intent(in) :: words
      call holds(words//': refused', status == grit_bad_call .and. error%status == status)
      call holds(words//', not: '//grit_message(error), index(grit_message(error), words) > 0)
      error = grit_error()
   end subroutine
   subroutine finish()
      if (wrong > 0) error stop 1
   end subroutine
end module
