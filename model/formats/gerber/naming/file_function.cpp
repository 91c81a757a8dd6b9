#include <algorithm>
#include <vector>

#include "model/formats/gerber/naming/file_role.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

using Kind = FileRole::Kind;

LayerSide sideOf(std::string_view word) {
    return equalsIgnoringCase(word, "Top")                                         ? LayerSide::Top
           : equalsIgnoringCase(word, "Bot") || equalsIgnoringCase(word, "Bottom") ? LayerSide::Bottom
           : equalsIgnoringCase(word, "Inr") || equalsIgnoringCase(word, "Inner")  ? LayerSide::Inner
                                                                                   : LayerSide::None;
}

void readCopper(const std::vector<std::string_view>& fields, FileRole& role) {
    role.kind = Kind::Copper;
    role.isCountedFromTop = true;
    for (const std::string_view field : fields) {
        if (field.size() > 1 && (field[0] == 'L' || field[0] == 'l')) {
            role.order = parseInteger(field.substr(1)).value_or(role.order);
        }
        role.side = sideOf(field) != LayerSide::None ? sideOf(field) : role.side;
    }
}

void readDrill(const std::vector<std::string_view>& fields, FileRole& role) {
    const bool isRout = std::ranges::any_of(fields, [](std::string_view f) { return equalsIgnoringCase(f, "Rout"); });
    role.kind = isRout ? Kind::Rout : Kind::Drill;
    role.side = LayerSide::Through;
    role.plating = equalsIgnoringCase(fields[0], "Plated")      ? Plating::Plated
                   : equalsIgnoringCase(fields[0], "NonPlated") ? Plating::NonPlated
                                                                : Plating::NotSaid;
    if (fields.size() > 2) {
        role.spanTop = std::max(0, parseInteger(fields[1]).value_or(0));
        role.spanBottom = std::max(0, parseInteger(fields[2]).value_or(0));
    }
}

}  // namespace

std::optional<FileRole> roleOfFunction(std::string_view function) {
    const std::vector<std::string_view> fields = split(function, ',');
    const std::string name = upperCase(fields[0]);
    FileRole role;
    role.source = RoleSource::Attribute;
    role.side = fields.size() > 1 ? sideOf(fields[1]) : LayerSide::None;
    if (name == "COPPER") {
        readCopper(fields, role);
    } else if (name == "PLATED" || name == "NONPLATED" || name == "MIXEDPLATING" || name == "MIXED") {
        readDrill(fields, role);
    } else if (name == "SOLDERMASK") {
        role.kind = Kind::SolderMask;
    } else if (name == "PASTE" || name == "SOLDERPASTE") {
        role.kind = Kind::Paste;
    } else if (name == "LEGEND") {
        role.kind = Kind::Legend;
    } else if (name == "PROFILE") {
        role.kind = Kind::Profile;
    } else if (name == "GLUE") {
        role.kind = Kind::Glue;
    } else if (name == "COMPONENT") {
        role.kind = Kind::Components;
        role.side = fields.size() > 2 ? sideOf(fields[2]) : LayerSide::None;
        role.order =
            fields.size() > 1 && fields[1].starts_with('L') ? parseInteger(fields[1].substr(1)).value_or(0) : 0;
    } else if (name == "OTHER" || name == "DRILLMAP" || name == "FABRICATIONDRAWING" || name == "ARRAYDRAWING" ||
               name == "ASSEMBLYDRAWING" || name == "DRAWING" || name == "VCUT" || name == "VIATENTING" ||
               name == "VIAFILL" || name == "PEELABLEMASK" || name == "CARBONMASK" || name == "GOLDMASK" ||
               name == "SILVERMASK" || name == "TINMASK" || name == "HEATSINKMASK" || name == "DEPTHROUT" ||
               name == "PADS" || name == "OTHERDRAWING" || name == "KEEP-OUT") {
        role.kind = Kind::Document;
    } else {
        return std::nullopt;
    }
    return role;
}

std::string describe(const FileRole& role) {
    const std::string_view side = role.side == LayerSide::Top      ? "top "
                                  : role.side == LayerSide::Bottom ? "bottom "
                                  : role.side == LayerSide::Inner  ? "inner "
                                                                   : "";
    switch (role.kind) {
        case Kind::Copper:
            return std::string(side) + "copper" + (role.order > 0 ? " " + std::to_string(role.order) : "");
        case Kind::SolderMask: return std::string(side) + "solder mask";
        case Kind::Paste: return std::string(side) + "solder paste";
        case Kind::Legend: return std::string(side) + "silkscreen";
        case Kind::Profile: return "board outline";
        case Kind::Drill:
            return role.plating == Plating::NonPlated ? "NPTH drills"
                   : role.plating == Plating::Plated  ? "plated drills"
                                                      : "drills";
        case Kind::Rout: return "routed slots";
        case Kind::Components: return std::string(side) + "components";
        case Kind::Glue: return std::string(side) + "glue";
        case Kind::Ignored: return "nothing";
        default: return "a document";
    }
}

}  // namespace model::gerber
