// SPDX-License-Identifier: MIT
// The ways in which a program of Bake fails. Each carries one line for people and decides the exit code.
#pragma once

#include <stdexcept>

namespace bake {

/// A mistake of the user: wrong file, key, value or option. `what()` is one line: file:line: key: found, allowed.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file could not be written. `what()` is one line: file: what failed: the system's reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same of a file that was begun: the disk is full, or fails.
class UnfinishedOutputError : public OutputError {
 public:
  using OutputError::OutputError;
};

/// A run or another piece of work cannot go on: names particle, quantity and step, or what else failed. What was written before is kept.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace bake
