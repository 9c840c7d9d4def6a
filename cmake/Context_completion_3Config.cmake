# Makes the target Context_completion_3::Context_completion_3: the headers, with CGAL, Eigen and, where it is found, TBB.
# The same file serves a checkout (cmake/ beside include/) and an installed package (share/cmake/Context_completion_3/).

if(TARGET Context_completion_3::Context_completion_3)
  return()
endif()

include(CMakeFindDependencyMacro)
find_dependency(CGAL)
find_dependency(Eigen3 NO_MODULE)
if(NOT EIGEN3_FOUND)
  # CGAL's support file asks for the variables of the older find module.
  get_target_property(EIGEN3_INCLUDE_DIR Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  set(EIGEN3_FOUND TRUE)
endif()
include(CGAL_Eigen3_support)

option(CONTEXT_COMPLETION_3_WITH_TBB "Run in parallel, with TBB" ON)
if(CONTEXT_COMPLETION_3_WITH_TBB)
  find_package(TBB QUIET)
  include(CGAL_TBB_support)
endif()

get_filename_component(context_completion_3_include_dir "${CMAKE_CURRENT_LIST_DIR}/../include" ABSOLUTE)
if(NOT EXISTS "${context_completion_3_include_dir}/CGAL/context_complete.h")
  get_filename_component(context_completion_3_include_dir "${CMAKE_CURRENT_LIST_DIR}/../../../include" ABSOLUTE)
endif()

add_library(Context_completion_3::Context_completion_3 INTERFACE IMPORTED)
set_target_properties(Context_completion_3::Context_completion_3 PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${context_completion_3_include_dir}"
  INTERFACE_COMPILE_FEATURES cxx_std_17)
target_link_libraries(Context_completion_3::Context_completion_3 INTERFACE CGAL::CGAL CGAL::Eigen3_support)
if(CONTEXT_COMPLETION_3_WITH_TBB AND TARGET CGAL::TBB_support)
  target_link_libraries(Context_completion_3::Context_completion_3 INTERFACE CGAL::TBB_support)
endif()
unset(context_completion_3_include_dir)
