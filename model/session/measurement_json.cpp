#include <array>
#include <limits>

#include "model/session/session_json.h"

namespace model::session {

namespace {

Json toJson(const MeasuredEnd& end) {
    Json json = {{"at_nm", std::array{end.x, end.y}}, {"layer", end.layer}, {"net", end.net}, {"snap", end.snap}};
    if (!end.item.empty()) {
        json["item"] = end.item;
    }
    return json;
}

MeasuredEnd endFrom(const Json& json) {
    const base::PointD at = pointFrom(json.at("at_nm"));
    return {at.x, at.y, json.at("layer"), json.at("net"), json.at("snap"), json.value("item", std::string())};
}

Json toJson(const MeasuredRun& run) {
    return {{"layer", run.layer}, {"length_nm", run.length}, {"line_nm", lineJson(run.line)}};
}

/// Lengths add up over many legs: they are not bounded as coordinates are.
double sumFrom(const Json& json) {
    return numberFrom(json, 0.0, std::numeric_limits<double>::infinity());
}

MeasuredRun runFrom(const Json& json) {
    return {json.at("layer"), sumFrom(json.at("length_nm")), lineFrom(json.at("line_nm"))};
}

Json toJson(const MeasuredPath& path) {
    return {{"runs", listJson(path.runs, [](const MeasuredRun& run) { return toJson(run); })},
            {"holes", path.holeCount},
            {"hole_height_nm", path.holeHeight}};
}

MeasuredPath pathFrom(const Json& json) {
    require(json.at("holes").is_number_unsigned());
    return {listFrom(json.at("runs"), runFrom), json.at("holes"), sumFrom(json.at("hole_height_nm"))};
}

/// A field that older versions wrote under another name.
const Json& fieldOf(const Json& json, const char* name, const char* oldName) {
    return json.at(json.contains(name) ? name : oldName);
}

}  // namespace

Json toJson(const Measurement& measurement) {
    Json json = {
        {"name", measurement.name},          {"step", measurement.step},     {"kind", toString(measurement.kind)},
        {"from", toJson(measurement.from)},  {"to", toJson(measurement.to)}, {"dz_nm", measurement.dz},
        {"overlap_nm", measurement.overlap}, {"notes", measurement.notes},   {"shown", measurement.isShown}};
    if (measurement.corner) {
        json["corner"] = toJson(*measurement.corner);
    }
    if (measurement.isPlanar) {
        json["planar"] = true;
    }
    if (measurement.path) {
        json["path"] = toJson(*measurement.path);
    }
    return json;
}

Measurement measurementFrom(const Json& json) {
    const std::optional<MeasurementKind> kind = kindNamed(json.at("kind"));
    require(kind.has_value());
    Measurement measurement{json.at("name"),
                            json.at("step"),
                            *kind,
                            endFrom(json.at("from")),
                            endFrom(json.at("to")),
                            numberFrom(json.at("dz_nm"), 0.0, base::kMaxCoordinate),
                            numberFrom(json.at("overlap_nm"), 0.0, base::kMaxCoordinate),
                            {},
                            {},
                            fieldOf(json, "notes", "remarks"),
                            json.at("shown").get<bool>(),
                            json.value("planar", false)};
    if (kind == MeasurementKind::Angle) {
        measurement.corner = endFrom(json.at("corner"));
    } else if (kind == MeasurementKind::Length) {
        measurement.path = pathFrom(fieldOf(json, "path", "way"));
    }
    return measurement;
}

}  // namespace model::session
