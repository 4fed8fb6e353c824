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
   type(grit_sand) function lausitz() result(prepared)
      type(grit_sand_parameters) :: parameters
      call holds('parameters', grit_sand_parameters_init(parameters) == grit_ok)
      call holds('record', grit_sand_record_parameters(grit_sand_record_find('lausitz'), 1d0, &
                                                      parameters) == grit_ok)
      call holds('prepare', grit_sand_prepare(parameters, prepared) == grit_ok)
   end function
   subroutine finish()
      if (wrong > 0) error stop 1
   end subroutine
end module
