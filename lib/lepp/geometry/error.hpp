#pragma once

#include <stdexcept>
#include <string>

namespace lepp {

/// What went wrong, as the program's exit status tells it (cli/main.cpp).
enum class ErrorKind {
  input,    ///< the input is wrong: exit status 2
  refused,  ///< too large, or a time or memory limit: exit status 4
  output,   ///< a file could not be written: exit status 5
};

/// An error a user can act on. The library throws it and never prints.
/// `where` names the file and line, or the user's entity id, or coordinates;
/// `problem` says what is wrong there; `remedy` says what to do.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string where, std::string problem, std::string remedy);

  ErrorKind kind() const { return kind_; }
  const std::string& where() const { return where_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }

 private:
  ErrorKind kind_;
  std::string where_, problem_, remedy_;
};

/// The input is wrong.
class InputError : public Error {
 public:
  InputError(std::string where, std::string problem, std::string remedy)
      : Error(ErrorKind::input, std::move(where), std::move(problem), std::move(remedy)) {}
};

/// The input is right but the work was refused or stopped: predicted size, time, memory.
class RefusedError : public Error {
 public:
  RefusedError(std::string where, std::string problem, std::string remedy)
      : Error(ErrorKind::refused, std::move(where), std::move(problem), std::move(remedy)) {}
};

/// A file could not be written; the old file, if any, is untouched.
class OutputError : public Error {
 public:
  OutputError(std::string where, std::string problem, std::string remedy)
      : Error(ErrorKind::output, std::move(where), std::move(problem), std::move(remedy)) {}
};

}  // namespace lepp
