#include "model/session/session_json.h"

#include <array>

namespace model::session {

const Json& partOf(const Json& file, const std::string& key) {
    static const Json kNone;
    const auto found = file.find(key);
    return found != file.end() ? *found : kNone;
}

double numberFrom(const Json& json, double low, double high) {
    require(json.is_number());
    const double number = json.get<double>();
    require(low <= number && number <= high);
    return number;
}

base::PointD pointFrom(const Json& json) {
    constexpr double kMost = base::kMaxCoordinate;
    require(json.is_array() && json.size() == 2);
    return {numberFrom(json[0], -kMost, kMost), numberFrom(json[1], -kMost, kMost)};
}

std::vector<base::PointD> lineFrom(const Json& json) {
    std::vector<base::PointD> line = listFrom(json, pointFrom);
    require(line.size() >= 2);
    return line;
}

Json lineJson(const std::vector<base::PointD>& line) {
    return listJson(line, [](base::PointD corner) { return std::array{corner.x, corner.y}; });
}

namespace {

/// No camera is farther from a board, in mm.
constexpr double kFarthest = 1e6;
/// No view is so many times as wide as high, or as high as wide.
constexpr double kLongest = 1000.0;

double poseNumber(const Json& json) {
    return numberFrom(json, -kFarthest, kFarthest);
}

Nm coordinateFrom(const Json& json) {
    require(json.is_number_integer());
    return static_cast<Nm>(numberFrom(json, -base::kMaxCoordinate, base::kMaxCoordinate));
}

std::optional<base::Point> originFrom(const Json& pose) {
    if (!pose.contains("origin_nm")) {
        return std::nullopt;
    }
    const Json& origin = pose.at("origin_nm");
    require(origin.is_array() && origin.size() == 2);
    return base::Point{coordinateFrom(origin[0]), coordinateFrom(origin[1])};
}

std::optional<double> aspectFrom(const Json& pose) {
    return pose.contains("aspect") ? std::optional(numberFrom(pose.at("aspect"), 1.0 / kLongest, kLongest))
                                   : std::nullopt;
}

Pose poseFrom(const Json& json) {
    const std::vector<double> target = listFrom(json.at("target_mm"), poseNumber);
    const double distance = poseNumber(json.at("distance_mm"));
    require(target.size() == 3 && distance > 0);
    return {{target[0], target[1], target[2]},
            distance,
            poseNumber(json.at("yaw_deg")),
            poseNumber(json.at("pitch_deg")),
            json.at("parallel").get<bool>(),
            originFrom(json),
            aspectFrom(json)};
}

Json toJson(const Pose& pose) {
    Json json{{"target_mm", pose.target},
              {"distance_mm", pose.distance},
              {"yaw_deg", pose.yawDeg},
              {"pitch_deg", pose.pitchDeg},
              {"parallel", pose.isParallel}};
    if (pose.origin) {
        json["origin_nm"] = {pose.origin->x, pose.origin->y};
    }
    if (pose.aspect) {
        json["aspect"] = *pose.aspect;
    }
    return json;
}

/// ["TOP", "line", x0, y0, x1, y1]
SavedElement elementFrom(const Json& json) {
    require(json.is_array() && json.size() == 6);
    const std::optional<ElementKind> kind = kindOf(json[1]);
    require(kind.has_value());
    const auto side = [&](std::size_t i) { return coordinateFrom(json[i]); };
    return {json[0], *kind, Box{{side(2), side(3)}, {side(4), side(5)}}};
}

/// [["pcb", "GND"]]
std::vector<NetName> netNamesFrom(const Json& json) {
    return listFrom(json, [](const Json& net) {
        require(net.is_array() && net.size() == 2);
        return NetName{net[0], net[1]};
    });
}

Json netNamesJson(const std::vector<NetName>& nets) {
    return listJson(nets, [](const NetName& net) { return Json::array({net.step, net.name}); });
}

std::vector<SavedElement> elementsFrom(const Json& json) {
    require(json.size() <= kMostSavedElements);
    return listFrom(json, elementFrom);
}

Json elementsJson(const std::vector<SavedElement>& elements) {
    return listJson(elements, [](const SavedElement& element) {
        return Json::array({element.layer, toString(element.kind), element.box.min.x, element.box.min.y,
                            element.box.max.x, element.box.max.y});
    });
}

SavedSelection selectionFrom(const Json& json) {
    return {netNamesFrom(json.at("nets")), elementsFrom(json.at("elements"))};
}

Json toJson(const SavedSelection& selection) {
    return {{"nets", netNamesJson(selection.nets)}, {"elements", elementsJson(selection.elements)}};
}

std::optional<std::uint32_t> colourAt(const Json& json) {
    if (!json.contains("colour")) {
        return std::nullopt;
    }
    const std::optional<std::uint32_t> colour = colourFrom(json.at("colour").get<std::string>());
    require(colour.has_value());
    return colour;
}

std::string stringFrom(const Json& json) {
    return json.get<std::string>();
}

LayerState layerFrom(const Json& json) {
    const Json& opacity = json.at("opacity_percent");
    require(opacity.is_number_integer());
    return {json.at("name"), json.at("visible").get<bool>(), static_cast<int>(numberFrom(opacity, 0, 100)),
            colourAt(json)};
}

Json toJson(const LayerState& layer) {
    Json json = {{"name", layer.layer}, {"visible", layer.isVisible}, {"opacity_percent", layer.opacityPercent}};
    if (layer.rgb) {
        json["colour"] = colourText(*layer.rgb);
    }
    return json;
}

}  // namespace

SavedView viewFrom(const Json& json) {
    if (json.contains("selection")) {
        return {json.at("name"), json.at("step"), {}, {}, {}, selectionFrom(json.at("selection"))};
    }
    return {json.at("name"),
            json.at("step"),
            poseFrom(json.at("flat")),
            poseFrom(json.at("solid")),
            listFrom(json.at("layers"), stringFrom),
            std::nullopt,
            json.contains("nets") ? netNamesFrom(json.at("nets")) : std::vector<NetName>(),
            json.contains("current") ? std::optional(stringFrom(json.at("current"))) : std::nullopt,
            json.contains("elements") ? elementsFrom(json.at("elements")) : std::vector<SavedElement>()};
}

Json toJson(const SavedView& view) {
    if (view.selection) {
        return {{"name", view.name}, {"step", view.step}, {"selection", toJson(*view.selection)}};
    }
    Json json{{"name", view.name},
              {"step", view.step},
              {"layers", view.layers},
              {"flat", toJson(view.flat)},
              {"solid", toJson(view.solid)}};
    if (!view.nets.empty()) {
        json["nets"] = netNamesJson(view.nets);
    }
    if (view.current) {
        json["current"] = *view.current;
    }
    if (!view.elements.empty()) {
        json["elements"] = elementsJson(view.elements);
    }
    return json;
}

SavedNet netFrom(const Json& json) {
    return {json.at("name"), json.at("step"), colourAt(json), json.contains("hidden") && json.at("hidden").get<bool>()};
}

Json toJson(const SavedNet& net) {
    Json json{{"name", net.name}, {"step", net.step}};
    if (net.colour) {
        json["colour"] = colourText(*net.colour);
    }
    if (net.isHidden) {
        json["hidden"] = true;
    }
    return json;
}

Desk deskFrom(const Json& json) {
    Desk desk{json.at("step"), poseFrom(json.at("flat")), poseFrom(json.at("solid")), json.at("unit"),
              listFrom(json.at("layers"), layerFrom)};
    require(desk.unit == "mm" || desk.unit == "mil" || desk.unit == "in");
    desk.solo = json.value("solo", std::string());
    return desk;
}

Json toJson(const Desk& desk) {
    Json json = {{"step", desk.step},
                 {"flat", toJson(desk.flat)},
                 {"solid", toJson(desk.solid)},
                 {"unit", desk.unit},
                 {"layers", listJson(desk.layers, [](const LayerState& layer) { return toJson(layer); })}};
    if (!desk.solo.empty()) {
        json["solo"] = desk.solo;
    }
    return json;
}

SectionPosition positionFrom(const Json& at, const std::string& on) {
    require(at.is_array() && at.size() == 2 && (on == "corner" || on == "upright" || on == "level"));
    return {at[0].get<double>(), at[1].get<double>(), on != "level", on != "upright"};
}

const char* edgeName(const SectionPosition& position) {
    return !position.isOnLevel ? "upright" : position.isOnUpright ? "corner" : "level";
}

SectionDimension dimensionFrom(const Json& json) {
    return {positionFrom(json.at("from_nm"), json.at("from_on")), positionFrom(json.at("to_nm"), json.at("to_on"))};
}

Json toJson(const SectionDimension& dimension) {
    const SectionPosition& from = dimension.from;
    const SectionPosition& to = dimension.to;
    return {{"from_nm", {from.along, from.z}},
            {"from_on", edgeName(from)},
            {"to_nm", {to.along, to.z}},
            {"to_on", edgeName(to)}};
}

SavedSection sectionFrom(const Json& json) {
    SavedSection section{json.at("name"), json.at("step"), lineFrom(json.at("line_nm"))};
    if (json.contains("dimensions")) {
        section.dimensions = listFrom(json.at("dimensions"), dimensionFrom);
    }
    return section;
}

Json toJson(const SavedSection& section) {
    Json json{{"name", section.name}, {"step", section.step}, {"line_nm", lineJson(section.line)}};
    if (!section.dimensions.empty()) {
        json["dimensions"] =
            listJson(section.dimensions, [](const SectionDimension& dimension) { return toJson(dimension); });
    }
    return json;
}

BoardColourChoice boardColoursFrom(const Json& json) {
    require(json.is_object());
    const auto named = [&](const char* key, auto valueNamed) {
        decltype(valueNamed("")) value;
        if (json.contains(key)) {
            value = valueNamed(json.at(key).get<std::string>());
            require(value.has_value());
        }
        return value;
    };
    return {named("solder_mask", boardColourNamed), named("silkscreen", boardColourNamed),
            named("finish", surfaceFinishNamed)};
}

Json toJson(const BoardColourChoice& chosen) {
    Json json = Json::object();
    const auto add = [&](const char* key, const std::vector<std::string>& names, const auto& value) {
        if (value) {
            json[key] = names[static_cast<std::size_t>(*value)];
        }
    };
    add("solder_mask", boardColourNames(), chosen.solderMask);
    add("silkscreen", boardColourNames(), chosen.silkscreen);
    add("finish", surfaceFinishNames(), chosen.finish);
    return json;
}

LayerSet layerSetFrom(const Json& json) {
    return {json.at("name"), listFrom(json.at("layers"), stringFrom)};
}

Json toJson(const LayerSet& set) {
    return {{"name", set.name}, {"layers", set.layers}};
}

Waiver waiverFrom(const Json& json) {
    const base::Result<std::vector<Waiver>> waivers =
        parseWaivers(Json{{"copperscope_waivers", 1}, {"waivers", Json::array({json})}}.dump());
    require(waivers.ok() && waivers->size() == 1);
    return waivers->front();
}

}  // namespace model::session
