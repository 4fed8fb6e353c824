cmake_minimum_required(VERSION 3.25)
# pip installs the package of SOURCE with PYTHON into an environment of its own under WORK; what is
# installed runs the examples: the triaxial test prints what the Fortran host prints (in BUILD, if it
# has one), and the tour draws its pictures.
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

unset(ENV{PYTHONPATH})
run(${PYTHON} -m venv --system-site-packages ${WORK}/venv)
set(python ${WORK}/venv/bin/python)
run(${python} -m pip install --quiet --no-index --disable-pip-version-check --no-build-isolation --no-deps
    ${SOURCE}/adapters/python)
run(${python} -c "print(__import__('grit').__file__)")
if(NOT output MATCHES "^${WORK}/venv/")
  message(FATAL_ERROR "pip did not install the package into the environment: ${output}")
endif()
run(${python} ${SOURCE}/examples/triaxial.py)
# As tests/abi/check_examples.cmake asks of the Fortran host.
if(NOT output MATCHES "-0\\.200  stress 11 -398\\.9[0-2][0-9]+ kPa  void ratio 0\\.61273")
  message(FATAL_ERROR "triaxial.py printed\n${output}")
endif()
if(EXISTS ${BUILD}/examples/triaxial_fortran)
  set(printed "${output}")
  run(${BUILD}/examples/triaxial_fortran)
  if(NOT output STREQUAL printed)
    message(FATAL_ERROR "Python printed\n${printed}, Fortran\n${output}")
  endif()
endif()
run(${python} ${SOURCE}/examples/sand_tour.py)
foreach(picture triaxial cycles contact)
  if(NOT EXISTS ${WORK}/sand_tour_${picture}.svg)
    message(FATAL_ERROR "sand_tour.py drew no sand_tour_${picture}.svg")
  endif()
endforeach()
