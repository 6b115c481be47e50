#include "loader/tag.h"

#include <fcntl.h>
#include <gelf.h>
#include <libelf.h>
#include <similitude/layout.h>
#include <similitude/plugin.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "loader/processor.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;

constexpr const char* k_no_plugin_of_ours =
    "Build it with similitude_add_plugin() and name its model with a macro such as SIMILITUDE_DRAG_LAW, or move it "
    "elsewhere.";
constexpr const char* k_rebuild =
    "Rebuild it against this program: "
    "cmake -B build -DCMAKE_PREFIX_PATH=<prefix> && cmake --build build";

/// A file open for reading, closed when done.
struct OpenFile {
  explicit OpenFile(const fs::path& file) : descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int descriptor;
};

struct ElfEnd {
  void operator()(Elf* elf) const { elf_end(elf); }
};

/// A field of fixed length, which need not be ended by a zero.
template <std::size_t N>
std::string text_of(const char (&field)[N]) {
  std::string text(field, std::find(field, field + N, '\0'));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

std::string abi_version(unsigned major, unsigned minor) { return std::to_string(major) + "." + std::to_string(minor); }

std::string hexadecimal(std::uint32_t value) {
  char text[16];
  std::snprintf(text, sizeof text, "%08x", value);
  return text;
}

std::string both_sides(const similitude_tag& tag) {
  return "\n(plugin: " + text_of(tag.compiler) + ", " + text_of(tag.instruction_set) + " | program: " + compiler() +
         ", " + instruction_set() + ")";
}

/// The bytes of the section named `name`; false if there is none.
bool find_section(Elf* elf, const char* name, const char*& bytes, std::size_t& size) {
  std::size_t names = 0;
  if (elf_getshdrstrndx(elf, &names) != 0) return false;
  for (Elf_Scn* section = nullptr; (section = elf_nextscn(elf, section)) != nullptr;) {
    GElf_Shdr header;
    if (gelf_getshdr(section, &header) == nullptr) continue;
    const char* section_name = elf_strptr(elf, names, header.sh_name);
    if (section_name == nullptr || std::strcmp(section_name, name) != 0) continue;
    const Elf_Data* data = elf_rawdata(section, nullptr);
    if (data == nullptr || data->d_buf == nullptr) return false;
    bytes = static_cast<const char*>(data->d_buf);
    size = data->d_size;
    return true;
  }
  return false;
}

std::optional<Refusal> check_file(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored))
    return Refusal{"it is a folder, not a library.",
                   "Move it elsewhere, or name the folder itself under plugin_paths."};
  std::error_code failed;
  if (fs::is_symlink(file, ignored) && !fs::exists(file, failed)) {
    const bool circle = failed == std::errc::too_many_symbolic_link_levels;
    return Refusal{"it is a symbolic link to " + fs::read_symlink(file, ignored).string() +
                       (circle ? " in a circle of links." : ", which is not there."),
                   "Point the link to the library, or remove it."};
  }
  if (!fs::is_regular_file(file, ignored) && fs::exists(file, ignored))  // opening a pipe would wait for its writer
    return Refusal{"it is not a regular file.", "Move it elsewhere."};
  return std::nullopt;
}

}  // namespace

std::variant<similitude_tag, Refusal> read_tag(const fs::path& file) {
  if (auto refusal = check_file(file)) return *refusal;
  const OpenFile open(file);
  if (open.descriptor < 0)
    return Refusal{std::string("it cannot be read: ") + std::strerror(errno) + ".",
                   "Make it readable to this user, or remove it."};

  elf_version(EV_CURRENT);
  const std::unique_ptr<Elf, ElfEnd> elf(elf_begin(open.descriptor, ELF_C_READ, nullptr));
  if (elf == nullptr || elf_kind(elf.get()) != ELF_K_ELF)
    return Refusal{"it is not a library (no ELF file).",
                   "Build the plugin with similitude_add_plugin(), or remove the file."};

  const char* bytes = nullptr;
  std::size_t size = 0;
  if (!find_section(elf.get(), SIMILITUDE_TAG_SECTION, bytes, size))
    return Refusal{"it is no plugin: it has no section " SIMILITUDE_TAG_SECTION ".", k_no_plugin_of_ours};
  if (size < k_first_size<similitude_tag>)
    return Refusal{"its tag has " + std::to_string(size) + " bytes, this program reads " +
                       std::to_string(k_first_size<similitude_tag>) + ".",
                   k_rebuild};
  similitude_tag tag{};
  std::memcpy(&tag, bytes, std::min(size, sizeof tag));
  if (std::memcmp(tag.magic, SIMILITUDE_TAG_MAGIC, sizeof tag.magic) != 0)
    return Refusal{"its tag starts with \"" + text_of(tag.magic) + "\", not with \"" SIMILITUDE_TAG_MAGIC "\".",
                   k_no_plugin_of_ours};
  return tag;
}

std::optional<Refusal> check_tag(const similitude_tag& tag) {
  const std::string ours = abi_version(SIMILITUDE_ABI_MAJOR, SIMILITUDE_ABI_MINOR);
  const std::string theirs = abi_version(tag.abi_major, tag.abi_minor);
  if (tag.abi_major != SIMILITUDE_ABI_MAJOR)
    return Refusal{"built for plugin ABI " + theirs + ", this program offers ABI " + ours + ".",
                   k_rebuild + both_sides(tag)};
  if (tag.abi_minor > SIMILITUDE_ABI_MINOR)
    return Refusal{"built for plugin ABI " + theirs + ", this program offers ABI " + ours + ".",
                   "Update Similitude, or build the plugin for this one.\n" + (k_rebuild + both_sides(tag))};
  if (tag.layout_hash != abi::layout_hash() || tag.struct_size < k_first_size<similitude_tag>)
    return Refusal{"built for plugin ABI " + theirs + " with another layout of its structures (" +
                       hexadecimal(tag.layout_hash) + ", this program's is " + hexadecimal(abi::layout_hash()) + ").",
                   k_rebuild + both_sides(tag)};
  const std::string wanted = text_of(tag.instruction_set);
  if (!processor_has(wanted))
    return Refusal{
        "built for the instruction set " + wanted + ", this processor has " + processor_instruction_set() + ".",
        "Rebuild it for this processor: cmake -B build -DSIMILITUDE_MARCH=" + processor_instruction_set() +
            " && cmake --build build" + both_sides(tag)};
  return std::nullopt;
}

}  // namespace similitude
