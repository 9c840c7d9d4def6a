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
