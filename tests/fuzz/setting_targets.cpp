#include <string>

#include "model/base/assert.h"
#include "model/clearance/kicad_project_rules.h"
#include "model/clearance/kicad_rules.h"
#include "model/clearance/rule_file.h"
#include "model/clearance/waivers.h"
#include "model/formats/gerber/layer_map.h"
#include "model/formats/paper/paper_reader.h"
#include "model/session/session.h"
#include "targets.h"

/// What is understood must be the same once it was written and read again: files of settings are both.
namespace fuzz {

namespace {

constexpr const char* kFile = "input";

/// Bytes that are no UTF-8 are others once they were written; then they stay.
void checkRules(const model::RuleTable& table) {
    const std::string text = model::toJson(table);
    const auto again = model::parseRules(text);
    ASSERT(again.ok() && model::toJson(*again) == text);
}

void rules(std::string_view input) {
    if (const auto read = model::parseRules(input)) {
        checkRules(*read);
        const auto commented = model::parseRules(model::commentedJson(*read));
        ASSERT(commented.ok() && *commented == *read);
    }
}

void kicadRules(std::string_view input) {
    if (const auto read = model::parseKicadRules(input); read && !read->table.rules.empty()) {
        checkRules(read->table);
    }
}

void kicadProjectRules(std::string_view input) {
    for (const auto parse : {model::parseKicadProjectRules, model::parseKicadBoardRules}) {
        if (const auto read = parse(input); read && !read->table.rules.empty()) {
            checkRules(read->table);
        }
    }
}

void waivers(std::string_view input) {
    if (const auto read = model::parseWaivers(input)) {
        const auto again = model::parseWaivers(model::toJson(*read));
        ASSERT(again.ok() && *again == *read);
    }
}

void layerMap(std::string_view input) {
    model::Diagnostics diagnostics;
    const model::gerber::LayerMap read = model::gerber::parseLayerMap(input, kFile, diagnostics);
    const std::string text = model::gerber::layerMapText(read);
    const model::gerber::LayerMap again = model::gerber::parseLayerMap(text, kFile, diagnostics);
    ASSERT(again.rows().size() == read.rows().size());
    ASSERT(model::gerber::layerMapText(again) == text);
}

/// The board that sessions are for: two layers of copper, and the job's name is "input".
const model::Document& smallBoard() {
    static const std::shared_ptr<const model::Document> kBoard = [] {
        base::Progress progress;
        return *model::paper::readModel(
            "LAYERBEGIN\nLAYERTYPE,Top\nBASEPLANEHEIGHT,8.0\nTHICKNESS,1.2\nPOINTCOUNT,1\nSEGCOUNT,1\n"
            "LINEBEGIN\nLINEID,1\nLINEDATA,2\n0.0,0.0\nSTRAIGHT,1,20.0,100.0,0.0\nLINEEND\nLAYEREND\n",
            kFile, progress);
    }();
    return *kBoard;
}

void session(std::string_view input) {
    static_cast<void>(model::session::parseSession(input, smallBoard()));
}

}  // namespace

std::span<const Target> settingTargets() {
    static const std::vector<Target> kTargets = {
        {"kicad_project_rules", kicadProjectRules, {}, false, "kicad"},
        {"kicad_rules", kicadRules},
        {"layer_map", layerMap},
        {"rules", rules},
        {"session", session},
        {"waivers", waivers},
    };
    return kTargets;
}

}  // namespace fuzz
