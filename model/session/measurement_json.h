#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "model/measure/measurement.h"

/// Measurements as the session file holds them.
namespace model::session {

[[nodiscard]] nlohmann::ordered_json toJson(const Measurement& measurement);
/// Nothing if it is none.
[[nodiscard]] std::optional<Measurement> measurementFrom(const nlohmann::ordered_json& json);

}  // namespace model::session
