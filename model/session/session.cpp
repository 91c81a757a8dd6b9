#include "model/session/session.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <thread>

#include "model/base/thickness_units.h"
#include "model/board/stackup.h"
#include "model/clearance/rule_file.h"
#include "model/session/session_json.h"
#include "model/solids/restack.h"
#include "model/text/json_reading.h"
#include "model/text/json_text.h"
#include "model/text/whole_file.h"

namespace model::session {

namespace fs = std::filesystem;

namespace {

constexpr const char* kVersionKey = "copperscope_session";
constexpr const char* kJobKey = "job";
constexpr const char* kThicknessKey = "thickness_nm";
constexpr const char* kViewsKey = "views";
constexpr const char* kNetsKey = "nets";
constexpr const char* kDeskKey = "desk";
constexpr const char* kMeasurementsKey = "measurements";
constexpr const char* kSectionsKey = "sections";
constexpr const char* kLayerSetsKey = "layer_sets";
constexpr const char* kBoardColoursKey = "board_colours";
constexpr const char* kDesignRulesKey = "design_rules";
constexpr const char* kWaiversKey = "waivers";
/// Writing a session takes milliseconds.
constexpr int kLockTries = 1000;
constexpr std::chrono::milliseconds kLockPause{2};

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

bool isThickness(const Json& value) {
    return value.is_number_integer() && value.get<std::int64_t>() >= kLeastSet && value.get<std::int64_t>() <= kMostSet;
}

void readThicknesses(const Json& json, const Stackup& stackup, LoadedSession& out) {
    if (!json.is_object()) {
        out.ignored.push_back(std::string(kThicknessKey) + " is not a list of layers");
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

/// Layers that the board does not have are named and left out.
void readDesk(const Json& json, const Document& document, LoadedSession& out) {
    std::optional<Desk> desk = tryRead(json, deskFrom);
    if (!desk) {
        out.ignored.push_back(std::string(kDeskKey) + ", which is not what a window shows");
        return;
    }
    std::string missing;
    std::erase_if(desk->layers, [&](const LayerState& state) {
        const bool isThere = std::ranges::find(document.layers, state.layer, &Layer::name) != document.layers.end();
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
        out.ignored.push_back(std::string(kDesignRulesKey) + ": " + rules.error().text);
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

/// While it lives, no other program changes a session in this folder: reading a file, changing a part and writing it
/// again must not mix with the same of others. The folder is locked, because files in it are replaced. A file system
/// without locks is taken as one without other programs.
class FolderLock {
public:
    explicit FolderLock(const fs::path& folder) : m_folder(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
        m_isHeld = m_folder < 0 || take();
        for (int i = 0; i < kLockTries && !m_isHeld; ++i) {
            std::this_thread::sleep_for(kLockPause);
            m_isHeld = take();
        }
    }
    ~FolderLock() {
        if (m_folder >= 0) {
            ::close(m_folder);
        }
    }
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// False: somebody keeps it for longer than writing a session takes.
    [[nodiscard]] bool isHeld() const { return m_isHeld; }

private:
    [[nodiscard]] bool take() const {
        return ::flock(m_folder, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR);
    }

    int m_folder;
    bool m_isHeld = false;
};

/// Sets one part of the file, or removes it when it is null.
base::Status savePart(const fs::path& board, const Document& document, const char* key, const Json& part) {
    const fs::path path = sessionPath(board);
    const FolderLock lock(path.parent_path());
    if (!lock.isHeld()) {
        return cannotWrite(path, "another program writes it, and does not end");
    }
    std::string problem;
    const std::optional<std::string> before = textIn(path, problem);
    Json json = before ? jsonOf(*before, problem).value_or(Json::object()) : Json::object();
    if (!problem.empty()) {
        return cannotWrite(path, "the file there " + problem);
    }
    json[kVersionKey] = kVersion;
    json[kJobKey] = document.job.name;
    json.erase(key);
    if (!part.is_null()) {
        json[key] = part;
    }
    if (holdsNothing(json)) {
        return removeFile(path);
    }
    const std::string text = jsonText(json);
    if (text.size() > base::kMostSettingBytes) {
        return cannotWrite(path, "it would be larger than a session may be");
    }
    return writeWholeFile(path, text);
}

template <class List>
base::Status saveList(const fs::path& board, const Document& document, const char* key, const List& list) {
    return savePart(board, document, key,
                    list.empty() ? Json() : listJson(list, [](const auto& item) { return toJson(item); }));
}

}  // namespace

fs::path sessionPath(const fs::path& board) {
    fs::path path = fs::absolute(board).lexically_normal();
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
    const std::string job = json->value(kJobKey, Json()).dump(-1, ' ', true);
    if (job != Json(document.job.name).dump(-1, ' ', true, Json::error_handler_t::replace)) {
        out.ignored.push_back("it is the session of another board, " + job + "; it is ignored");
        return out;
    }
    for (const auto& [key, value] : json->items()) {
        if (key == kThicknessKey) {
            readThicknesses(value, document.stackup, out);
        } else if (key == kViewsKey) {
            readList(value, "view", viewFrom, out.session.views, out.ignored);
        } else if (key == kNetsKey) {
            readNets(value, document, out);
        } else if (key == kDeskKey) {
            readDesk(value, document, out);
        } else if (key == kMeasurementsKey) {
            readList(value, "measurement", measurementFrom, out.session.measurements, out.ignored);
        } else if (key == kSectionsKey) {
            readList(value, "section", sectionFrom, out.session.sections, out.ignored);
        } else if (key == kLayerSetsKey) {
            readList(value, "layer set", layerSetFrom, out.session.layerSets, out.ignored);
        } else if (key == kBoardColoursKey) {
            if (const auto chosen = tryRead(value, boardColoursFrom)) {
                out.session.boardColours = *chosen;
            } else {
                out.ignored.push_back(std::string(kBoardColoursKey) + ", which are no colours of a board");
            }
        } else if (key == kDesignRulesKey) {
            readDesignRules(value, out);
        } else if (key == kWaiversKey) {
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
                             const std::vector<ThicknessOverride>& thicknesses) {
    Json json;
    for (const ThicknessOverride& set : thicknesses) {
        json[set.layer] = set.thickness;
    }
    return savePart(board, document, kThicknessKey, json);
}

base::Status saveViews(const fs::path& board, const Document& document, const std::vector<SavedView>& views) {
    return saveList(board, document, kViewsKey, views);
}

base::Status saveNets(const fs::path& board, const Document& document, const std::vector<SavedNet>& nets) {
    return saveList(board, document, kNetsKey, nets);
}

base::Status saveDesk(const fs::path& board, const Document& document, const Desk& desk) {
    return savePart(board, document, kDeskKey, toJson(desk));
}

base::Status saveMeasurements(const fs::path& board, const Document& document,
                              const std::vector<Measurement>& measurements) {
    return saveList(board, document, kMeasurementsKey, measurements);
}

base::Status saveSections(const fs::path& board, const Document& document, const std::vector<SavedSection>& sections) {
    return saveList(board, document, kSectionsKey, sections);
}

base::Status saveLayerSets(const fs::path& board, const Document& document, const std::vector<LayerSet>& sets) {
    return saveList(board, document, kLayerSetsKey, sets);
}

base::Status saveBoardColours(const fs::path& board, const Document& document, const BoardColourChoice& chosen) {
    return savePart(board, document, kBoardColoursKey, chosen == BoardColourChoice{} ? Json() : toJson(chosen));
}

base::Status saveDesignRules(const fs::path& board, const Document& document, const std::optional<RuleTable>& rules) {
    return savePart(board, document, kDesignRulesKey, rules ? Json::parse(toJson(*rules)) : Json());
}

base::Status saveWaivers(const fs::path& board, const Document& document, const std::vector<Waiver>& waivers) {
    return savePart(board, document, kWaiversKey, waivers.empty() ? Json() : Json::parse(toJson(waivers))["waivers"]);
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
