#include "model/session/session_json.h"

#include <algorithm>
#include <cmath>

namespace model::session {

using nlohmann::ordered_json;

namespace {

/// No camera is farther from a board, in mm.
constexpr double kFarthest = 1e6;

bool isText(const ordered_json& value) {
    return value.is_string();
}

bool isNumber(const ordered_json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= kFarthest;
}

std::optional<Pose> poseFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json target = json.value("target_mm", ordered_json());
    const ordered_json distance = json.value("distance_mm", ordered_json());
    const ordered_json yaw = json.value("yaw_deg", ordered_json());
    const ordered_json pitch = json.value("pitch_deg", ordered_json());
    const ordered_json parallel = json.value("parallel", ordered_json());
    const bool isPose = target.is_array() && target.size() == 3 && std::ranges::all_of(target, isNumber) &&
                        isNumber(distance) && distance.get<double>() > 0 && isNumber(yaw) && isNumber(pitch) &&
                        parallel.is_boolean();
    if (!isPose) {
        return std::nullopt;
    }
    return Pose{{target[0].get<double>(), target[1].get<double>(), target[2].get<double>()},
                distance.get<double>(),
                yaw.get<double>(),
                pitch.get<double>(),
                parallel.get<bool>()};
}

ordered_json jsonOf(const Pose& pose) {
    return {{"target_mm", pose.target},
            {"distance_mm", pose.distance},
            {"yaw_deg", pose.yawDeg},
            {"pitch_deg", pose.pitchDeg},
            {"parallel", pose.isParallel}};
}

/// ["TOP", "line", x0, y0, x1, y1]
std::optional<SavedElement> elementFrom(const ordered_json& json) {
    if (!json.is_array() || json.size() != 6 || !json[0].is_string() || !json[1].is_string()) {
        return std::nullopt;
    }
    const std::optional<ElementKind> kind = kindOf(json[1].get<std::string>());
    std::array<Nm, 4> sides{};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const ordered_json& side = json[i + 2];
        if (!side.is_number_integer() || std::abs(side.get<double>()) > double{base::kMaxCoordinate}) {
            return std::nullopt;
        }
        sides[i] = side.get<Nm>();
    }
    if (!kind) {
        return std::nullopt;
    }
    return SavedElement{json[0].get<std::string>(), *kind, Box{{sides[0], sides[1]}, {sides[2], sides[3]}}};
}

std::optional<SavedSelection> selectionFrom(const ordered_json& json) {
    const ordered_json nets = json.is_object() ? json.value("nets", ordered_json()) : ordered_json();
    const ordered_json elements = json.is_object() ? json.value("elements", ordered_json()) : ordered_json();
    if (!nets.is_array() || !elements.is_array() || elements.size() > kMostSavedElements) {
        return std::nullopt;
    }
    SavedSelection selection;
    for (const ordered_json& net : nets) {
        if (!net.is_array() || net.size() != 2 || !std::ranges::all_of(net, isText)) {
            return std::nullopt;
        }
        selection.nets.push_back({net[0].get<std::string>(), net[1].get<std::string>()});
    }
    for (const ordered_json& each : elements) {
        std::optional<SavedElement> element = elementFrom(each);
        if (!element) {
            return std::nullopt;
        }
        selection.elements.push_back(std::move(*element));
    }
    return selection;
}

ordered_json jsonOf(const SavedSelection& selection) {
    ordered_json nets = ordered_json::array();
    for (const NetName& net : selection.nets) {
        nets.push_back(ordered_json::array({net.step, net.name}));
    }
    ordered_json elements = ordered_json::array();
    for (const SavedElement& element : selection.elements) {
        elements.push_back(ordered_json::array({element.layer, kindWord(element.kind), element.box.min.x,
                                                element.box.min.y, element.box.max.x, element.box.max.y}));
    }
    return {{"nets", nets}, {"elements", elements}};
}

std::optional<LayerState> layerFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json name = json.value("name", ordered_json());
    const ordered_json visible = json.value("visible", ordered_json());
    const ordered_json opacity = json.value("opacity_percent", ordered_json());
    const bool hasColour = json.contains("colour");
    const std::optional<std::uint32_t> rgb =
        hasColour && json["colour"].is_string() ? colourFrom(json["colour"].get<std::string>()) : std::nullopt;
    const bool isOpacity = opacity.is_number_integer() && opacity >= 0 && opacity <= 100;
    if (!name.is_string() || !visible.is_boolean() || !isOpacity || (hasColour && !rgb)) {
        return std::nullopt;
    }
    return LayerState{name.get<std::string>(), visible.get<bool>(), opacity.get<int>(), rgb};
}

ordered_json jsonOf(const LayerState& layer) {
    ordered_json json = {
        {"name", layer.layer}, {"visible", layer.isVisible}, {"opacity_percent", layer.opacityPercent}};
    if (layer.rgb) {
        json["colour"] = colourText(*layer.rgb);
    }
    return json;
}

}  // namespace

std::optional<SavedView> viewFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json name = json.value("name", ordered_json());
    const ordered_json step = json.value("step", ordered_json());
    if (name.is_string() && step.is_string() && json.contains("selection")) {
        std::optional<SavedSelection> selection = selectionFrom(json["selection"]);
        return selection ? std::optional(SavedView{name, step, {}, {}, {}, std::move(selection)}) : std::nullopt;
    }
    const ordered_json layers = json.value("layers", ordered_json());
    const std::optional<Pose> flat = poseFrom(json.value("flat", ordered_json()));
    const std::optional<Pose> solid = poseFrom(json.value("solid", ordered_json()));
    if (!name.is_string() || !step.is_string() || !layers.is_array() || !std::ranges::all_of(layers, isText) || !flat ||
        !solid) {
        return std::nullopt;
    }
    return SavedView{name.get<std::string>(),
                     step.get<std::string>(),
                     *flat,
                     *solid,
                     layers.get<std::vector<std::string>>(),
                     std::nullopt};
}

ordered_json jsonOf(const SavedView& view) {
    if (view.selection) {
        return {{"name", view.name}, {"step", view.step}, {"selection", jsonOf(*view.selection)}};
    }
    return {{"name", view.name},
            {"step", view.step},
            {"layers", view.layers},
            {"flat", jsonOf(view.flat)},
            {"solid", jsonOf(view.solid)}};
}

std::optional<Desk> deskFrom(const ordered_json& json) {
    if (!json.is_object()) {
        return std::nullopt;
    }
    const ordered_json step = json.value("step", ordered_json());
    const ordered_json unit = json.value("unit", ordered_json());
    const ordered_json layers = json.value("layers", ordered_json());
    const std::optional<Pose> flat = poseFrom(json.value("flat", ordered_json()));
    const std::optional<Pose> solid = poseFrom(json.value("solid", ordered_json()));
    const bool isUnit = unit == "mm" || unit == "mil" || unit == "in";
    if (!step.is_string() || !isUnit || !layers.is_array() || !flat || !solid) {
        return std::nullopt;
    }
    Desk desk{step, *flat, *solid, unit, {}};
    for (const ordered_json& each : layers) {
        std::optional<LayerState> layer = layerFrom(each);
        if (!layer) {
            return std::nullopt;
        }
        desk.layers.push_back(std::move(*layer));
    }
    return desk;
}

ordered_json jsonOf(const Desk& desk) {
    ordered_json layers = ordered_json::array();
    for (const LayerState& layer : desk.layers) {
        layers.push_back(jsonOf(layer));
    }
    return {{"step", desk.step},
            {"flat", jsonOf(desk.flat)},
            {"solid", jsonOf(desk.solid)},
            {"unit", desk.unit},
            {"layers", layers}};
}

}  // namespace model::session
