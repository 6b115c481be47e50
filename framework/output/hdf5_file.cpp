#include "output/hdf5_file.h"

#include <hdf5.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace similitude {
namespace {

constexpr std::size_t k_chunk_bytes = std::size_t{1} << 20;    // what one checksum covers: small enough to stay in the cache
constexpr std::size_t k_growth_bytes = std::size_t{32} << 20;  // of the file in memory

template <class Result>
Result checked(Result result, const std::string& what) {
  if (result < 0) throw Hdf5Error(what);
  return result;
}

/// Something of HDF5's that must be closed.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const std::string& what) : id_(checked(id, what)), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

hid_t in_memory(Hdf5Column::Type type) {
  switch (type) {
    case Hdf5Column::Type::f64: return H5T_NATIVE_DOUBLE;
    case Hdf5Column::Type::u64: return H5T_NATIVE_UINT64;
    case Hdf5Column::Type::u32: return H5T_NATIVE_UINT32;
    case Hdf5Column::Type::u8: return H5T_NATIVE_UINT8;
  }
  return -1;
}

hid_t in_file(Hdf5Column::Type type) {
  switch (type) {
    case Hdf5Column::Type::f64: return H5T_IEEE_F64LE;
    case Hdf5Column::Type::u64: return H5T_STD_U64LE;
    case Hdf5Column::Type::u32: return H5T_STD_U32LE;
    case Hdf5Column::Type::u8: return H5T_STD_U8LE;
  }
  return -1;
}

/// HDF5 would print its own stack of causes; whoever calls says it in the user's terms.
void be_quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

Handle space_of(const Hdf5Column& column, const std::string& path) {
  const std::array<hsize_t, 2> extent{column.rows, column.width};
  return {H5Screate_simple(column.width == 1 ? 1 : 2, extent.data(), nullptr), H5Sclose, path};
}

/// No rows: nothing to chunk, nothing to check.
Handle creation_of(const Hdf5Column& column, std::size_t row_bytes, const std::string& path) {
  Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, path);
  checked(H5Pset_obj_track_times(creation, false), path);   // the same state, the same bytes
  if (column.rows == 0) return creation;
  const std::size_t rows = std::clamp<std::size_t>(k_chunk_bytes / row_bytes, 1, column.rows);
  const std::array<hsize_t, 2> chunk{rows, column.width};
  checked(H5Pset_chunk(creation, column.width == 1 ? 1 : 2, chunk.data()), path);
  checked(H5Pset_fletcher32(creation), path);
  checked(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), path);
  return creation;
}

void write_text_attribute(hid_t object, const char* name, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, name);
  checked(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)), name);
  checked(H5Tset_cset(type, H5T_CSET_UTF8), name);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, name);
  const Handle attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  checked(H5Awrite(attribute, type, text.c_str()), name);
}

}  // namespace

// ----------------------------------------------------------------------------------------------------------- writing

/// The file's bytes outlive its closing: only then are they those of a file that nobody has open for writing.
struct Hdf5Writer::Parts {
  hid_t file = -1;
  void* memory = nullptr;

  ~Parts() {
    if (file >= 0) H5Fclose(file);
    std::free(memory);
  }
};

namespace {

// HDF5 asks here for the memory of the file. `owner` is Parts::memory.
void* make_room(std::size_t size, H5FD_file_image_op_t, void* owner) { return *static_cast<void**>(owner) = std::malloc(size); }
void* change_room(void* memory, std::size_t size, H5FD_file_image_op_t, void* owner) {
  void* const moved = std::realloc(memory, size);
  if (moved != nullptr) *static_cast<void**>(owner) = moved;
  return moved;
}
herr_t keep_room(void*, H5FD_file_image_op_t, void*) { return 0; }
void* same_owner(void* owner) { return owner; }
herr_t free_owner(void*) { return 0; }

}  // namespace

Hdf5Writer::Hdf5Writer() : parts_(std::make_unique<Parts>()) {
  be_quiet();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "file");
  checked(H5Pset_fapl_core(access, k_growth_bytes, false), "file");
  H5FD_file_image_callbacks_t memory{make_room, nullptr, change_room, keep_room, same_owner, free_owner, &parts_->memory};
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "file");
  checked(H5Pset_obj_track_times(creation, false), "file");
  checked(H5Pset_file_image_callbacks(access, &memory), "file");
  // No room in advance: closing would give back what is left of it, and the end of the file would not be known before.
  checked(H5Pset_meta_block_size(access, 0), "file");
  checked(H5Pset_small_data_block_size(access, 0), "file");
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_LATEST, H5F_LIBVER_LATEST), "file");
  parts_->file = checked(H5Fcreate("checkpoint in memory", H5F_ACC_TRUNC, creation, access), "file");
}

Hdf5Writer::~Hdf5Writer() = default;

void Hdf5Writer::group(const std::string& path) {
  const Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, path);
  checked(H5Pset_obj_track_times(creation, false), path);
  const Handle made(H5Gcreate2(parts_->file, path.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose, path);
}

void Hdf5Writer::dataset(const std::string& path, const void* numbers, const Hdf5Column& column, const std::string& columns) {
  const Handle space = space_of(column, path);
  const Handle creation = creation_of(column, column.width * H5Tget_size(in_memory(column.type)), path);
  const Handle made(H5Dcreate2(parts_->file, path.c_str(), in_file(column.type), space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose, path);
  write_text_attribute(made, "columns", columns);
  if (column.rows > 0) checked(H5Dwrite(made, in_memory(column.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), path);
}

void Hdf5Writer::text(const std::string& path, const std::string& text) {
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose, path);
  checked(H5Tset_size(type, std::max<std::size_t>(text.size(), 1)), path);
  checked(H5Tset_cset(type, H5T_CSET_UTF8), path);
  const Hdf5Column one{.type = Hdf5Column::Type::u8, .rows = 1, .width = 1};
  const Handle space = space_of(one, path);
  const Handle creation = creation_of(one, 1, path);
  const Handle made(H5Dcreate2(parts_->file, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose, path);
  checked(H5Dwrite(made, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()), path);
}

void Hdf5Writer::attribute(const std::string& group, const std::string& name, const void* numbers, const Hdf5Column& column) {
  const Handle at(H5Gopen2(parts_->file, group.c_str(), H5P_DEFAULT), H5Gclose, group);
  const Handle space = space_of(column, name);
  const Handle made(H5Acreate2(at, name.c_str(), in_file(column.type), space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  checked(H5Awrite(made, in_memory(column.type), numbers), name);
}

std::string_view Hdf5Writer::bytes() {
  checked(H5Fflush(parts_->file, H5F_SCOPE_GLOBAL), "file");
  const auto size = static_cast<std::size_t>(checked(H5Fget_file_image(parts_->file, nullptr, 0), "file"));
  checked(H5Fclose(std::exchange(parts_->file, -1)), "file");
  return {static_cast<const char*>(parts_->memory), size};
}

// ----------------------------------------------------------------------------------------------------------- reading

struct Hdf5Reader::Parts {
  hid_t file = -1;
};

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file) : parts_(std::make_unique<Parts>()) {
  be_quiet();
  parts_->file = checked(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "it is cut short or no HDF5 file");
}

Hdf5Reader::~Hdf5Reader() { H5Fclose(parts_->file); }

std::size_t Hdf5Reader::rows(const std::string& path) {
  const Handle found(H5Dopen2(parts_->file, path.c_str(), H5P_DEFAULT), H5Dclose, path);
  const Handle space(H5Dget_space(found), H5Sclose, path);
  std::array<hsize_t, H5S_MAX_RANK> extent{};
  if (checked(H5Sget_simple_extent_dims(space, extent.data(), nullptr), path) < 1) throw Hdf5Error(path);
  return extent[0];
}

void Hdf5Reader::dataset(const std::string& path, void* numbers, const Hdf5Column& column) {
  const Handle found(H5Dopen2(parts_->file, path.c_str(), H5P_DEFAULT), H5Dclose, path);
  const Handle space(H5Dget_space(found), H5Sclose, path);
  if (checked(H5Sget_simple_extent_npoints(space), path) != static_cast<hssize_t>(column.rows * column.width)) throw Hdf5Error(path);
  if (column.rows > 0) checked(H5Dread(found, in_memory(column.type), H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers), path);
}

std::string Hdf5Reader::text(const std::string& path) {
  const Handle found(H5Dopen2(parts_->file, path.c_str(), H5P_DEFAULT), H5Dclose, path);
  const Handle type(H5Dget_type(found), H5Tclose, path);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 || rows(path) != 1) throw Hdf5Error(path);
  std::string text(H5Tget_size(type), '\0');
  checked(H5Dread(found, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()), path);
  return text;
}

void Hdf5Reader::attribute(const std::string& group, const std::string& name, void* numbers, const Hdf5Column& column) {
  const std::string what = group + "/" + name;
  const Handle at(H5Gopen2(parts_->file, group.c_str(), H5P_DEFAULT), H5Gclose, group);
  const Handle found(H5Aopen(at, name.c_str(), H5P_DEFAULT), H5Aclose, what);
  const Handle space(H5Aget_space(found), H5Sclose, what);
  if (checked(H5Sget_simple_extent_npoints(space), what) != static_cast<hssize_t>(column.rows * column.width)) throw Hdf5Error(what);
  checked(H5Aread(found, in_memory(column.type), numbers), what);
}

}  // namespace similitude
