// What Mesa reads from the process's environment before its first context.
#pragma once

namespace moldlight::gl {

/// True if Mesa will find a writable folder for its shader cache, which saves a start 30 ms of compiling.
[[nodiscard]] bool shader_cache_is_writable();

/// Keeps Mesa quiet on stderr: turns its shader cache off where the folder cannot be written, and its
/// warnings about devices that it passes over. What the user has set stays. Acts once a process; call it
/// before a context is created, while no other thread reads the environment.
void prepare_mesa_environment();

}  // namespace moldlight::gl
