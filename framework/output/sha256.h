#pragma once
/// SHA-256 (FIPS 180-4): names a plugin's file and a bed's state for ever.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace similitude {

class Sha256 {
 public:
  void add(const void* bytes, std::size_t count);
  /// 64 hexadecimal digits. The object is spent.
  std::string hex();

 private:
  void compress(const std::uint8_t* block);
  std::array<std::uint32_t, 8> state_{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                      0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_{};
  std::size_t filled_ = 0;
  std::uint64_t bytes_ = 0;
};

/// "" if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace similitude
