// What libFuzzer calls; replay.cpp calls it for files. Errors are answers, everything else is a find.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
