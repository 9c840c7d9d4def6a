# What the folders examples/, test/, benchmark/ and demo/ of a checkout share, whether they are configured from the
# root or alone: the build type, the warnings and the library target.

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
find_package(Context_completion_3 REQUIRED CONFIG PATHS "${CMAKE_CURRENT_LIST_DIR}" NO_DEFAULT_PATH)
# Our own headers are no system headers: they must not cause warnings.
set_target_properties(Context_completion_3::Context_completion_3 PROPERTIES IMPORTED_NO_SYSTEM ON)

# An executable of this checkout: the package and its warnings.
function(context_completion_3_add_executable name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE Context_completion_3::Context_completion_3)
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra>)
endfunction()

# Deals source files out to `number` groups, in turn: the lists `group_0`, `group_1`, ... of the caller. Most of the time of
# a build goes into compiling the package, which a group that becomes one translation unit does once for all of its files.
function(context_completion_3_deal_out number)
  set(next 0)
  foreach(source IN LISTS ARGN)
    list(APPEND group_${next} "${source}")
    math(EXPR next "(${next} + 1) % ${number}")
  endforeach()
  math(EXPR last "${number} - 1")
  foreach(group RANGE ${last})
    set(group_${group} "${group_${group}}" PARENT_SCOPE)
  endforeach()
endfunction()
