#include "model/formats/kicad/project.h"

#include <nlohmann/json.hpp>

#include "model/formats/kicad/text/values.h"
#include "model/text/json_reading.h"
#include "model/text/wildcard.h"

namespace model::kicad {

namespace {

using nlohmann::json;

/// Of KiCad 9 a net may have several classes; the first one counts most.
std::string classNameOf(const json& value) {
    return value.is_array() && !value.empty() ? stringOf(value.front()) : stringOf(value);
}

}  // namespace

std::string Project::classOf(std::string_view net) const {
    const std::string plain = nameOf(net);
    const auto found = classOfNet.find(plain);
    if (found != classOfNet.end()) {
        return found->second;
    }
    for (const auto& [pattern, name] : classPatterns) {
        if (fitsWildcard(plain, pattern)) {
            return name;
        }
    }
    return "Default";
}

Project readProject(std::string_view text, std::string_view file, Diagnostics& diagnostics) {
    Project project;
    const base::Result<json> read = readJson<json>(text);
    const json root = read ? *read : json();
    if (!root.is_object()) {
        diagnostics.report(Severity::Warning, file, 0,
                           "the project beside the board is not used, so text variables and net classes are missing: " +
                               (read ? "it holds no object" : read.error().text));
        return project;
    }
    for (const auto& [name, value] : memberOf(root, "text_variables").items()) {
        project.variables[name] = stringOf(value);
    }
    const json& nets = memberOf(root, "net_settings");
    for (const auto& [net, value] : memberOf(nets, "netclass_assignments").items()) {
        const std::string name = classNameOf(value);
        if (!name.empty()) {
            project.classOfNet[nameOf(net)] = name;
        }
    }
    for (const json& pattern : memberOf(nets, "netclass_patterns")) {
        const std::string name = stringOf(memberOf(pattern, "netclass"));
        if (!name.empty()) {
            project.classPatterns.emplace_back(nameOf(stringOf(memberOf(pattern, "pattern"))), name);
        }
    }
    for (const json& netClass : memberOf(nets, "classes")) {  // KiCad 6
        for (const json& net : memberOf(netClass, "nets")) {
            const std::string name = stringOf(memberOf(netClass, "name"));
            if (!name.empty() && name != "Default") {
                project.classOfNet[nameOf(stringOf(net))] = name;
            }
        }
    }
    return project;
}

}  // namespace model::kicad
