# cmake -DBUILD= -DWORK= -DSOURCE= -DCC= -DPKG_CONFIG= -DC_FLAGS= -P check_install.cmake
# The installed tree, also when moved to another place, serves a host by its CMake package and by pkg-config, shared and
# static.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${text}")
  endif()
  string(STRIP "${text}" text)
  set(output "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --component vbgpd --prefix ${WORK}/first)

# Shared and static, by the CMake package and by pkg-config, against the tree of that name.
function(serves tree)
  set(build ${WORK}/build_${tree})
  run(${CMAKE_COMMAND} -S ${SOURCE}/consumer -B ${build} -DCMAKE_PREFIX_PATH=${WORK}/${tree} -DCMAKE_C_COMPILER=${CC}
    -DCMAKE_C_FLAGS=${C_FLAGS})
  run(${CMAKE_COMMAND} --build ${build})
  run(${build}/consumer)
  run(${build}/consumer_static)
  if(NOT PKG_CONFIG)
    return()
  endif()
  file(GLOB_RECURSE pc ${WORK}/${tree}/*/vbgpd.pc)
  get_filename_component(pc_dir ${pc} DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${pc_dir})
  run(${PKG_CONFIG} --variable=libdir vbgpd)
  set(libdir ${output})
  foreach(package vbgpd vbgpd-static)
    run(${PKG_CONFIG} --cflags --libs ${package})
    separate_arguments(flags UNIX_COMMAND "${output} ${C_FLAGS}")
    run(${CC} -std=c99 ${SOURCE}/consumer/main.c ${flags} -o ${build}/by_${package})
  endforeach()
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${libdir} ${build}/by_vbgpd)
  run(${build}/by_vbgpd-static)
endfunction()

serves(first)
file(RENAME ${WORK}/first ${WORK}/moved)
serves(moved)
