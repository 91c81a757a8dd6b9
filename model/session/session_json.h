#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "model/session/session.h"

/// Parts of a session as JSON and back. What is not as session.h shows it is none.
namespace model::session {

[[nodiscard]] std::optional<SavedView> viewFrom(const nlohmann::ordered_json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const SavedView& view);
[[nodiscard]] std::optional<Desk> deskFrom(const nlohmann::ordered_json& json);
[[nodiscard]] nlohmann::ordered_json jsonOf(const Desk& desk);

}  // namespace model::session
