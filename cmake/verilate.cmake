# Verilates a model and writes all of its code as one unit; run by trammel_verilate() when a source
# of the model has changed:
#
#   cmake -DUNIT=model.cpp -DPREFIX=Vblock -DSOURCE=folder -P verilate.cmake -- VERILATOR ARGS...
#
# Verilator runs in the folder SOURCE with relative names, so that two clones of the repository get
# the same code and share it in the compiler's cache. Headers stay beside the unit. Output that is
# as before keeps its time stamp: a change that no port sees does not recompile the test.

set(command)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(n RANGE ${last})
  if(after)
    list(APPEND command "${CMAKE_ARGV${n}}")
  elseif(CMAKE_ARGV${n} STREQUAL "--")
    set(after TRUE)
  endif()
endforeach()

cmake_path(GET UNIT PARENT_PATH folder)
set(new ${folder}/new)
file(REMOVE_RECURSE ${new})
file(MAKE_DIRECTORY ${new})
execute_process(COMMAND ${command} --prefix ${PREFIX} --Mdir ${new} --MMD
  WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE code)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "${said}")  # warnings are left to the lint tests
endif()

file(GLOB headers RELATIVE ${new} ${new}/*.h)
set(hashes "//")
foreach(header IN LISTS headers)
  file(SHA1 ${new}/${header} hash)
  string(APPEND hashes " ${hash}")
  file(COPY_FILE ${new}/${header} ${folder}/${header} ONLY_IF_DIFFERENT)
endforeach()
foreach(extra IN LISTS KEEP)
  file(COPY_FILE ${new}/${extra} ${folder}/${extra} ONLY_IF_DIFFERENT)
endforeach()

# The hashes of all headers come first: whatever includes them via the unit needs no list of them.
file(WRITE ${new}/unit "${hashes}\n")
file(GLOB parts ${new}/*.cpp)
execute_process(COMMAND ${CMAKE_COMMAND} -E cat ${new}/unit ${parts}
  OUTPUT_FILE ${new}/whole COMMAND_ERROR_IS_FATAL ANY)
file(COPY_FILE ${new}/whole ${UNIT} ONLY_IF_DIFFERENT)

file(READ ${new}/${PREFIX}__ver.d text)
string(REGEX REPLACE "^.* : " "" text "${text}")
separate_arguments(text)
set(read)
foreach(file IN LISTS text)
  if(EXISTS ${SOURCE}/${file})
    string(APPEND read " ${SOURCE}/${file}")
  endif()
endforeach()
file(WRITE ${UNIT}.d "${UNIT}:${read}\n")
file(REMOVE_RECURSE ${new})
