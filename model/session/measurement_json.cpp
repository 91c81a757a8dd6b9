#include "model/session/measurement_json.h"

#include <array>
#include <cmath>

#include "model/base/units.h"

namespace model::session {

using nlohmann::ordered_json;

namespace {

ordered_json toJson(const MeasuredEnd& end) {
    return {{"at_nm", std::array{end.x, end.y}}, {"layer", end.layer}, {"net", end.net}, {"snap", end.snap}};
}

bool isCoordinate(const ordered_json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= base::kMaxCoordinate;
}

bool isLength(const ordered_json& value) {
    return isCoordinate(value) && value.get<double>() >= 0;
}

std::optional<MeasuredEnd> endFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json at = json.value("at_nm", ordered_json());
    const ordered_json layer = json.value("layer", ordered_json());
    const ordered_json net = json.value("net", ordered_json());
    const ordered_json snap = json.value("snap", ordered_json());
    const bool isPlace = at.is_array() && at.size() == 2 && isCoordinate(at[0]) && isCoordinate(at[1]);
    if (!isPlace || !layer.is_string() || !net.is_string() || !snap.is_string()) {
        return std::nullopt;
    }
    return MeasuredEnd{at[0].get<double>(), at[1].get<double>(), layer.get<std::string>(), net.get<std::string>(),
                       snap.get<std::string>()};
}

}  // namespace

ordered_json toJson(const Measurement& measurement) {
    return {{"name", measurement.name},
            {"step", measurement.step},
            {"from", toJson(measurement.from)},
            {"to", toJson(measurement.to)},
            {"dz_nm", measurement.dz},
            {"overlap_nm", measurement.overlap},
            {"from_edge_to_edge", measurement.isGap},
            {"shown", measurement.isShown}};
}

std::optional<Measurement> measurementFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json name = json.value("name", ordered_json());
    const ordered_json step = json.value("step", ordered_json());
    const ordered_json dz = json.value("dz_nm", ordered_json());
    const ordered_json overlap = json.value("overlap_nm", ordered_json());
    const ordered_json isGap = json.value("from_edge_to_edge", ordered_json());
    const ordered_json isShown = json.value("shown", ordered_json());
    const std::optional<MeasuredEnd> from = endFrom(json.value("from", ordered_json()));
    const std::optional<MeasuredEnd> to = endFrom(json.value("to", ordered_json()));
    if (!name.is_string() || !step.is_string() || !isLength(dz) || !isLength(overlap) || !isGap.is_boolean() ||
        !isShown.is_boolean() || !from || !to) {
        return std::nullopt;
    }
    return Measurement{
        name.get<std::string>(), step.get<std::string>(), *from, *to, dz.get<double>(), overlap.get<double>(),
        isGap.get<bool>(),       isShown.get<bool>()};
}

}  // namespace model::session
