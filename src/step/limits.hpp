// What the program may have: its memory, said when that runs out, and no more rights than it needs.
#pragma once

#include <cstdint>
#include <string>

namespace moldlight::step {

/// Limits the address space, but never raises a limit that is there, and opens what memory_ran_short() reads.
/// `refused` is called where an allocation in C++ fails, and must not return.
void limit_memory(std::uint64_t bytes, void (*refused)());

/// True where the address space was nearly used up at some time. OpenCASCADE passes over many an allocation
/// that fails and leaves out the faces it was for.
[[nodiscard]] bool memory_ran_short();

/// From here on the kernel refuses this program files, the network and other programs (a seccomp filter): it
/// can compute, take memory, read what is open and write its result. Returns why that fails; empty if it
/// holds.
[[nodiscard]] std::string give_up_rights();

}  // namespace moldlight::step
