# cmake -DSOURCE=FOLDER -DINPUT=FILE.in -DOUTPUT=FILE -P GritCommit.cmake: FILE with @GRIT_COMMIT@, written where it changes:
# twelve digits of the commit, "+" where tracked files differ from it; of an archive what git wrote into commit.txt.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/commit.txt GRIT_COMMIT REGEX "^[0-9a-f]+$")
if(NOT GRIT_COMMIT)
  find_package(Git QUIET)
  # A tree that lies in somebody else's repository has no commit of its own.
  if(GIT_FOUND AND EXISTS ${SOURCE}/.git)
    execute_process(
      COMMAND ${GIT_EXECUTABLE} describe --always --abbrev=12 --dirty=+ --exclude=*
      WORKING_DIRECTORY ${SOURCE}
      OUTPUT_VARIABLE GRIT_COMMIT
      ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  endif()
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
