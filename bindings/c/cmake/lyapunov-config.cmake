# Package `lyapunov`: find_package(lyapunov REQUIRED), then target_link_libraries(program lyapunov::lyapunov).
get_filename_component(_lyapunov_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT EXISTS "${_lyapunov_prefix}/lib/liblyapunov_c.a")
    set(lyapunov_FOUND FALSE)
    set(lyapunov_NOT_FOUND_MESSAGE "${_lyapunov_prefix}/lib/liblyapunov_c.a is missing: install the library beside this file")
    return()
endif()
if(NOT TARGET lyapunov::lyapunov)
    add_library(lyapunov::lyapunov STATIC IMPORTED)
    set_target_properties(lyapunov::lyapunov PROPERTIES
        IMPORTED_LOCATION "${_lyapunov_prefix}/lib/liblyapunov_c.a"
        INTERFACE_INCLUDE_DIRECTORIES "${_lyapunov_prefix}/include")
endif()
unset(_lyapunov_prefix)
