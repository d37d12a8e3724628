#include "base/error.hpp"

namespace moldlight {

FileError::FileError(const std::string& file, const std::string& place, const std::string& what)
    : Error(file + (place.empty() ? "" : ": " + place) + ": " + what) {}

}  // namespace moldlight
