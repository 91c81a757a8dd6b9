#include "model/session/measurement_json.h"

#include <algorithm>
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

bool isPlace(const ordered_json& value) {
    return value.is_array() && value.size() == 2 && isCoordinate(value[0]) && isCoordinate(value[1]);
}

std::optional<MeasuredEnd> endFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json at = json.value("at_nm", ordered_json());
    const ordered_json layer = json.value("layer", ordered_json());
    const ordered_json net = json.value("net", ordered_json());
    const ordered_json snap = json.value("snap", ordered_json());
    if (!isPlace(at) || !layer.is_string() || !net.is_string() || !snap.is_string()) {
        return std::nullopt;
    }
    return MeasuredEnd{at[0].get<double>(), at[1].get<double>(), layer.get<std::string>(), net.get<std::string>(),
                       snap.get<std::string>()};
}

ordered_json toJson(const MeasuredPath& way) {
    ordered_json runs = ordered_json::array();
    for (const MeasuredRun& run : way.runs) {
        ordered_json line = ordered_json::array();
        for (const base::PointD& corner : run.line) {
            line.push_back(std::array{corner.x, corner.y});
        }
        runs.push_back({{"layer", run.layer}, {"length_nm", run.length}, {"line_nm", std::move(line)}});
    }
    return {{"runs", std::move(runs)}, {"holes", way.holeCount}, {"hole_height_nm", way.holeHeight}};
}

/// Lengths add up over many legs: they are not bounded as coordinates are.
bool isSum(const ordered_json& value) {
    return value.is_number() && value.get<double>() >= 0;
}

std::optional<MeasuredRun> runFrom(const ordered_json& json) {
    const ordered_json layer = json.is_object() ? json.value("layer", ordered_json()) : ordered_json();
    const ordered_json length = json.is_object() ? json.value("length_nm", ordered_json()) : ordered_json();
    const ordered_json line = json.is_object() ? json.value("line_nm", ordered_json()) : ordered_json();
    if (!layer.is_string() || !isSum(length) || !line.is_array() || line.size() < 2) {
        return std::nullopt;
    }
    MeasuredRun run{layer.get<std::string>(), length.get<double>(), {}};
    for (const ordered_json& corner : line) {
        if (!isPlace(corner)) {
            return std::nullopt;
        }
        run.line.push_back({corner[0].get<double>(), corner[1].get<double>()});
    }
    return run;
}

std::optional<MeasuredPath> pathFrom(const ordered_json& json) {
    const ordered_json runs = json.is_object() ? json.value("runs", ordered_json()) : ordered_json();
    const ordered_json holes = json.is_object() ? json.value("holes", ordered_json()) : ordered_json();
    const ordered_json height = json.is_object() ? json.value("hole_height_nm", ordered_json()) : ordered_json();
    if (!runs.is_array() || !holes.is_number_unsigned() || !isSum(height)) {
        return std::nullopt;
    }
    MeasuredPath way{{}, holes.get<std::size_t>(), height.get<double>()};
    for (const ordered_json& one : runs) {
        std::optional<MeasuredRun> run = runFrom(one);
        if (!run) {
            return std::nullopt;
        }
        way.runs.push_back(std::move(*run));
    }
    return way;
}

std::optional<std::vector<std::string>> textsFrom(const ordered_json& json) {
    const auto isText = [](const ordered_json& value) { return value.is_string(); };
    return json.is_array() && std::ranges::all_of(json, isText) ? std::optional(json.get<std::vector<std::string>>())
                                                                : std::nullopt;
}

/// What only some kinds have. False if it is missing, or is none.
bool readParts(const ordered_json& json, Measurement& measurement) {
    if (measurement.kind == MeasurementKind::Angle) {
        measurement.corner = endFrom(json.value("corner", ordered_json()));
        return measurement.corner.has_value();
    }
    if (measurement.kind == MeasurementKind::Length) {
        measurement.way = pathFrom(json.value("way", ordered_json()));
        return measurement.way.has_value();
    }
    return true;
}

}  // namespace

ordered_json toJson(const Measurement& measurement) {
    ordered_json json = {
        {"name", measurement.name},          {"step", measurement.step},     {"kind", toString(measurement.kind)},
        {"from", toJson(measurement.from)},  {"to", toJson(measurement.to)}, {"dz_nm", measurement.dz},
        {"overlap_nm", measurement.overlap}, {"remarks", measurement.notes}, {"shown", measurement.isShown}};
    if (measurement.corner) {
        json["corner"] = toJson(*measurement.corner);
    }
    if (measurement.way) {
        json["way"] = toJson(*measurement.way);
    }
    return json;
}

std::optional<Measurement> measurementFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json name = json.value("name", ordered_json());
    const ordered_json step = json.value("step", ordered_json());
    const ordered_json kindName = json.value("kind", ordered_json());
    const ordered_json dz = json.value("dz_nm", ordered_json());
    const ordered_json overlap = json.value("overlap_nm", ordered_json());
    const ordered_json isShown = json.value("shown", ordered_json());
    const auto kind = kindName.is_string() ? kindNamed(kindName.get<std::string>()) : std::nullopt;
    const auto from = endFrom(json.value("from", ordered_json()));
    const auto to = endFrom(json.value("to", ordered_json()));
    const auto notes = textsFrom(json.value("remarks", ordered_json()));
    if (!name.is_string() || !step.is_string() || !kind || !isLength(dz) || !isLength(overlap) ||
        !isShown.is_boolean() || !from || !to || !notes) {
        return std::nullopt;
    }
    Measurement measurement{name.get<std::string>(), step.get<std::string>(), *kind, *from, *to,
                            dz.get<double>(),        overlap.get<double>(),   {},    {},    *notes,
                            isShown.get<bool>()};
    return readParts(json, measurement) ? std::optional(std::move(measurement)) : std::nullopt;
}

}  // namespace model::session
