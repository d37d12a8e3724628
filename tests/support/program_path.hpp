// Where other programs are that tests look at results with.
#pragma once

#include <initializer_list>
#include <string>

namespace moldlight::test {

/// The first of these programs that is in a folder of PATH, with its folder; empty where there is none.
[[nodiscard]] std::string program_path(std::initializer_list<const char*> names);

}  // namespace moldlight::test
