#pragma once
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace similitude::doctor {

/// work(0) … work(threads - 1), each on a thread of its own, all at once. By thread: what it threw; empty if nothing.
template <class Work>
std::vector<std::string> at_once(std::size_t threads, const Work& work) {
  std::vector<std::string> thrown(threads);
  std::vector<std::thread> team;
  for (std::size_t t = 0; t < threads; ++t) {
    team.emplace_back([&work, &thrown, t] {
      try {
        work(t);
      } catch (const std::exception& error) {
        thrown[t] = error.what();
      }
    });
  }
  for (std::thread& thread : team) thread.join();
  return thrown;
}

}  // namespace similitude::doctor
