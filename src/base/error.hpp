// Failures of the environment (files, GL, usage). Thrown where they are met, caught once in main, shown as
// one line. Faults of geometry are no errors: they are values in the health report.
#pragma once

#include <stdexcept>
#include <string>

namespace moldlight {

/// A failure that ends the command with exit code 1. The text is one line: what, where, what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A command line that makes no sense: exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};

/// A file that cannot be read or written; `place` is where in the file ("line 12", "byte 84", "facet 3"), may
/// be empty.
class FileError : public Error {
 public:
  FileError(const std::string& file, const std::string& place, const std::string& what)
      : Error(file + (place.empty() ? "" : ": " + place) + ": " + what) {}
};

/// The user (or a time limit) ended the work: exit code 130.
class Cancelled : public Error {
 public:
  Cancelled() : Error("interrupted") {}
};

}  // namespace moldlight
