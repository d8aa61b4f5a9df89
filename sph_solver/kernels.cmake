# Makes the kernels of cuda and adds them and what starts them to `sources`; sets TWINWAKE_HAS_CUDA.
find_program(TWINWAKE_CLANG NAMES clang++ clang++-19 clang++-18 clang++-17 clang++-16 clang++-15 clang++-14)
set(ptx_flags -x cuda -std=c++20 -O3 -nocudainc -nocudalib --cuda-gpu-arch=sm_80 --cuda-device-only -Xclang
              -target-feature -Xclang +ptx70 -Wno-unknown-cuda-version -fno-math-errno -fno-exceptions
              -mllvm -inline-threshold=100000 -S)
set(TWINWAKE_HAS_CUDA OFF)
if(TWINWAKE_CLANG)
  set(trial ${CMAKE_CURRENT_BINARY_DIR}/ptx_trial)
  file(WRITE ${trial}.cpp "extern \"C\" __attribute__((global)) void k(float* x) { *x = __builtin_sqrtf(*x); }\n")
  execute_process(COMMAND ${TWINWAKE_CLANG} ${ptx_flags} ${trial}.cpp -o ${trial}.ptx RESULT_VARIABLE failed
                  OUTPUT_QUIET ERROR_QUIET)
  if(NOT failed)
    set(TWINWAKE_HAS_CUDA ON)
  endif()
endif()
if(NOT TWINWAKE_HAS_CUDA)
  message(STATUS "GPU: no Clang that makes PTX was found (package clang); built without")
  return()
endif()

set(kernels ${CMAKE_CURRENT_SOURCE_DIR}/cuda/kernels.cpp)
foreach(kind kernels strict_kernels)
  set(ptx ${CMAKE_CURRENT_BINARY_DIR}/${kind}.ptx)
  set(flags)
  if(kind STREQUAL "strict_kernels")
    set(flags -DTW_STRICT -ffp-contract=off)
  endif()
  add_custom_command(OUTPUT ${ptx}
                     COMMAND ${TWINWAKE_CLANG} ${ptx_flags} ${flags} -I${PROJECT_SOURCE_DIR} ${kernels} -o ${ptx}
                             -MD -MF ${ptx}.d
                     DEPENDS ${kernels} DEPFILE ${ptx}.d COMMENT "Making ${kind}.ptx" VERBATIM)
  file(WRITE ${ptx}.S.new ".section .rodata\n.globl tw_${kind}_ptx\ntw_${kind}_ptx:\n.incbin \"${ptx}\"\n.byte 0\n\
.section .note.GNU-stack,\"\",%progbits\n")
  file(COPY_FILE ${ptx}.S.new ${ptx}.S ONLY_IF_DIFFERENT)
  set_source_files_properties(${ptx}.S PROPERTIES OBJECT_DEPENDS ${ptx})
  list(APPEND sources ${ptx}.S)
endforeach()
list(APPEND sources cuda/driver.cpp cuda/peaks.cpp levels/edges_on_device.cpp levels/fields_on_device.cpp
     levels/halo_on_device.cpp     levels/lists_on_device.cpp
     levels/loops_on_device.cpp levels/neighbours_on_device.cpp levels/on_device.cpp)
