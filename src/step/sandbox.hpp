// What the program may do: no more than it needs.
#pragma once

#include <string>

namespace moldlight::step {

/// From here on the kernel refuses this program files, the network and other programs (a seccomp filter): it
/// can compute, take memory, read what is open and write its result. Returns why that fails; empty if it
/// holds.
[[nodiscard]] std::string give_up_rights();

}  // namespace moldlight::step
