#pragma once

#include <exception>

namespace similitude {

/// Catches SIGINT and SIGTERM while it lives, so that a run ends between two gas steps with its files whole.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  /// 0, or the signal that came.
  static int received();
};

/// A signal came in the middle of something that leaves nothing behind: thrown to get out of it.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

}  // namespace similitude
