# GRIT_VERSION_READ: the version, whose one place is include/grit/version.h.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../include/grit/version.h lines REGEX "^#define GRIT_VERSION_(MAJOR|MINOR|PATCH)")
set(GRIT_VERSION_READ)
foreach(line IN LISTS lines)
  string(REGEX MATCH "[0-9]+$" number "${line}")
  list(APPEND GRIT_VERSION_READ ${number})
endforeach()
list(JOIN GRIT_VERSION_READ "." GRIT_VERSION_READ)
