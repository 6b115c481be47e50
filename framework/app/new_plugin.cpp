#include "app/new_plugin.h"

#include <array>
#include <cctype>
#include <fstream>
#include <map>
#include <sstream>

#include "loader/spelling.h"
#include "scene/messages.h"

namespace similitude::app {
namespace {

namespace fs = std::filesystem;

constexpr std::array k_kinds = {"drag", "contact", "fluid", "scaling", "effect"};

/// <prefix> of <prefix>/bin/similitude.
fs::path prefix() { return fs::read_symlink("/proc/self/exe").parent_path().parent_path(); }

/// The folder of a kind's templates.
fs::path templates_of(const std::string& kind) {
  std::string kinds;
  for (const char* known : k_kinds) {
    if (kind == known) {
      const fs::path folder = prefix() / "share" / "similitude" / "templates" / kind;
      if (fs::is_directory(folder)) return folder;
      const bool built_here = fs::exists(prefix() / "cmake_install.cmake");
      throw InputError("the templates of plugins are not installed: " + folder.string() + " is not there.",
                       "Install the Debian package similitude-dev" +
                           (built_here ? ", or type: cmake --install " + prefix().string() +
                                             " --prefix PREFIX && PREFIX/bin/similitude plugins new …"
                                       : "."));
    }
    kinds += (kinds.empty() ? "" : ", ") + std::string(known);
  }
  throw InputError("there is no kind \"" + kind + "\".", "Use one of: " + kinds + ".");
}

/// "org.example.my-law" to "my_law".
std::string name_of(const std::string& id) {
  std::string name = id.substr(id.rfind('.') + 1);
  for (char& letter : name)
    if (letter == '-') letter = '_';
  if (!is_model_id(id) || !is_lower_snake(name))
    throw InputError("\"" + id + "\" is no id.", "Write my_law, or org.example.my_law to share it with others.");
  return name;
}

/// "my_law" to "MyLaw".
std::string type_of(const std::string& name) {
  std::string type;
  bool begins = true;
  for (const char letter : name) {
    if (letter != '_') type += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    begins = letter == '_';
  }
  return type;
}

std::string filled_in(std::string text, const std::map<std::string, std::string>& values) {
  for (const auto& [key, value] : values)
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + value.size()))
      text.replace(at, key.size(), value);
  return text;
}

void write_file(const fs::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw InputError(file.string() + " cannot be written.", "Choose a folder that this user may write to.");
}

std::string read_file(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// What `cmake -B build` must be told to find the package of this very program; nothing where it looks anyway.
std::string where_the_package_is() {
  const fs::path here = prefix();
  return here == "/usr" || here == "/usr/local" ? "" : " -DCMAKE_PREFIX_PATH=" + here.string();
}

}  // namespace

std::string write_new_plugin(const std::string& kind, const std::string& id, const fs::path& parent) {
  const fs::path templates = templates_of(kind);
  const std::string name = name_of(id);
  const fs::path folder = parent / name;
  if (fs::exists(fs::symlink_status(folder)))
    throw InputError(folder.string() + " is there already; nothing of it was changed.",
                     "Remove it, choose another id, or name another folder with -o.");

  const std::map<std::string, std::string> values = {{"@name@", name}, {"@Type@", type_of(name)}, {"@id@", id}};
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw InputError(folder.string() + " cannot be made: " + failed.message() + ".", "Name another folder with -o.");
  for (const fs::directory_entry& entry : fs::directory_iterator(templates))
    write_file(folder / filled_in(entry.path().filename().string(), values), filled_in(read_file(entry.path()), values));

  return folder.string() + ": " + name + ".h is the model, README.md says how to make it yours.\n" +
         "Build it, test it, and use it:\n" +
         "  cd " + folder.string() + " && cmake -B build" + where_the_package_is() + " && cmake --build build\n" +
         "  ctest --test-dir build --output-on-failure\n" +
         "  similitude run case.yaml\n";
}

}  // namespace similitude::app
