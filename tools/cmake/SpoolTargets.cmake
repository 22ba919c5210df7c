# How our own targets are compiled: warnings, sanitizers, include root. Third party is SYSTEM.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(spool_flags INTERFACE)
target_include_directories(spool_flags INTERFACE ${CMAKE_SOURCE_DIR})
# Options and frames are written with designated initialisers that name only what differs from the default.
target_compile_options(spool_flags INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
  -Wno-missing-field-initializers>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 at -O3 sees overlapping copies in every "text" + std::string (GCC bug 105651).
  # There it also takes every Eigen member of a temporary for uninitialised; the other presets still look.
  target_compile_options(spool_flags INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict $<$<CONFIG:Release>:-Wno-maybe-uninitialized>>)
endif()
if(SPOOL_WERROR)
  target_compile_options(spool_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(SPOOL_SERIAL)
  target_compile_definitions(spool_flags INTERFACE SPOOL_SERIAL=1)
endif()
if(SPOOL_SANITIZE)
  add_compile_options(-fsanitize=${SPOOL_SANITIZE} -fno-omit-frame-pointer)
  # GCC 12's instrumentation makes it warn of libstdc++'s own std::function (GCC bug 105562).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-maybe-uninitialized)
  endif()
  add_link_options(-fsanitize=${SPOOL_SANITIZE})
  if(SPOOL_SANITIZE MATCHES "undefined")
    add_compile_options(-fno-sanitize-recover=all)
  endif()
endif()

# spool_library(NAME sources... ): a static library of ours. Dependencies follow by target_link_libraries.
function(spool_library name)
  add_library(${name} STATIC ${ARGN})
  target_link_libraries(${name} PUBLIC spool_flags)
endfunction()

# spool_program(NAME sources...): an executable of ours, in build/<preset>/bin. It takes OpenNI2, where it
# needs it, from the folder beside bin that holds our driver set (app/sensor/CMakeLists.txt).
function(spool_program name)
  add_executable(${name} ${ARGN})
  set_target_properties(${name} PROPERTIES BUILD_RPATH "$ORIGIN/../openni2" INSTALL_RPATH "$ORIGIN/../openni2")
  target_link_libraries(${name} PRIVATE spool_flags)
endfunction()
