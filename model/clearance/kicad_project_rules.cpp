#include "model/clearance/kicad_project_rules.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "model/base/ascii.h"
#include "model/base/thickness_units.h"
#include "model/base/units.h"
#include "model/clearance/kicad_rules.h"
#include "model/clearance/rule_choice.h"
#include "model/text/formatting.h"
#include "model/text/json_lines.h"
#include "model/text/json_reading.h"
#include "model/text/s_expression.h"
#include "model/text/utf8.h"
#include "model/text/whole_file.h"
#include "model/text/wildcard.h"

namespace model {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What a project calls a minimum, what we do, and the check that it can ignore.
struct Minimum {
    const char* word;
    RuleKind kind;
    const char* check;
    HoleClass holes = HoleClass::Any;  ///< to KiCad slots are holes too, and microvias no through holes
};
constexpr const char* kThroughHole = "min_through_hole_diameter";
constexpr const char* kDrill = "drill_out_of_range";
constexpr Minimum kMinimums[] = {
    {"min_hole_clearance", RuleKind::CopperToHole, "hole_clearance"},
    {"min_copper_edge_clearance", RuleKind::CopperToEdge, "copper_edge_clearance"},
    {"min_hole_to_hole", RuleKind::HoleToHole, "hole_to_hole"},
    {"min_via_annular_width", RuleKind::AnnularRing, "annular_width"},
    {"min_track_width", RuleKind::TrackWidth, "track_width"},
    {"min_silk_clearance", RuleKind::SilkToPad, "silk_overlap"},
    {"solder_mask_to_copper_clearance", RuleKind::MaskToForeign, "solder_mask_bridge"},
    {kThroughHole, RuleKind::HoleSize, kDrill, HoleClass::Plated},
    {kThroughHole, RuleKind::HoleSize, kDrill, HoleClass::NonPlated},
    {kThroughHole, RuleKind::SlotWidth, kDrill},
    {"min_microvia_drill", RuleKind::HoleSize, "microvia_drill_out_of_range", HoleClass::Microvia}};

/// Minimums without a counterpart.
constexpr const char* kOthers[] = {"min_connection",  "min_groove_width",   "min_microvia_diameter",
                                   "min_text_height", "min_text_thickness", "min_via_diameter"};

/// The check that a rule is made for; empty if a project has no word for it.
const char* checkOf(const Rule& rule) {
    if (rule.kind == RuleKind::CopperToCopper || rule.kind == RuleKind::Creepage) {
        return rule.kind == RuleKind::Creepage ? "creepage" : "clearance";
    }
    const auto isOfKind = [&](const Minimum& one) { return one.kind == rule.kind; };
    const auto isOwn = [&](const Minimum& one) { return isOfKind(one) && one.holes == rule.holes[0]; };
    const auto* own = std::ranges::find_if(kMinimums, isOwn);
    own = own != std::end(kMinimums) ? own : std::ranges::find_if(kMinimums, isOfKind);
    return own != std::end(kMinimums) ? own->check : "";
}

constexpr const char* kDefaultClass = "Default";

/// Millimetres of a file; none for what is no length a rule can have.
std::optional<Nm> lengthOf(double millimetres) {
    const double nm = std::round(millimetres * base::kNmPerMm);
    return nm >= 0.0 && nm <= static_cast<double>(kMostLeast) ? std::optional(static_cast<Nm>(nm)) : std::nullopt;
}

std::optional<Nm> lengthOf(const json& value) {
    return value.is_number() ? lengthOf(value.get<double>()) : std::nullopt;
}

LeftOutRule inLine(std::size_t line, const std::string& what) {
    return {what + " is left out", static_cast<std::uint32_t>(line)};
}

/// A net class as both kinds of files have it.
struct ClassOfNets {
    std::string name;
    std::optional<Nm> clearance;
    std::vector<std::string> nets;
};

bool isThere(const std::vector<ClassOfNets>& classes, const std::string& name) {
    return std::ranges::find(classes, name, &ClassOfNets::name) != classes.end();
}

/// Clearances between classes, so that the last rule that fits is the one that holds: of two classes the larger one.
/// Classes without nets ask for nothing.
void addClearances(std::vector<ClassOfNets> classes, Nm least, bool isOn, RuleTable& table) {
    Nm common = least;
    for (const ClassOfNets& one : classes) {
        common = one.name == kDefaultClass && one.clearance ? std::max(least, *one.clearance) : common;
    }
    const auto add = [&](Nm length, const std::string& a, const std::string& b) {
        if (length > 0) {
            table.rules.push_back({RuleKind::CopperToCopper, length, {a, b}, isOn});
        }
    };
    add(common, "", "");
    std::erase_if(classes, [](const ClassOfNets& one) {
        return one.name == kDefaultClass || !one.clearance || one.nets.empty();
    });
    std::ranges::stable_sort(classes, {}, [](const ClassOfNets& one) { return *one.clearance; });
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const Nm own = std::max(least, *classes[i].clearance);
        if (own > common) {
            add(own, classes[i].name, "");
        } else if (own < common) {  // less than the rest asks for, so only among themselves
            for (std::size_t k = 0; k <= i; ++k) {
                add(own, classes[k].name, classes[i].name);
            }
        }
    }
}

std::string tooMany(const std::string& netClass) {
    return "net class " + netClass + ", of which there are too many, is left out";
}

/// As many as a table may have; those with a clearance of their own come first.
void addClasses(std::vector<ClassOfNets>& classes, RuleFile& file) {
    const auto hasClearance = [](const ClassOfNets& one) { return one.clearance.has_value(); };
    std::stable_partition(classes.begin(), classes.end(), hasClearance);
    std::size_t kept = 0;
    for (ClassOfNets& one : classes) {
        if (one.name == kDefaultClass) {
            continue;
        }
        if (kept == kMostNetClasses) {
            file.leftOut.push_back({tooMany(one.name)});
            one.clearance.reset();
            continue;
        }
        ++kept;
        file.table.classes.push_back({one.name, one.nets});
    }
}

/// Of a project file.
class ProjectImporter {
public:
    ProjectImporter(const json& root, std::string_view text)
        : m_lines(text),
          m_design(memberOf(memberOf(root, "board"), "design_settings")),
          m_nets(memberOf(root, "net_settings")) {}

    RuleFile run() {
        readClasses();
        assignNets();
        addClasses(m_classes, m_file);
        const json& least = memberOf(memberOf(m_design, "rules"), "min_clearance");
        const std::optional<Nm> clearance = lengthOf(least);
        if (!clearance && !least.is_null()) {
            leaveOut(kRules + "min_clearance", "min_clearance, which is no length,");
        }
        addClearances(m_classes, clearance.value_or(0), !isIgnored("clearance"), m_file.table);
        addMinimums();
        m_file.isOfKicad = true;
        return std::move(m_file);
    }

private:
    void leaveOut(const std::string& path, const std::string& what) {
        m_file.leftOut.push_back(inLine(m_lines.of(path), what));
    }

    [[nodiscard]] bool isIgnored(const char* check) const {
        return stringOf(memberOf(memberOf(m_design, "rule_severities"), check)) == "ignore";
    }

    void readClasses() {
        std::size_t row = 0;
        for (const json& one : memberOf(m_nets, "classes")) {
            const std::string path = "/net_settings/classes/" + std::to_string(row++);
            const std::string name = stringOf(memberOf(one, "name"));
            const json& clearance = memberOf(one, "clearance");
            if (name.empty() || isThere(m_classes, name)) {
                leaveOut(path, "a net class without a name of its own");
                continue;
            }
            m_classes.push_back({name, lengthOf(clearance), {}});
            if (!m_classes.back().clearance && !clearance.is_null()) {
                leaveOut(path + "/clearance", "the clearance of net class " + name + ", which is no length,");
            }
            for (const json& net : memberOf(one, "nets")) {  // KiCad 6
                addNet(name, stringOf(net));
            }
        }
    }

    void addNet(const std::string& name, const std::string& net) {
        const auto found = std::ranges::find(m_classes, name, &ClassOfNets::name);
        if (found != m_classes.end() && !net.empty()) {
            found->nets.push_back(net);
        }
    }

    /// Nets named one by one, and those that fit patterns. A net may be in several classes.
    void assignNets() {
        for (const auto& [net, value] : memberOf(m_nets, "netclass_assignments").items()) {
            addNet(stringOf(value), net);  // KiCad 7 and 8
            for (const json& name : value.is_array() ? value : json::array()) {
                addNet(stringOf(name), net);
            }
        }
        for (const json& pattern : memberOf(m_nets, "netclass_patterns")) {
            addNet(stringOf(memberOf(pattern, "netclass")), stringOf(memberOf(pattern, "pattern")));
        }
    }

    void addMinimums() {
        const json& rules = memberOf(m_design, "rules");
        std::set<std::string> unread;
        for (const Minimum& minimum : kMinimums) {
            const json& value = memberOf(rules, minimum.word);
            const std::optional<Nm> least = lengthOf(value);
            if (least && *least > 0) {
                m_file.table.rules.push_back({minimum.kind, *least, {}, !isIgnored(minimum.check), {minimum.holes}});
            } else if (!least && !value.is_null() && unread.insert(minimum.word).second) {
                leaveOut(kRules + minimum.word, std::string(minimum.word) + ", which is no length,");
            }
        }
        for (const char* word : kOthers) {
            const json& value = memberOf(rules, word);
            if (value.is_number() && value.get<double>() > 0.0) {
                leaveOut(kRules + word, word);
            }
        }
    }

    const std::string kRules = "/board/design_settings/rules/";
    JsonLines m_lines;
    const json& m_design;
    const json& m_nets;
    std::vector<ClassOfNets> m_classes;
    RuleFile m_file;
};

/// Does a list with this head begin there?
bool beginsList(std::string_view text, std::string_view head) {
    return text.size() > head.size() + 1 && text.substr(1, head.size()) == head &&
           std::string_view(" \n)").find(text[head.size() + 1]) != std::string_view::npos;
}

/// The lists with this head of a board, up to its first part; each with its line.
std::vector<std::pair<std::string_view, std::size_t>> listsOf(std::string_view board, std::string_view head) {
    struct Open {
        std::size_t begin = 0;
        std::size_t line = 0;
        std::size_t depth = 0;
    };
    const std::string_view before = board.substr(0, board.find("\n  (module "));
    std::vector<std::pair<std::string_view, std::size_t>> lists;
    std::vector<Open> open;
    std::size_t line = 1;
    std::size_t depth = 0;
    bool isText = false;
    for (std::size_t at = 0; at < before.size(); ++at) {
        const char c = before[at];
        line += c == '\n' ? 1 : 0;
        isText = c == '"' ? !isText : isText;
        at += c == '\\' && isText ? 1 : 0;
        if (c == '(' && !isText) {
            ++depth;
            if (beginsList(before.substr(at), head)) {
                open.push_back({at, line, depth});
            }
        } else if (c == ')' && !isText && depth > 0) {
            if (!open.empty() && open.back().depth == depth) {
                lists.emplace_back(before.substr(open.back().begin, at + 1 - open.back().begin), open.back().line);
                open.pop_back();
            }
            --depth;
        }
    }
    return lists;
}

/// A length of a list, "(clearance 0.2)".
std::optional<Nm> lengthIn(const SExpression& list, const char* head) {
    const SExpression* item = list.find(head);
    if (item == nullptr) {
        return {};
    }
    const auto length = parseLength(item->at(1) + "mm");
    return length && *length >= 0 && *length <= kMostLeast ? std::optional(*length) : std::nullopt;
}

/// Of one of the files of a project.
struct FileOfProject {
    RuleFile rules;
    std::optional<base::Error> damage;  ///< why there are none
};

/// None if it is not there.
std::optional<FileOfProject> readFile(const fs::path& path, base::Result<RuleFile> (*parse)(std::string_view),
                                      std::uint64_t most = base::kMostSettingBytes) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return {};
    }
    const base::Result<std::string> text = readWholeFile(path, most);
    base::Result<RuleFile> file = text ? parse(*text) : base::Result<RuleFile>(text.error());
    if (!file) {
        FileOfProject damaged;
        damaged.damage = base::Error{file.error().code, path.string() + ": " + file.error().text};
        damaged.rules.isOfKicad = true;
        damaged.rules.leftOut.push_back({"it cannot be read and is left out: " + file.error().text, 0, path});
        return damaged;
    }
    for (LeftOutRule& one : file->leftOut) {
        one.file = path;
    }
    for (std::string& one : file->unused) {
        one = path.filename().string() + ", " + one;
    }
    return FileOfProject{std::move(*file), {}};
}

/// Is it of KiCad 4 or 5, by the first lines?
bool isOldBoard(const fs::path& board) {
    std::ifstream file(board, std::ios::binary);
    std::string head(200, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    const std::string version = "(version ";
    const std::size_t at = head.find(version);
    const std::string digits = at == std::string::npos ? "" : head.substr(at + version.size(), 9);
    const std::size_t count = std::min(digits.find_first_not_of("0123456789"), digits.size());
    return head.find("(kicad_pcb") != std::string::npos && count > 0 && (count < 8 || digits.substr(0, 4) < "2020");
}

/// A class of custom rules with the nets of those that KiCad takes its name for: small and capital letters are alike
/// to it, * stands for any text and ? for any letter.
NetClass withNetsOf(const std::vector<NetClass>& classes, NetClass one) {
    for (const NetClass& known : classes) {
        if (fitsWildcard(base::lowerCase(known.name), base::lowerCase(one.name))) {
            one.nets.insert(one.nets.end(), known.nets.begin(), known.nets.end());
        }
    }
    return one;
}

/// Adds rules that go before those that are there, with what they say of net classes that are there already.
void append(RuleFile& file, RuleFile others, const fs::path& from) {
    const std::vector<NetClass> classes = file.table.classes;
    std::ranges::move(others.table.rules, std::back_inserter(file.table.rules));
    std::ranges::move(others.leftOut, std::back_inserter(file.leftOut));
    std::ranges::move(others.unused, std::back_inserter(file.unused));
    for (NetClass& one : others.table.classes) {
        const bool isNew = std::ranges::find(file.table.classes, one.name, &NetClass::name) == file.table.classes.end();
        if (isNew) {
            file.table.classes.push_back(withNetsOf(classes, std::move(one)));
        }
    }
    leaveOutExcessClasses(file, from);
}

/// Of boards of KiCad 4 and 5: `(net_class NAME "" (clearance 0.2) … (add_net GND))`.
ClassOfNets classFrom(const SExpression& list) {
    ClassOfNets one{list.at(1), lengthIn(list, "clearance"), {}};
    for (const SExpression& item : list.items) {
        if (item.head() == "add_net") {
            one.nets.push_back(item.at(1));
        }
    }
    return one;
}

/// Of a board of KiCad 4 or 5 its own, of others those of the project beside it. A .kicad_pro beside an old board is
/// what a newer KiCad made of it without saving the board: KiCad goes by the board until that is saved, too.
std::optional<FileOfProject> boardAndProject(const fs::path& board) {
    const fs::path project = fs::path(board).replace_extension(".kicad_pro");
    std::optional<FileOfProject> own =
        isOldBoard(board) ? readFile(board, parseKicadBoardRules, base::kMostFileBytes) : std::nullopt;
    if (!own || (!own->damage && own->rules.table.rules.empty())) {
        std::optional<FileOfProject> beside = readFile(project, parseKicadProjectRules);
        return beside ? std::move(beside) : std::move(own);
    }
    std::error_code error;
    if (fs::is_regular_file(project, error)) {
        own->rules.unused.push_back(project.filename().string() +
                                    ": the board is of KiCad 4 or 5 and holds its rules itself; these are not used");
    }
    return own;
}

void leaveOutOwnClearances(FileOfProject& project, const fs::path& board) {
    const Rule& common = project.rules.table.rules.front();
    const Nm least = common.kind == RuleKind::CopperToCopper && common.classes[0].empty() ? common.least : 0;
    const base::Result<std::string> text = readWholeFile(board);
    if (std::optional<LeftOutRule> own = text ? clearancesOfItems(*text, least) : std::nullopt) {
        own->file = board;
        project.rules.leftOut.push_back(std::move(*own));
    }
}

/// Custom rules of checks that the project ignores are off: KiCad makes such a check for no rule.
void switchOffIgnored(RuleFile& custom, const fs::path& project) {
    const base::Result<std::string> text = readWholeFile(project, base::kMostSettingBytes);
    const base::Result<json> read = text ? readJson<json>(*text) : base::Result<json>(text.error());
    const json root = read ? *read : json();
    const json& severities = memberOf(memberOf(memberOf(root, "board"), "design_settings"), "rule_severities");
    for (Rule& rule : custom.table.rules) {
        rule.isOn = rule.isOn && stringOf(memberOf(severities, checkOf(rule))) != "ignore";
    }
}

/// What lies beside a board, or an older one holds itself, as one.
std::optional<FileOfProject> projectOf(const fs::path& board) {
    if (board.extension() != ".kicad_pcb") {
        return {};
    }
    const auto beside = [&](const char* extension) { return fs::path(board).replace_extension(extension); };
    std::optional<FileOfProject> project = boardAndProject(board);
    if (project && !project->rules.table.rules.empty()) {
        leaveOutOwnClearances(*project, board);
    }
    std::optional<FileOfProject> custom = readFile(beside(".kicad_dru"), parseKicadRules);
    if (!custom) {
        return project;
    }
    if (!project) {
        project.emplace().rules.leftOut.push_back(
            {"without a .kicad_pro beside it, the rules of the project are left out", 0, beside(".kicad_dru")});
        project->rules.isOfKicad = true;
    }
    switchOffIgnored(custom->rules, beside(".kicad_pro"));
    append(project->rules, std::move(custom->rules), beside(".kicad_dru"));
    project->damage = project->damage ? project->damage : custom->damage;
    return project;
}

}  // namespace

base::Result<RuleFile> parseKicadProjectRules(std::string_view text) {
    const base::Result<json> root = readJson<json>(text);
    if (!root || !root->is_object()) {
        return base::Error{base::ErrorCode::BadInput, "the rules cannot be used: this is no project of KiCad (" +
                                                          (root ? "it holds no object" : root.error().text) + ")"};
    }
    return ProjectImporter(*root, text).run();
}

base::Result<RuleFile> parseKicadBoardRules(std::string_view board) {
    RuleFile file;
    std::vector<ClassOfNets> classes;
    for (const auto& [text, line] : listsOf(board, "net_class")) {
        const base::Result<SExpression> all = parseSExpressions(text);
        if (!all || all->items.empty()) {
            file.leftOut.push_back(inLine(line, "a net class that cannot be read"));
            continue;
        }
        const SExpression& list = all->items.front();
        if (!isUtf8(list.at(1))) {  // rules are saved as JSON, which knows no other text
            file.leftOut.push_back(inLine(line, "a net class whose name is no UTF-8"));
            continue;
        }
        if (list.at(1).empty() || isThere(classes, list.at(1))) {
            file.leftOut.push_back(inLine(line, "a net class without a name of its own"));
            continue;
        }
        classes.push_back(classFrom(list));
        if (!classes.back().clearance) {
            file.leftOut.push_back(inLine(line, "the clearance of net class " + list.at(1) + ", which is no length,"));
        }
    }
    addClasses(classes, file);
    addClearances(classes, 0, true, file.table);
    for (const auto& [text, line] : listsOf(board, "setup")) {
        const base::Result<SExpression> all = parseSExpressions(text);
        const std::optional<Nm> least =
            all && !all->items.empty() ? lengthIn(all->items.front(), "trace_min") : std::nullopt;
        if (least && *least > 0) {
            file.table.rules.push_back({RuleKind::TrackWidth, *least, {}});
        }
    }
    file.isOfKicad = true;
    return file;
}

std::optional<RuleFile> kicadRulesOf(const fs::path& board) {
    std::optional<FileOfProject> all = projectOf(board);
    return all ? std::optional(std::move(all->rules)) : std::nullopt;
}

base::Result<RuleFile> readKicadRulesOf(const fs::path& board) {
    std::optional<FileOfProject> all = projectOf(board);
    if (!all) {
        return base::Error{base::ErrorCode::BadInput,
                           "the rules cannot be used: this board has no project of KiCad with rules beside it"};
    }
    if (all->damage) {
        return *all->damage;
    }
    return std::move(all->rules);
}

std::optional<RuleFile> kicadRulesFor(const fs::path& path, const Document& board) {
    std::optional<RuleFile> file = kicadRulesOf(path);
    if (file) {
        leaveOutUnusedClasses(*file, board);
    }
    return file;
}

namespace {

/// "[PN]", but not "[3]", which names of nets have.
bool hasSetOfLetters(std::string_view pattern) {
    const std::size_t open = pattern.find('[');
    const std::size_t close = pattern.find(']', std::min(open, pattern.size()));
    return close != std::string_view::npos &&
           pattern.substr(open + 1, close - open - 1).find_first_not_of("0123456789") != std::string_view::npos;
}

/// KiCad takes each pattern for a regular expression too. Is it one rather than the name of a net of another board?
bool looksLikeRegularExpression(std::string_view pattern) {
    constexpr std::string_view kMarks[] = {".*", ".+", "|", "\\"};
    return pattern.starts_with('^') || pattern.ends_with('$') || hasSetOfLetters(pattern) ||
           std::ranges::any_of(kMarks, [&](std::string_view mark) { return pattern.find(mark) != pattern.npos; });
}

bool fitsAnyNet(const Document& board, std::string_view pattern) {
    return std::ranges::any_of(board.nets, [&](const Net& net) { return fitsWildcard(net.name, pattern); });
}

/// Names the patterns of classes that may fit nets in a way that is not read. The classes that have them.
std::set<std::string> leaveOutRegularExpressions(RuleFile& file, const Document& board) {
    std::set<std::string> classes;
    for (const NetClass& one : file.table.classes) {
        for (const std::string& pattern : one.nets) {
            if (looksLikeRegularExpression(pattern) && !fitsAnyNet(board, pattern)) {
                file.leftOut.push_back(
                    {"pattern " + pattern + " of net class " + one.name + ", a regular expression, is left out"});
                classes.insert(one.name);
            }
        }
    }
    return classes;
}

/// Projects are carried from board to board with the nets of older ones: those are no faults.
void leaveOutStrays(std::vector<NetClass>& classes, const RuleTable& table, const RuleChoice& choice) {
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        for (const RuleChoice::Stray& stray : choice.straysOf(row)) {
            const auto netClass = std::ranges::find(classes, stray.netClass, &NetClass::name);
            if (netClass != classes.end()) {
                std::erase(netClass->nets, stray.pattern);
            }
        }
    }
}

}  // namespace

void leaveOutUnusedClasses(RuleFile& file, const Document& board) {
    if (!file.isOfKicad || board.nets.empty()) {
        return;
    }
    const RuleTable all = file.table;
    const RuleChoice choice(board, all);
    const std::set<std::string> unread = leaveOutRegularExpressions(file, board);
    leaveOutStrays(file.table.classes, all, choice);
    std::set<std::string> unused;
    file.table.rules.clear();
    for (std::size_t row = 0; row < all.rules.size(); ++row) {
        const std::vector<std::string> empty = choice.emptyClassesOf(row);
        if (empty.empty()) {
            file.table.rules.push_back(all.rules[row]);
        }
        unused.insert(empty.begin(), empty.end());
    }
    std::erase_if(unused, [&](const std::string& name) { return unread.contains(name); });
    for (const std::string& name : unused) {
        const bool isName = name.starts_with(kNetPrefix);
        file.unused.push_back("no net of the board fits " +
                              (isName ? "the name " + name.substr(kNetPrefix.size()) : "net class " + name) +
                              "; its rules ask for nothing");
    }
}

}  // namespace model
