#pragma once

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

}  // namespace similitude
