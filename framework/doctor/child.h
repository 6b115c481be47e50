#pragma once
/// Work in a child process whose death is an answer.

#include <functional>
#include <string>

namespace similitude::doctor {

struct ChildAnswer {
  bool lived = false;
  std::string text;    // what the work returned; or how the child died, in words
  std::string advice;  // of a death: what to look for
};

/// Runs `work` in a fork and returns its text. The child's standard output goes to standard error. It is ended after
/// `limit` seconds. A touch of a guarded column's forbidden pages is named by column and side.
ChildAnswer in_child(const std::function<std::string()>& work, double limit);

}  // namespace similitude::doctor
