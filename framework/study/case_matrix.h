#pragma once
/// From axes to cases.

#include <vector>

#include "study/study_file.h"

namespace similitude {

/// The named cases, or every combination of the axes, the last axis fastest; named by their values:
/// "gidaspow-cell_2.5mm". Throws InputError where two combinations have one name.
std::vector<NamedCase> cases_of(const StudyFile& study);

}  // namespace similitude
