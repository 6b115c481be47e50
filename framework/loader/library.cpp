#include "loader/library.h"

#include <dlfcn.h>

#include <cstdio>
#include <map>
#include <string>

#define BOOST_DLL_USE_STD_FS
#include <boost/dll/shared_library.hpp>

#include "loader/descriptor_check.h"
#include "loader/processor.h"
#include "loader/tag.h"

namespace similitude {
namespace {

namespace fs = std::filesystem;
using Outcome = std::variant<const similitude_entry*, Refusal>;

struct MappedLibrary {
  boost::dll::shared_library library;
  Outcome outcome;
};

/// What the system's loader said last, without the file's name, which whoever tells it puts in front.
std::string loader_words(const fs::path& file) {
  const char* said = dlerror();
  std::string words = said == nullptr ? "the system does not say why" : said;
  const std::string prefix = file.string() + ": ";
  if (words.starts_with(prefix)) words.erase(0, prefix.size());
  return words;
}

/// Maps without the rest of the checks. Everything is resolved now: a missing symbol must not show up in the middle of
/// a run.
bool map(boost::dll::shared_library& library, const fs::path& file, Refusal& refusal) {
  using boost::dll::load_mode::rtld_local;
  using boost::dll::load_mode::rtld_now;
  std::error_code failed;
  library.load(file, failed, rtld_now | rtld_local);
  if (library.is_loaded()) return true;
  const std::string words = loader_words(file);
  refusal.reason = "the system cannot load it: " + words + ".";
  refusal.fix = words.starts_with("undefined symbol")
                    ? "Link what defines the symbol: similitude_add_plugin(… LINKS …) finds it missing at build time."
                    : "Install what is missing, or rebuild the plugin on this machine.";
  return false;
}

Refusal changed_floating_point(std::uint32_t before, std::uint32_t after) {
  char words[160];
  std::snprintf(
      words, sizeof words,
      "loading it changed the processor's floating-point control word from 0x%04x to 0x%04x; it was set back.", before,
      after);
  return {words,
          "Rebuild it without -ffast-math and -Ofast, whose start-up code flushes small numbers to zero in the whole "
          "program."};
}

Outcome map_and_check(boost::dll::shared_library& library, const fs::path& file) {
  Refusal refusal;
  const std::uint32_t before = floating_point_control();
  const bool mapped = map(library, file, refusal);
  const std::uint32_t after = floating_point_control();
  if (after != before) {
    set_floating_point_control(before);
    if (mapped) return changed_floating_point(before, after);
  }
  if (!mapped) return refusal;
  if (!library.has(SIMILITUDE_ENTRY_SYMBOL))
    return Refusal{"it does not export " SIMILITUDE_ENTRY_SYMBOL ".",
                   "Build it with similitude_add_plugin(), which keeps this one symbol visible."};
  const auto& entry = library.get<const similitude_entry>(SIMILITUDE_ENTRY_SYMBOL);
  if (auto wrong = check_entry(entry)) return *wrong;
  return &entry;
}

}  // namespace

Outcome load_library(const fs::path& file) {
  const auto tag = read_tag(file);
  if (const auto* refusal = std::get_if<Refusal>(&tag)) return *refusal;
  if (auto refusal = check_tag(std::get<similitude_tag>(tag))) return *refusal;

  // Start-up code runs when a library is mapped for the first time only, so what it did must be remembered. Never
  // destroyed: a descriptor, a model's code and the library's own statics must outlive everything that uses them.
  static auto& mapped = *new std::map<fs::path, MappedLibrary>;
  const fs::path real = fs::canonical(file);
  const auto [place, is_new] = mapped.try_emplace(real);
  MappedLibrary& known = place->second;
  if (is_new) known.outcome = map_and_check(known.library, real);
  return known.outcome;
}

}  // namespace similitude
