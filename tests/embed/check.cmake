# SPDX-License-Identifier: Apache-2.0
# Installs CDSM_BUILD into a folder of its own; builds the project beside this file and the examples against it, in ways
# that an embedder has, and runs them.
set(work ${CDSM_BUILD}/embed)
set(root ${CMAKE_CURRENT_LIST_DIR}/../..)
file(REMOVE_RECURSE ${work})

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  message("${said}")
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

function(build SOURCE NAME)
  run(${CMAKE_COMMAND} -S ${SOURCE} -B ${work}/${NAME} -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${work}/prefix
      -DCMAKE_BUILD_TYPE=Release)
  run(${CMAKE_COMMAND} --build ${work}/${NAME})
endfunction()

run(${CMAKE_COMMAND} --install ${CDSM_BUILD} --prefix ${work}/prefix)
build(${CMAKE_CURRENT_LIST_DIR} build)
run(${work}/build/embed)
run(${work}/prefix/bin/cdsm devices)
build(${root}/examples examples)
run(${work}/examples/ten_minutes)
run(${work}/examples/ray_caster ${work}/ray_caster.ppm)

file(GLOB_RECURSE vtk ${work}/prefix/cdsmVtkTargets.cmake)
if(vtk)
  build(${root}/examples/vtk examples_vtk)
  run(${work}/examples_vtk/wavelet)
endif()

find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE pc ${work}/prefix/cdsm.pc)
  get_filename_component(folder ${pc} DIRECTORY)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} ${PKG_CONFIG} --cflags --libs cdsm
                  OUTPUT_VARIABLE flags OUTPUT_STRIP_TRAILING_WHITESPACE)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(c++ -std=c++17 ${CMAKE_CURRENT_LIST_DIR}/main.cpp -o ${work}/with_pkg_config ${flags} -Wl,-rpath,${folder}/..)
  run(${work}/with_pkg_config)
endif()
