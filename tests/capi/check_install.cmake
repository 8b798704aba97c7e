# cmake -DBUILD= -DWORK= -DSOURCE= -DCC= -DPKG_CONFIG= -DC_FLAGS= -P check_install.cmake
# The installed tree, moved to another place, serves a host by its CMake package and by pkg-config.
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
file(RENAME ${WORK}/first ${WORK}/moved)

run(${CMAKE_COMMAND} -S ${SOURCE}/consumer -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/moved -DCMAKE_C_COMPILER=${CC}
  -DCMAKE_C_FLAGS=${C_FLAGS})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)

if(PKG_CONFIG)
  file(GLOB_RECURSE pc ${WORK}/moved/*.pc)
  get_filename_component(pc_dir ${pc} DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${pc_dir})
  run(${PKG_CONFIG} --cflags --libs vbgpd)
  separate_arguments(flags UNIX_COMMAND "${output} ${C_FLAGS}")
  run(${CC} -std=c99 ${SOURCE}/consumer/main.c ${flags} -o ${WORK}/by_pkg_config)
  run(${PKG_CONFIG} --variable=libdir vbgpd)
  run(${CMAKE_COMMAND} -E env LD_LIBRARY_PATH=${output} ${WORK}/by_pkg_config)
endif()
