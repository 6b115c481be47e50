#include "scene/messages.h"

namespace similitude {
namespace {

std::string place(const SourceMark& mark) {
  if (mark.file.empty() || mark.line == 0) return mark.file;
  return mark.file + ":" + std::to_string(mark.line) + ":" + std::to_string(mark.column);
}

std::string compose(const std::string& where, const std::string& path, const std::string& what,
                    const std::string& fix) {
  std::string text;
  if (!where.empty()) text += where + ": ";
  if (!path.empty()) text += path + ": ";
  text += what;
  if (!fix.empty()) text += "\n  ";
  for (const char c : fix) text += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return text;
}

}  // namespace

InputError::InputError(const SourceMark& mark, const std::string& path, const std::string& what, const std::string& fix)
    : std::runtime_error(compose(place(mark), path, what, fix)) {}

InputError::InputError(const std::string& what, const std::string& fix)
    : std::runtime_error(compose("", "", what, fix)) {}

}  // namespace similitude
