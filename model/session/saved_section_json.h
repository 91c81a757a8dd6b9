#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "model/session/saved_section.h"

/// Kept sections as the session file holds them.
namespace model::session {

[[nodiscard]] nlohmann::ordered_json toJson(const SavedSection& section);
/// None for what is not as kept_section.h shows it, and for lines off the coordinates of boards.
[[nodiscard]] std::optional<SavedSection> sectionFrom(const nlohmann::ordered_json& json);

}  // namespace model::session
