#pragma once
#include <similitude/abi.h>

#include <string>

namespace similitude {

/// What is wrong with one row of a parameter table, without the parameter's name; empty if nothing is.
std::string check_parameter(const similitude_parameter& parameter);

/// Whether `word` is one of "a|b|c".
bool is_choice(const std::string& choices, const std::string& word);

}  // namespace similitude
