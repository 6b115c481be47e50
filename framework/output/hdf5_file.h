#pragma once
/// Datasets and attributes of an HDF5 file that is either whole and unaltered or refused. Nothing of HDF5 is seen outside.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "particles/store.h"

namespace similitude {

/// The file is no HDF5 file, is cut short or altered, or lacks something. Message: which part.
class Hdf5Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A column of numbers to write or fill, by the type of its memory.
struct Hdf5Column {
  enum class Type { f64, u64, u32, u8 };
  Type type = Type::f64;
  std::size_t rows = 0;
  std::size_t width = 1;   // numbers to a row
};

/// Made in memory, so that the disk is written in one place (write_whole_file), which sees when it is full. Every dataset
/// is chunked with a Fletcher-32 checksum to a chunk, and the format is recent enough that everything else has checksums too.
class Hdf5Writer {
 public:
  Hdf5Writer();
  ~Hdf5Writer();
  Hdf5Writer(const Hdf5Writer&) = delete;
  Hdf5Writer& operator=(const Hdf5Writer&) = delete;

  void group(const std::string& path);
  /// `columns`: what stands in a row, with units.
  void dataset(const std::string& path, const void* numbers, const Hdf5Column& column, const std::string& columns);
  void text(const std::string& path, const std::string& text);
  /// At a group: "skin [m]".
  void attribute(const std::string& group, const std::string& name, const void* numbers, const Hdf5Column& column);
  /// Closes the file; its bytes live as long as this.
  std::string_view bytes();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

class Hdf5Reader {
 public:
  /// Throws Hdf5Error, as all do.
  explicit Hdf5Reader(const std::filesystem::path& file);
  ~Hdf5Reader();
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  std::size_t rows(const std::string& path);
  void dataset(const std::string& path, void* numbers, const Hdf5Column& column);
  std::string text(const std::string& path);
  void attribute(const std::string& group, const std::string& name, void* numbers, const Hdf5Column& column);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace similitude
