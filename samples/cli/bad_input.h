// What the user gave cannot be used. Ends the program with exit code 2 and one line per problem.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine.h"

namespace cli {

class BadInput : public std::runtime_error {
 public:
  /// `subject` is what the problems are about and starts each line: a file name, an option.
  BadInput(std::string subject, std::vector<Issue> issues)
      : std::runtime_error("bad input: " + subject), subject_(std::move(subject)), issues_(std::move(issues)) {}
  BadInput(std::string subject, const std::string& error) : BadInput(std::move(subject), {Issue{true, error}}) {}
  const std::string& subject() const { return subject_; }
  const std::vector<Issue>& issues() const { return issues_; }

 private:
  std::string subject_;
  std::vector<Issue> issues_;
};

}  // namespace cli
