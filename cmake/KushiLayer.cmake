# Every folder of src/ is one static library that names the layers below it; what it does not name
# it cannot link. All of them together are the library kushi::kushi.

add_library(kushi_options INTERFACE)
target_compile_features(kushi_options INTERFACE cxx_std_20)
target_compile_options(
  kushi_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wold-style-cast
                          -Wnon-virtual-dtor)
if(PROJECT_IS_TOP_LEVEL)
  target_compile_options(kushi_options INTERFACE -Werror)
endif()
# The same bytes on every x86-64: no fused multiply-add behind our back.
target_compile_options(kushi_options INTERFACE -ffp-contract=off)
# Square roots as one instruction; nothing here reads errno after them.
target_compile_options(kushi_options INTERFACE -fno-math-errno)
if(KUSHI_SANITIZE)
  target_compile_options(kushi_options INTERFACE -fsanitize=${KUSHI_SANITIZE}
                                                 -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(kushi_options INTERFACE -fsanitize=${KUSHI_SANITIZE})
  # GCC's own manual: sanitizers make it see uninitialized values where there are none.
  target_compile_options(kushi_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

add_library(kushi INTERFACE)
add_library(kushi::kushi ALIAS kushi)

# kushi_layer(NAME SOURCES a.cpp ... BELOW other layers ... LIBRARIES packaged libraries ...)
function(kushi_layer name)
  cmake_parse_arguments(arg "" "" "SOURCES;BELOW;LIBRARIES" ${ARGN})
  add_library(kushi_${name} STATIC ${arg_SOURCES})
  target_include_directories(kushi_${name} PUBLIC ${PROJECT_SOURCE_DIR}/include
                             PRIVATE ${PROJECT_SOURCE_DIR}/src)
  list(TRANSFORM arg_BELOW PREPEND kushi_)
  target_link_libraries(kushi_${name} PUBLIC ${arg_BELOW} PRIVATE kushi_options ${arg_LIBRARIES})
  target_link_libraries(kushi INTERFACE kushi_${name})
endfunction()

# kushi_lanes(a.cpp ...): sources of a layer that Highway compiles once for each instruction set. Under
# sanitizers they would take minutes each.
function(kushi_lanes)
  if(KUSHI_SANITIZE)
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_DEFINITIONS KUSHI_FEW_TARGETS)
    # Watching the scopes of their many temporaries takes 13 minutes more.
    set_property(SOURCE ${ARGN} APPEND PROPERTY COMPILE_OPTIONS -O1 -fno-sanitize=undefined
                                                                -fno-sanitize-address-use-after-scope)
  endif()
endfunction()

# kushi_test(LAYER a_test.cpp ...): one test program per layer, linked with that layer alone. They share
# GoogleTest's headers, compiled once.
function(kushi_test layer)
  add_executable(${layer}_tests ${ARGN})
  target_include_directories(${layer}_tests PRIVATE ${PROJECT_SOURCE_DIR}/src
                                                    ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${layer}_tests PRIVATE KUSHI_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${layer}_tests PRIVATE kushi_${layer} kushi_options GTest::gmock
                                               GTest::gtest_main)
  target_precompile_headers(${layer}_tests REUSE_FROM test_headers)
  gtest_discover_tests(${layer}_tests TEST_PREFIX ${layer}. DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT 900)
endfunction()
