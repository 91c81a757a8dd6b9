#include "model/session/saved_section.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/units.h"
#include "model/session/saved_section_json.h"

namespace model::session {

using nlohmann::ordered_json;

namespace {

bool isCorner(const ordered_json& value) {
    return value.is_array() && value.size() == 2 && std::ranges::all_of(value, [](const ordered_json& nm) {
               return nm.is_number() && std::abs(nm.get<double>()) <= base::kMaxCoordinate;
           });
}

}  // namespace

bool SavedSection::operator==(const SavedSection& other) const {
    return name == other.name && step == other.step &&
           std::ranges::equal(line, other.line, [](auto a, auto b) { return a.x == b.x && a.y == b.y; });
}

ordered_json toJson(const SavedSection& section) {
    ordered_json line = ordered_json::array();
    for (const base::PointD corner : section.line) {
        line.push_back(std::array{corner.x, corner.y});
    }
    return {{"name", section.name}, {"step", section.step}, {"line_nm", line}};
}

std::optional<SavedSection> sectionFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json name = json.value("name", ordered_json());
    const ordered_json step = json.value("step", ordered_json());
    const ordered_json line = json.value("line_nm", ordered_json());
    if (!name.is_string() || !step.is_string() || !line.is_array() || line.size() < 2 ||
        !std::ranges::all_of(line, isCorner)) {
        return std::nullopt;
    }
    SavedSection section{name.get<std::string>(), step.get<std::string>(), {}};
    for (const ordered_json& corner : line) {
        section.line.push_back({corner[0].get<double>(), corner[1].get<double>()});
    }
    return section;
}

}  // namespace model::session
