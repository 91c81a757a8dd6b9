#include "model/board/thickness_override.h"

#include <algorithm>
#include <string>

#include "model/base/thickness_units.h"
#include "model/board/stackup.h"

namespace model {

using base::Error;
using base::ErrorCode;

namespace {

std::string rowNames(const Stackup& stackup) {
    std::string names;
    for (const StackupRow& row : stackup.rows) {
        names += (names.empty() ? "" : ", ") + row.name;
    }
    return names.empty() ? "the board states its heights itself" : "the stackup has " + names;
}

}  // namespace

base::Result<ThicknessOverride> parseOverride(std::string_view text, const Stackup& stackup) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string_view::npos) {
        return Error{ErrorCode::BadUsage, "\"" + std::string(text) + "\" is not LAYER=LENGTH, for example TOP=35um"};
    }
    std::string_view name = text.substr(0, equals);
    name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
    name = name.substr(0, name.find_last_not_of(" \t") + 1);
    const StackupRow* row = findRow(stackup, name);
    if (row == nullptr) {
        return Error{ErrorCode::BadUsage,
                     "there is no layer " + std::string(name) + " in the stackup; " + rowNames(stackup)};
    }
    ASSIGN_OR_RETURN(const Nm nm, parseThickness(text.substr(equals + 1), copperWeightOf(*row).has_value()));
    return ThicknessOverride{row->name, nm};
}

}  // namespace model
