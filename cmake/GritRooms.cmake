# Layers: a target sees the rooms that it names, and through what it links those that its libraries show. Each room
# stands behind a link in a folder of its own, which alone is on the include path: a file may include
# "umat/model/tensor.hpp" only where the target sees umat. docs/architecture.md says who sees what.
function(grit_sees target scope)
  foreach(room IN LISTS ARGN)
    string(REPLACE "/" "_" name ${room})
    set(root ${PROJECT_BINARY_DIR}/rooms/${name})
    if(NOT EXISTS ${root}/${room})
      cmake_path(GET room PARENT_PATH above)
      file(MAKE_DIRECTORY ${root}/${above})
      file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${room} ${root}/${room} SYMBOLIC)
    endif()
    target_include_directories(${target} ${scope} ${root})
  endforeach()
endfunction()
