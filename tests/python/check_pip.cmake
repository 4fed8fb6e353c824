cmake_minimum_required(VERSION 3.25)
# pip makes a wheel of SOURCE and installs it with PYTHON into an environment of its own under WORK; what is
# installed runs the examples: the triaxial test prints what the Fortran host prints (in BUILD, if it
# has one), and the notebook says what it prints.
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

unset(ENV{PYTHONPATH})
# Where script/test has ccache, what the build has compiled with the same flags is taken from it.
set(ENV{CCACHE_BASEDIR} ${SOURCE}/build/python/cmake)
run(${PYTHON} -m venv --system-site-packages ${WORK}/venv)
set(python ${WORK}/venv/bin/python)
set(pip ${python} -m pip --quiet --disable-pip-version-check)
run(${pip} wheel --no-index --no-build-isolation --no-deps --wheel-dir ${WORK} ${SOURCE})
file(GLOB wheel ${WORK}/grit_sand-*.whl)
# The tag promises what the module needs of the machine: libc of a version, nothing of the C++ library.
if(NOT wheel MATCHES "/grit_sand-[0-9.]+-cp3[0-9]+-cp3[0-9]+-manylinux_2_([0-9]+)_[a-z0-9_]+\\.whl$")
  message(FATAL_ERROR "the wheel is called ${wheel}")
endif()
run(${pip} install --no-index --no-deps ${wheel})
# What else the system has does not matter here.
execute_process(COMMAND ${python} -m pip check --disable-pip-version-check OUTPUT_VARIABLE wants ERROR_VARIABLE wants)
if(wants MATCHES "grit")
  message(FATAL_ERROR "pip check: ${wants}")
endif()
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
run(${python} ${CMAKE_CURRENT_LIST_DIR}/notebook.py ${SOURCE}/examples/sand_tour.ipynb)
