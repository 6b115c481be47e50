#pragma once
#include <string>

namespace similitude {

/// Why a file is not taken, in the user's terms, and what to do. No path: whoever tells it knows the file.
struct Refusal {
  std::string reason;
  std::string fix;
};

}  // namespace similitude
