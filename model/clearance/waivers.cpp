#include "model/clearance/waivers.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/base/units.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"
#include "model/text/strict_json.h"
#include "model/text/whole_file.h"

namespace model {

namespace {

using Json = StrictJson::Json;

constexpr const char* kVersionKey = "copperscope_waivers";
constexpr std::array<const char*, kFindingReasonCount> kFaults = {"too-close",   "pad-removed", "no-pad",  "too-narrow",
                                                                  "acute-angle", "floating",    "too-deep"};
constexpr double kMostNm = 1U << 30U;  ///< of coordinates and distances

bool areNear(Point a, Point b) {
    return std::hypot(double{1} * a.x - b.x, double{1} * a.y - b.y) <= static_cast<double>(kWaiverReach);
}

Point rounded(PointD p) {
    return {static_cast<Nm>(std::lround(p.x)), static_cast<Nm>(std::lround(p.y))};
}

std::string textOf(const WaivedSide& side) {
    return side.net + (side.pin.empty() ? "" : ", " + side.pin) + (side.kind.empty() ? "" : ", " + side.kind);
}

bool isNumber(const Json& json) {
    return json.is_number() && std::abs(json.get<double>()) <= kMostNm;
}

bool isDate(const std::string& text) {
    int year = 0;
    int month = 0;
    int day = 0;
    int length = 0;
    constexpr int kDays[] = {31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return text.size() == 10 && std::sscanf(text.c_str(), "%4d-%2d-%2d%n", &year, &month, &day, &length) == 3 &&
           length == 10 && month >= 1 && month <= 12 && day >= 1 && day <= kDays[month - 1];
}

bool isBlank(const std::string& text) {
    return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

/// Reads the keys of one waiver, and keeps the first error.
class Reader {
public:
    Reader(const StrictJson& file, const Json& json, std::size_t row)
        : m_file(file), m_json(json), m_path("/waivers/" + std::to_string(row)), m_row(row) {}

    [[nodiscard]] base::Result<Waiver> read() {
        constexpr const char* kKeys[] = {"kind",        "fault",    "step",  "layer",  "from_nm", "to_nm",
                                         "distance_nm", "depth_nm", "sides", "reason", "author",  "date"};
        if (!m_json.is_object()) {
            return m_file.bad(where("") + " is no object");
        }
        RETURN_IF_ERROR(m_file.checkKeys(m_json, m_path, kKeys));
        Waiver waiver;
        readKind(waiver);
        waiver.step = text("step");
        waiver.layer = text("layer");
        waiver.from = point("from_nm");
        waiver.to = point("to_nm");
        readDistance(waiver);
        readDepth(waiver);
        readSides(waiver);
        waiver.reason = text("reason");
        waiver.author = text("author");
        waiver.date = text("date");
        if (!isDate(waiver.date)) {
            refuse("date", "is a day like 2026-11-23");
        }
        return m_error ? base::Result<Waiver>(*m_error) : waiver;
    }
    [[nodiscard]] std::string where(const std::string& key) const {
        return m_file.lineOf(key.empty() ? m_path : m_path + '/' + key) + ", waiver " + std::to_string(m_row + 1);
    }

private:
    void refuse(const std::string& key, const std::string& why) {
        if (!m_error) {
            m_error = m_file.bad(where(key) + ": \"" + key + "\" " + why);
        }
    }
    [[nodiscard]] Json value(const char* key) const { return m_json.value(key, Json()); }

    std::string text(const char* key) {
        const Json json = value(key);
        const std::string text = json.is_string() ? json.get<std::string>() : std::string();
        if (isBlank(text)) {
            refuse(key, json.is_string() ? "must not be empty" : "must be a text");
        }
        return text;
    }
    Point point(const char* key) {
        const Json json = value(key);
        if (!json.is_array() || json.size() != 2 || !isNumber(json[0]) || !isNumber(json[1])) {
            refuse(key, "must be two numbers of nanometres");
            return {};
        }
        return rounded({json[0].get<double>(), json[1].get<double>()});
    }
    void readKind(Waiver& waiver) {
        const std::string kind = text("kind");
        const std::optional<RuleKind> known = ruleKindOf(kind);
        if (!known) {
            refuse("kind", "is no kind of rule: \"" + kind + "\"");
        }
        waiver.kind = known.value_or(RuleKind::CopperToCopper);
        const Json fault = m_json.value("fault", Json(kFaults[0]));
        const auto* const found = std::ranges::find_if(kFaults, [&](const char* name) { return fault == name; });
        if (found == kFaults.end()) {
            refuse("fault", "is too-close, pad-removed, no-pad, too-narrow, acute-angle, floating or too-deep, not " +
                                fault.dump());
            return;
        }
        waiver.fault = static_cast<FindingReason>(found - std::begin(kFaults));
    }
    void readDistance(Waiver& waiver) {
        const Json json = value("distance_nm");
        if (!isNumber(json) || json.get<double>() < 0) {
            refuse("distance_nm", "must be a number of nanometres from 0");
            return;
        }
        waiver.distance = json.get<double>();
    }
    void readDepth(Waiver& waiver) {
        const Json json = value("depth_nm");
        const bool isDeep = isNumber(json) && json.get<double>() > 0;
        if (waiver.fault == FindingReason::TooDeep ? !isDeep : !json.is_null()) {
            refuse("depth_nm", "is a number of nanometres above 0, of a fault too-deep");
            return;
        }
        waiver.depth = isDeep ? json.get<double>() : 0.0;
    }
    void readSides(Waiver& waiver) {
        const Json json = value("sides");
        if (!json.is_array() || json.size() != 2) {
            refuse("sides", "names both sides");
            return;
        }
        for (std::size_t i = 0; i < 2; ++i) {
            readSide(json[i], "sides/" + std::to_string(i), waiver.sides[i]);
        }
    }
    void readSide(const Json& json, const std::string& key, WaivedSide& side) {
        constexpr const char* kKeys[] = {"net", "pin", "kind"};
        if (!json.is_object() || !json.contains("net")) {
            refuse(key, "needs a \"net\"");
            return;
        }
        if (const base::Status known = m_file.checkKeys(json, m_path + '/' + key, kKeys); !known && !m_error) {
            m_error = known.error();
        }
        std::string* const parts[] = {&side.net, &side.pin, &side.kind};
        for (std::size_t i = 0; i < 3; ++i) {
            const Json part = json.value(kKeys[i], Json(""));
            if (!part.is_string()) {
                refuse(key + '/' + kKeys[i], "must be a text");
                return;
            }
            *parts[i] = part;
        }
    }

    const StrictJson& m_file;
    const Json& m_json;
    std::string m_path;
    std::size_t m_row;
    std::optional<base::Error> m_error;
};

Json jsonOf(const WaivedSide& side) {
    Json json{{"net", side.net}};
    if (!side.pin.empty()) {
        json["pin"] = side.pin;
    }
    if (!side.kind.empty()) {
        json["kind"] = side.kind;
    }
    return json;
}

Json jsonOf(const Waiver& waiver) {
    Json json{{"kind", nameOf(waiver.kind)}};
    if (waiver.fault != FindingReason::TooClose) {
        json["fault"] = kFaults[static_cast<std::size_t>(waiver.fault)];
    }
    json["step"] = waiver.step;
    json["layer"] = waiver.layer;
    json["from_nm"] = {waiver.from.x, waiver.from.y};
    json["to_nm"] = {waiver.to.x, waiver.to.y};
    json["distance_nm"] = waiver.distance;
    if (waiver.fault == FindingReason::TooDeep) {
        json["depth_nm"] = waiver.depth;
    }
    json["sides"] = {jsonOf(waiver.sides[0]), jsonOf(waiver.sides[1])};
    json["reason"] = waiver.reason;
    json["author"] = waiver.author;
    json["date"] = waiver.date;
    return json;
}

}  // namespace

Waiver waiverOf(const Document& step, const SideNames& names, const RuleTable& table, const RuleFinding& finding,
                const Waiver& said) {
    Waiver waiver = said;
    waiver.kind = table.rules[finding.rule].kind;
    waiver.fault = finding.reason;
    waiver.step = step.job.step;
    waiver.layer = step.layer(finding.layer).name;
    waiver.from = rounded(finding.spacing.from);
    waiver.to = rounded(finding.spacing.to);
    waiver.distance = std::round(finding.spacing.distance * 10) / 10;  // nm; more digits say nothing
    waiver.depth = finding.depth;
    const auto [a, b] = names.of(finding);
    waiver.sides = {WaivedSide{a.net, a.pin, a.kind}, WaivedSide{b.net, b.pin, b.kind}};
    return waiver;
}

bool areOfOnePlace(const Waiver& a, const Waiver& b) {
    const bool isSameFault = a.kind == b.kind && a.fault == b.fault && a.step == b.step && a.layer == b.layer;
    return isSameFault &&
           ((areNear(a.from, b.from) && areNear(a.to, b.to)) || (areNear(a.from, b.to) && areNear(a.to, b.from)));
}

std::string placeOf(const Waiver& waiver) {
    return std::string(nameOf(waiver.kind)) + " on " + waiver.layer +
           formatted(" at (%.4f, %.4f) mm, %.3f um, ", base::toMm(waiver.from.x), base::toMm(waiver.from.y),
                     waiver.distance / base::kNmPerUm) +
           textOf(waiver.sides[0]) + " and " + textOf(waiver.sides[1]);
}

std::string reasonOf(const Waiver& waiver) {
    return waiver.reason + " (" + waiver.author + ", " + waiver.date + ")";
}

base::Result<std::vector<Waiver>> parseWaivers(std::string_view text) {
    ASSIGN_OR_RETURN(const StrictJson file, StrictJson::parse(text, "waivers", kVersionKey));
    constexpr const char* kKeys[] = {kVersionKey, "waivers"};
    RETURN_IF_ERROR(file.checkKeys(file.json(), "", kKeys));
    const Json list = file.json().value("waivers", Json());
    if (!list.is_array()) {
        return file.bad("\"waivers\" must be a list");
    }
    std::vector<Waiver> waivers;
    for (const Json& json : list) {
        Reader reader(file, json, waivers.size());
        ASSIGN_OR_RETURN(Waiver waiver, reader.read());
        const auto same = std::ranges::find_if(waivers, [&](const Waiver& w) { return areOfOnePlace(w, waiver); });
        if (same != waivers.end()) {
            return file.bad(reader.where("from_nm") + ": \"from_nm\" is the location of waiver " +
                            std::to_string(same - waivers.begin() + 1) + " again");
        }
        waivers.push_back(std::move(waiver));
    }
    return waivers;
}

std::string toJson(std::span<const Waiver> waivers) {
    Json list = Json::array();
    for (const Waiver& waiver : waivers) {
        list.push_back(jsonOf(waiver));
    }
    return jsonText({{kVersionKey, 1}, {"waivers", list}});
}

base::Result<std::vector<Waiver>> readWaivers(const std::filesystem::path& path) {
    ASSIGN_OR_RETURN(const std::string text, readWholeFile(path, base::kMostSettingBytes));
    return parseWaivers(text);
}

}  // namespace model
