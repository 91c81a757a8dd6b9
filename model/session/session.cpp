#include "model/session/session.h"

#include <algorithm>
#include <optional>

#include "model/base/thickness_units.h"
#include "model/board/stackup.h"
#include "model/clearance/rule_file.h"
#include "model/session/folder_lock.h"
#include "model/session/merge.h"
#include "model/session/session_json.h"
#include "model/solids/restack.h"
#include "model/text/json_reading.h"
#include "model/text/json_text.h"
#include "model/text/whole_file.h"

namespace model::session {

namespace fs = std::filesystem;

namespace {

/// What is written on its own, and so merged with what others wrote of it.
struct Part {
    const char* key;
    Unit unit;
};
constexpr Part kThicknesses{"thickness_nm", Unit::Name};
constexpr Part kViews{"views", Unit::Item};
constexpr Part kNets{"nets", Unit::Name};
constexpr Part kDesk{"desk", Unit::Whole};
constexpr Part kMeasurements{"measurements", Unit::Item};
constexpr Part kSections{"sections", Unit::Item};
constexpr Part kLayerSets{"layer_sets", Unit::Name};
constexpr Part kBoardColours{"board_colours", Unit::Name};
constexpr Part kDesignRules{"design_rules", Unit::Whole};
constexpr Part kWaivers{"waivers", Unit::Item};

base::Error cannotWrite(const fs::path& path, const std::string& why) {
    return {base::ErrorCode::OutputFailed, path.string() + " cannot be written: " + why};
}

/// The text as JSON; nothing when it is no session of this version. `problem` says why.
std::optional<Json> jsonOf(std::string_view text, std::string& problem) {
    base::Result<Json> read = model::readJson<Json>(text);
    if (!read || !read->is_object() || !read->contains(kVersionKey) || !(*read)[kVersionKey].is_number_integer()) {
        problem = "is no session of Copperscope" + (read ? std::string() : " (" + read.error().text + ")");
        return std::nullopt;
    }
    const Json& version = (*read)[kVersionKey];
    if (version.get<std::int64_t>() != kVersion) {
        problem = "is a session of version " + version.dump() + ", this Copperscope knows version " +
                  std::to_string(kVersion);
        return std::nullopt;
    }
    return *std::move(read);
}

/// What the file holds; nothing when it is missing or too large. `problem` says which.
std::optional<std::string> textIn(const fs::path& path, std::string& problem) {
    std::error_code error;
    if (!fs::exists(path, error)) {
        return std::nullopt;
    }
    base::Result<std::string> text = readWholeFile(path, base::kMostSettingBytes);
    if (!text) {
        problem = text.error().text.substr(path.string().size() + 1);
        return std::nullopt;
    }
    return *std::move(text);
}

/// Why it is not for this board; empty if it is.
std::string otherJobIn(const Json& json, const Document& document) {
    const std::string job = json.value(kJobKey, Json()).dump(-1, ' ', true);
    return job == Json(document.job.name).dump(-1, ' ', true, Json::error_handler_t::replace)
               ? ""
               : "is the session of another board, " + job;
}

/// What the file holds, nothing when it is missing. `problem` says why it must stay as it is.
Json heldBy(const fs::path& path, const Document& document, std::string& problem) {
    const std::optional<std::string> text = textIn(path, problem);
    const std::optional<Json> json = text ? jsonOf(*text, problem) : std::nullopt;
    problem = json ? otherJobIn(*json, document) : problem;
    return json.value_or(Json::object());
}

bool isThickness(const Json& value) {
    return value.is_number_integer() && value.get<std::int64_t>() >= kLeastSet && value.get<std::int64_t>() <= kMostSet;
}

void readThicknesses(const Json& json, const Stackup& stackup, LoadedSession& out) {
    if (!json.is_object()) {
        out.ignored.push_back(std::string(kThicknesses.key) + " is not a list of layers");
        return;
    }
    for (const auto& [name, value] : json.items()) {
        const StackupRow* row = findRow(stackup, name);
        if (row == nullptr) {
            out.ignored.push_back("the thickness of " + name + ": the stackup has no such layer");
        } else if (!isThickness(value)) {
            out.ignored.push_back("the thickness of " + name + ": " + value.dump(-1, ' ', true) +
                                  " is no number of nanometres from 1 µm to 10 mm");
        } else {
            setThickness(out.session.thicknesses, {row->name, value.get<Nm>()});
        }
    }
}

/// Reads a list of what the user saved, item by item.
template <class Read, class List>
void readList(const Json& json, const std::string& kind, const Read& read, List& list,
              std::vector<std::string>& ignored) {
    if (!json.is_array()) {
        ignored.push_back(kind + "s is not a list of " + kind + "s");
        return;
    }
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (auto item = tryRead(json[i], read)) {
            list.push_back(std::move(*item));
        } else {
            ignored.push_back(kind + " " + std::to_string(i + 1) + ", which is no " + kind);
        }
    }
}

void readNets(const Json& json, const Document& document, LoadedSession& out) {
    readList(json, "net", netFrom, out.session.nets, out.ignored);
    const StepTree tree = unfoldCopies(document);
    const auto found = findNets(tree, out.session.nets);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const SavedNet& net = out.session.nets[i];
        const bool isHere =
            std::ranges::any_of(tree.steps, [&](const Document* step) { return step->job.step == net.step; });
        if (!found[i] && isHere) {
            out.ignored.push_back("net " + net.name + ": step " + net.step + " has no such net");
        }
    }
}

bool hasLayer(const Document& document, const std::string& name) {
    return std::ranges::find(document.layers, name, &Layer::name) != document.layers.end();
}

/// Solder masks had other names in older versions, which layers of the job may have as well.
void renameOldMask(const Document& document, std::string& layer) {
    constexpr std::string_view kOld = " coat";
    if (layer.ends_with(kOld) && !hasLayer(document, layer)) {
        layer.replace(layer.size() - kOld.size(), kOld.size(), " solder mask");
    }
}

/// Of what lists layers by name: views and layer sets.
template <class List>
void renameOldMasks(const Document& document, List& list) {
    for (auto& item : list) {
        for (std::string& layer : item.layers) {
            renameOldMask(document, layer);
        }
    }
}

/// Layers that the board does not have are named and left out.
void readDesk(const Json& json, const Document& document, LoadedSession& out) {
    std::optional<Desk> desk = tryRead(json, deskFrom);
    if (!desk) {
        out.ignored.push_back(std::string(kDesk.key) + ", which is not what a window shows");
        return;
    }
    std::string missing;
    std::ranges::for_each(desk->layers, [&](LayerState& state) { renameOldMask(document, state.layer); });
    std::erase_if(desk->layers, [&](const LayerState& state) {
        const bool isThere = hasLayer(document, state.layer);
        missing += isThere ? "" : (missing.empty() ? "" : ", ") + state.layer;
        return !isThere;
    });
    if (!missing.empty()) {
        out.ignored.push_back("the style of layers that the board does not have: " + missing);
    }
    out.session.desk = std::move(*desk);
}

void readDesignRules(const Json& json, LoadedSession& out) {
    if (base::Result<RuleTable> rules = parseRules(jsonText(json))) {
        out.session.designRules = std::move(*rules);
    } else {
        out.ignored.push_back(std::string(kDesignRules.key) + ": " + rules.error().text);
    }
}

base::Status removeFile(const fs::path& path) {
    std::error_code error;
    fs::remove(path, error);
    return error ? base::Status(cannotWrite(path, error.message())) : base::Status(base::Done{});
}

bool holdsNothing(const Json& json) {
    return std::ranges::all_of(json.items(),
                               [](const auto& item) { return item.key() == kVersionKey || item.key() == kJobKey; });
}

const Json& partIn(const std::shared_ptr<const FileContent>& content, const char* key) {
    static const Json kEmpty = Json::object();
    return partOf(content ? content->json : kEmpty, key);
}

std::shared_ptr<const FileContent> contentOf(const char* key, Json part) {
    return std::make_shared<const FileContent>(FileContent{Json{{key, std::move(part)}}});
}

/// As it will be read again: names of a job may be no UTF-8.
Json asInFile(const Json& part) {
    return Json::parse(jsonText(part));
}

/// What to write of a part where the file has `theirs`. `known` becomes what is known of the part once that is written.
Json mergeKnown(const Part& part, const Json& mine, const Json& theirs, KnownPart& known) {
    Merged merged = merge(part.unit, partIn(known.own, part.key), mine, theirs);
    const bool isNews = theirs != partIn(known.file, part.key);
    known = {contentOf(part.key, mine), contentOf(part.key, merged.part), merged.hasTheirs && isNews,
             merged.replacesTheirs};
    return std::move(merged.part);
}

base::Status writeSession(const fs::path& path, const Json& json) {
    if (holdsNothing(json)) {
        return removeFile(path);
    }
    const std::string text = jsonText(json);
    if (text.size() > base::kMostSettingBytes) {
        return cannotWrite(path, "it would be larger than a session may be");
    }
    return writeWholeFile(path, text);
}

/// Sets one part of the file, or removes it when it is null.
base::Status savePart(const fs::path& board, const Document& document, const Part& part, const Json& value,
                      KnownPart* known) {
    const fs::path path = sessionPath(board);
    const FolderLock lock(path.parent_path());
    if (!lock.isHeld()) {
        return cannotWrite(path, "another program writes it, and does not end");
    }
    std::string problem;
    Json json = heldBy(path, document, problem);
    if (!problem.empty()) {
        return cannotWrite(path, "the file there " + problem);
    }
    KnownPart next = known != nullptr ? *known : KnownPart{};
    const Json mine = asInFile(value);
    const Json merged = known != nullptr ? mergeKnown(part, mine, partOf(json, part.key), next) : mine;
    json[kVersionKey] = kVersion;
    json[kJobKey] = document.job.name;
    json.erase(part.key);
    if (!merged.is_null()) {
        json[part.key] = merged;
    }
    RETURN_IF_ERROR(writeSession(path, json));
    if (known != nullptr) {
        next.file = std::make_shared<const FileContent>(FileContent{std::move(json)});  // for otherNews: all parts
        *known = std::move(next);
    }
    return base::Done{};
}

template <class List>
base::Status saveList(const fs::path& board, const Document& document, const Part& part, const List& list,
                      KnownPart* known) {
    return savePart(board, document, part,
                    list.empty() ? Json() : listJson(list, [](const auto& item) { return toJson(item); }), known);
}

}  // namespace

fs::path sessionPath(const fs::path& board) {
    std::error_code noWorkingFolder;
    fs::path path = fs::absolute(board, noWorkingFolder);
    path = (noWorkingFolder ? board : path).lexically_normal();
    path = path.has_filename() ? path : path.parent_path();
    return path.string() + ".copperscope.json";
}

LoadedSession loadSession(const fs::path& board, const Document& document) {
    const fs::path path = sessionPath(board);
    std::string problem;
    const std::optional<std::string> text = textIn(path, problem);
    LoadedSession out = text ? parseSession(*text, document) : LoadedSession{};
    if (!problem.empty()) {
        out.ignored.push_back("it " + problem + "; it is ignored");
    }
    for (std::string& ignored : out.ignored) {
        ignored = path.string() + ": " + ignored;
    }
    return out;
}

LoadedSession parseSession(std::string_view text, const Document& document) {
    LoadedSession out;
    std::string problem;
    const std::optional<Json> json = jsonOf(text, problem);
    if (!json) {
        out.ignored.push_back("it " + problem + "; it is ignored");
        return out;
    }
    out.file = std::make_shared<const FileContent>(FileContent{*json});
    if (problem = otherJobIn(*json, document); !problem.empty()) {
        out.ignored.push_back("it " + problem + "; it is ignored");
        return out;
    }
    for (const auto& [key, value] : json->items()) {
        if (key == kThicknesses.key) {
            readThicknesses(value, document.stackup, out);
        } else if (key == kViews.key) {
            readList(value, "view", viewFrom, out.session.views, out.ignored);
            renameOldMasks(document, out.session.views);
        } else if (key == kNets.key) {
            readNets(value, document, out);
        } else if (key == kDesk.key) {
            readDesk(value, document, out);
        } else if (key == kMeasurements.key) {
            readList(value, "measurement", measurementFrom, out.session.measurements, out.ignored);
        } else if (key == kSections.key) {
            readList(value, "section", sectionFrom, out.session.sections, out.ignored);
        } else if (key == kLayerSets.key) {
            readList(value, "layer set", layerSetFrom, out.session.layerSets, out.ignored);
            renameOldMasks(document, out.session.layerSets);
        } else if (key == kBoardColours.key) {
            if (const auto chosen = tryRead(value, boardColoursFrom)) {
                out.session.boardColours = *chosen;
            } else {
                out.ignored.push_back(std::string(kBoardColours.key) + ", which are no colours of a board");
            }
        } else if (key == kDesignRules.key) {
            readDesignRules(value, out);
        } else if (key == kWaivers.key) {
            readList(value, "waiver", waiverFrom, out.session.waivers, out.ignored);
        } else if (key != kVersionKey && key != kJobKey) {
            out.ignored.push_back("\"" + key + "\" is not known");
        }
    }
    for (std::string& ignored : out.ignored) {
        ignored = "ignored " + ignored;
    }
    return out;
}

base::Status saveThicknesses(const fs::path& board, const Document& document,
                             const std::vector<ThicknessOverride>& thicknesses, KnownPart* known) {
    Json json;
    for (const ThicknessOverride& set : thicknesses) {
        json[set.layer] = set.thickness;
    }
    return savePart(board, document, kThicknesses, json, known);
}

base::Status saveViews(const fs::path& board, const Document& document, const std::vector<SavedView>& views,
                       KnownPart* known) {
    return saveList(board, document, kViews, views, known);
}

base::Status saveNets(const fs::path& board, const Document& document, const std::vector<SavedNet>& nets,
                      KnownPart* known) {
    return saveList(board, document, kNets, nets, known);
}

base::Status saveDesk(const fs::path& board, const Document& document, const Desk& desk, KnownPart* known) {
    return savePart(board, document, kDesk, toJson(desk), known);
}

base::Status saveMeasurements(const fs::path& board, const Document& document,
                              const std::vector<Measurement>& measurements, KnownPart* known) {
    return saveList(board, document, kMeasurements, measurements, known);
}

base::Status saveSections(const fs::path& board, const Document& document, const std::vector<SavedSection>& sections,
                          KnownPart* known) {
    return saveList(board, document, kSections, sections, known);
}

base::Status saveLayerSets(const fs::path& board, const Document& document, const std::vector<LayerSet>& sets,
                           KnownPart* known) {
    return saveList(board, document, kLayerSets, sets, known);
}

base::Status saveBoardColours(const fs::path& board, const Document& document, const BoardColourChoice& chosen,
                              KnownPart* known) {
    return savePart(board, document, kBoardColours, chosen == BoardColourChoice{} ? Json() : toJson(chosen), known);
}

base::Status saveDesignRules(const fs::path& board, const Document& document, const std::optional<RuleTable>& rules,
                             KnownPart* known) {
    return savePart(board, document, kDesignRules, rules ? Json::parse(toJson(*rules)) : Json(), known);
}

base::Status saveWaivers(const fs::path& board, const Document& document, const std::vector<Waiver>& waivers,
                         KnownPart* known) {
    return savePart(board, document, kWaivers, waivers.empty() ? Json() : Json::parse(toJson(waivers))["waivers"],
                    known);
}

std::shared_ptr<const Document> applyThicknesses(std::shared_ptr<const Document> document,
                                                 const std::vector<ThicknessOverride>& thicknesses) {
    return thicknesses == document->stackup.facts.set ? document : restack(*document, thicknesses);
}

void setThickness(std::vector<ThicknessOverride>& list, const ThicknessOverride& change) {
    std::erase_if(list, [&](const ThicknessOverride& set) { return set.layer == change.layer; });
    if (change.thickness > 0) {
        list.push_back(change);
    }
}

}  // namespace model::session
