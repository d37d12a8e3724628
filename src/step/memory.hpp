// Keeps the program within its memory, and has it say so when that runs out.
#pragma once

#include <cstdint>

namespace moldlight::step {

/// Limits the address space, but never raises a limit that is there, and opens what memory_ran_short() reads.
/// `refused` is called where an allocation in C++ fails, and must not return.
void limit_memory(std::uint64_t bytes, void (*refused)());

/// True where the address space was nearly used up at some time. OpenCASCADE passes over many an allocation
/// that fails and leaves out the faces it was for.
[[nodiscard]] bool memory_ran_short();

}  // namespace moldlight::step
