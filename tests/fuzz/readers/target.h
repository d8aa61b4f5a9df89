#pragma once
#include <cstddef>
#include <cstdint>

// What libFuzzer calls, and driver.cpp where there is none.
extern "C" {
/// Takes --reader=NAME.
int LLVMFuzzerInitialize(int* count, char*** words);
/// Gives the bytes to that reader. An error that is none of the program's own ends the process.
int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);
}
