#include "model/formats/gerber/job_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "model/base/ascii.h"
#include "model/base/units.h"
#include "model/formats/common/archive.h"
#include "model/formats/gerber/image/image.h"
#include "model/formats/gerber/text/words.h"
#include "model/text/json_reading.h"

namespace model::gerber {

namespace {

using Json = nlohmann::json;

std::string text(const Json& object, const char* key) {
    return stringOf(memberOf(object, key));
}

std::optional<double> number(const Json& object, const char* key) {
    const Json& value = memberOf(object, key);
    return value.is_number() && std::isfinite(value.get<double>()) ? std::optional(value.get<double>()) : std::nullopt;
}

std::optional<double> millimetres(const Json& object, const char* key) {
    const std::optional<double> value = number(object, key);
    return value && *value > 0 && *value < 1000 ? std::optional(*value * base::kNmPerMm) : std::nullopt;
}

JobStackRow stackRow(const Json& json) {
    JobStackRow row;
    row.type = text(json, "Type");
    row.name = text(json, "Name");
    row.thicknessNm = millimetres(json, "Thickness");
    row.material.name = text(json, "Material");
    row.material.dielectricConstant = number(json, "DielectricConstant");
    row.material.lossTangent = number(json, "LossTangent");
    const std::string colour = text(json, "Color");
    const bool isColoured = equalsIgnoringCase(row.type, "SolderMask") || equalsIgnoringCase(row.type, "Legend");
    if (isColoured && !colour.empty()) {  // as other formats say it, "Liquid Ink, Green"
        row.material.name += (row.material.name.empty() ? "" : ", ") + colour;
    }
    return row;
}

void readFiles(const Json& files, JobFileFacts& facts) {
    for (const Json& file : files.is_array() ? files : Json::array()) {
        std::string path = text(file, "Path");
        path = base::lowerCase(path.substr(path.find_last_of("/\\") + 1));
        facts.functions[path] = text(file, "FileFunction");
        facts.polarities[path] = text(file, "FilePolarity");
    }
}

/// KiCad and the specification write GeneralSpecs, Fusion Overall.
JobFileFacts factsOf(const Json& json) {
    JobFileFacts facts;
    const Json& software = memberOf(memberOf(json, "Header"), "GenerationSoftware");
    for (const char* key : {"Vendor", "Application", "Version"}) {
        const std::string part = text(software, key);
        facts.generator += (facts.generator.empty() || part.empty() ? "" : " ") + part;
    }
    const Json& specs =
        memberOf(json, "GeneralSpecs").is_object() ? memberOf(json, "GeneralSpecs") : memberOf(json, "Overall");
    facts.name = text(memberOf(specs, "ProjectId"), "Name");
    facts.name = facts.name.empty() ? text(memberOf(specs, "Name"), "ProjectId") : facts.name;
    facts.boardNm = millimetres(specs, "BoardThickness");
    readFiles(memberOf(json, "FilesAttributes"), facts);
    const Json& stackup = memberOf(json, "MaterialStackup");
    for (const Json& row : stackup.is_array() ? stackup : Json::array()) {
        facts.stackup.push_back(stackRow(row));
    }
    return facts;
}

/// Eagle 9: %TJ.B_Thickness,1.57*%.
JobFileFacts readGerber(std::string_view source, std::string_view path) {
    const Image image = parseImage(source, path);
    JobFileFacts facts;
    const bool isInch = source.find("MOIN") != std::string_view::npos;
    facts.generator = image.fileAttribute(".GenerationSoftware");
    for (const auto& [name, value] : image.jobAttributes) {
        if (name == ".B_Thickness") {
            const double mm = parseReal(value).value_or(0.0) * (isInch ? 25.4 : 1.0);
            facts.boardNm = mm > 0 && mm < 1000 ? std::optional(mm * base::kNmPerMm) : std::nullopt;
        } else if (name == ".B_ID") {
            facts.name = value;
        }
    }
    return facts;
}

}  // namespace

bool looksLikeJobFile(std::string_view source) {
    const std::string_view begin = trimmed(source.substr(0, 4096));
    return (begin.starts_with('{') && (source.find("\"FilesAttributes\"") != std::string_view::npos ||
                                       source.find("\"GeneralSpecs\"") != std::string_view::npos ||
                                       source.find("\"MaterialStackup\"") != std::string_view::npos ||
                                       source.find("\"Overall\"") != std::string_view::npos)) ||
           begin.find("TF.FileFunction,JobInfo") != std::string_view::npos;
}

JobFileFacts parseJobFile(std::string_view source, std::string_view path, Diagnostics& diagnostics) {
    if (!trimmed(source).starts_with('{')) {
        return readGerber(source, path);
    }
    const base::Result<Json> json = model::readJson<Json>(source);
    if (!json) {
        diagnostics.report(Severity::Warning, path, 0, "the job file is not used: " + json.error().text);
        return {};
    }
    return factsOf(*json);
}

}  // namespace model::gerber
