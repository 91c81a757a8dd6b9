#include "model/formats/gerber/layer_order.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

using Kind = FileRole::Kind;

/// Where a kind of layer lies, from the top.
int rankOf(const FileRole& role) {
    const bool isBottom = role.side == LayerSide::Bottom;
    switch (role.kind) {
        case Kind::Legend: return isBottom ? 9 : 1;
        case Kind::Paste: return isBottom ? 8 : 2;
        case Kind::SolderMask: return isBottom ? 7 : 3;
        case Kind::Copper: return 5;
        case Kind::Drill: return 20;
        case Kind::Rout: return 21;
        case Kind::Profile: return 30;
        default: return 40;
    }
}

LayerType typeOf(Kind kind) {
    switch (kind) {
        case Kind::Copper: return LayerType::Signal;
        case Kind::SolderMask: return LayerType::SolderMask;
        case Kind::Paste: return LayerType::SolderPaste;
        case Kind::Legend: return LayerType::SilkScreen;
        case Kind::Drill: return LayerType::Drill;
        case Kind::Rout: return LayerType::Rout;
        default: return LayerType::Document;
    }
}

bool isOfBoard(Kind kind) {
    return kind == Kind::Copper || kind == Kind::SolderMask || kind == Kind::Paste || kind == Kind::Legend ||
           kind == Kind::Drill || kind == Kind::Rout;
}

int copperRank(const FileRole& role) {
    return role.side == LayerSide::Top ? 0 : role.side == LayerSide::Bottom ? 2 : 1;
}

/// The name of a file without what it shares with others of the board, `board`, or what it draws, `role`.
std::string layerName(const ReadFile& file, const FileRole& role, const std::string& board) {
    const std::string_view stem = file.name().substr(0, file.name().find_last_of('.'));
    std::string_view rest = stem;
    if (!board.empty() && upperCase(stem).starts_with(board)) {
        rest = stem.substr(board.size());
        rest.remove_prefix(std::min(rest.find_first_not_of("._- "), rest.size()));
    }
    const bool isOneOfMany = role.kind == Kind::Copper && copperRank(role) == 1 && role.order == 0;
    const bool isTelling =
        !rest.empty() && (rest.size() < stem.size() || isOneOfMany || roleOfName(std::string(rest) + ".x"));
    return isTelling                                       ? std::string(rest)
           : role.isKnown() && role.kind != Kind::Document ? describe(role)
                                                           : std::string(file.name());
}

class LayerMaker {
public:
    LayerMaker(const std::vector<ReadFile>& files, const BoardFiles& board, const JobFileFacts& job,
               Diagnostics& diagnostics)
        : m_files(files), m_board(board), m_job(job), m_diagnostics(diagnostics) {}

    OrderedLayers run() {
        std::vector<std::size_t> rows;
        for (const std::size_t row : m_board.files) {
            if (m_files[row].isImage() && m_files[row].role.kind != Kind::Components) {
                rows.push_back(row);
            }
        }
        std::ranges::stable_sort(rows, {}, [&](std::size_t row) { return rankOf(m_files[row].role); });
        countNames(rows);
        sortCopper(rows);
        reportRivals(rows);
        readStack();
        for (const std::size_t row : rows) {
            add(row);
        }
        return std::move(m_result);
    }

private:
    void countNames(const std::vector<std::size_t>& rows) {
        for (const std::size_t row : rows) {
            ++m_filesOfName[boardOfName(m_files[row].name())];
        }
        m_areAlone = rows.size() == 1;
    }

    /// What stands before the layer in a file's name, if more than two begin so: "PAST" of "PAST_TOP" and "PAST_BOT" is
    /// no board. Drills are often called otherwise than the images.
    [[nodiscard]] std::string sharedName(const ReadFile& file) const {
        const std::string board = boardOfName(file.name());
        const bool isDrilled = file.role.kind == Kind::Drill || file.role.kind == Kind::Rout;
        const auto count = m_filesOfName.find(board);
        const int others = count == m_filesOfName.end() ? 0 : count->second;
        const bool isShared = m_areAlone || isDrilled || others > 2 || (others == 2 && m_filesOfName.size() == 1);
        return isShared ? board : std::string();
    }

    void sortCopper(std::vector<std::size_t>& rows) {
        const auto isCopper = [&](std::size_t row) { return m_files[row].role.kind == Kind::Copper; };
        const auto begin = std::ranges::find_if(rows, isCopper);
        const auto end = std::find_if_not(begin, rows.end(), isCopper);
        numberByNames(std::span(begin, end));
        std::stable_sort(begin, end, [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
        m_top = end - begin > 1 ? *begin : kNone;
        m_bottom = end - begin > 1 ? *(end - 1) : kNone;
        std::set<std::pair<int, int>> seen;
        for (auto row = begin; row != end; ++row) {
            const FileRole& role = m_files[*row].role;
            const bool isNew = seen.emplace(copperRank(role), copperRank(role) == 1 ? role.order : 0).second;
            if (m_namedOrders.contains(*row)) {
                m_diagnostics.report(Severity::Info, m_files[*row].path, 0,
                                     "only its name tells where this inner copper layer lies; taken as copper layer " +
                                         std::to_string(m_namedOrders.at(*row)) + " by the number in it");
            } else if (role.order == 0 && copperRank(role) == 1) {
                m_diagnostics.report(Severity::Warning, m_files[*row].path, 0,
                                     "nothing tells where this inner copper layer lies; inner layers without a number "
                                     "come last, by name");
            } else if (!isNew) {
                m_diagnostics.report(Severity::Warning, m_files[*row].path, 0,
                                     "another file claims the same copper layer; both are shown");
            }
        }
    }

    /// Layers that are called "GND02" and "SIG03" tell no number by themselves, for "GND2" may be the second ground.
    /// Where the numbers of all of them are places between top and bottom that nobody else has, they are meant so.
    void numberByNames(std::span<const std::size_t> copper) {
        std::set<int> taken = {1, static_cast<int>(copper.size())};
        std::map<std::size_t, int> named;
        for (const std::size_t row : copper) {
            const FileRole& role = m_files[row].role;
            const bool isNamed = copperRank(role) == 1 && role.order == 0;
            const bool isInner = copperRank(role) == 1 && !isNamed;
            const int order = isNamed ? numberInName(m_files[row].name()) : role.order;
            const bool isPlace = order > 1 && order < static_cast<int>(copper.size());
            const bool isCounted = isNamed || role.isCountedFromTop;
            if ((isNamed || isInner) && (!isPlace || !isCounted || !taken.insert(order).second)) {
                return;
            }
            if (isNamed) {
                named[row] = order;
            }
        }
        m_namedOrders = std::move(named);
    }

    void reportRivals(const std::vector<std::size_t>& rows) {
        std::set<std::pair<Kind, LayerSide>> seen;
        for (const std::size_t row : rows) {
            const FileRole& role = m_files[row].role;
            const bool isOne = role.kind == Kind::SolderMask || role.kind == Kind::Paste || role.kind == Kind::Legend;
            if (isOne && !seen.emplace(role.kind, role.side).second) {
                m_diagnostics.report(Severity::Warning, m_files[row].path, 0,
                                     "another file claims the same " + describe(role) + "; both are shown");
            }
        }
    }

    /// Inner layers without a number come behind those with one.
    [[nodiscard]] std::tuple<int, int, std::string> key(std::size_t row) const {
        const FileRole& role = m_files[row].role;
        const auto named = m_namedOrders.find(row);
        const int order = named != m_namedOrders.end() ? named->second : role.order;
        return {copperRank(role), order > 0 ? order : 1000, upperCase(m_files[row].name())};
    }

    void readStack() {
        for (const JobStackRow& row : m_job.stackup) {
            const bool isMask = equalsIgnoringCase(row.type, "SolderMask");
            if (equalsIgnoringCase(row.type, "Copper")) {
                m_copperRows.push_back(&row);
                m_between.emplace_back();
            } else if (equalsIgnoringCase(row.type, "Dielectric") && !m_copperRows.empty()) {
                m_between.back().push_back(&row);
            } else if (isMask) {
                (m_copperRows.empty() ? m_topMask : m_bottomMask) = &row;
            } else if (equalsIgnoringCase(row.type, "Legend")) {
                (m_copperRows.empty() ? m_topLegend : m_bottomLegend) = &row;
            }
        }
        m_usesStack = m_copperRows.size() == m_board.copperLayers && !m_copperRows.empty();
        if (!m_usesStack && !m_copperRows.empty()) {
            m_diagnostics.report(Severity::Warning, m_board.name, 0,
                                 "the job file lists another number of copper layers than there are files; its stackup "
                                 "is not used");
        }
    }

    static LayerFacts factsOf(const JobStackRow& row) {
        LayerFacts facts;
        facts.thicknessNm = row.thicknessNm;
        facts.material = row.material;
        return facts;
    }

    /// The uppermost copper is the top, the lowest the bottom, whatever their files say.
    [[nodiscard]] FileRole placedRole(std::size_t row) const {
        FileRole role = m_files[row].role;
        if (role.kind == Kind::Copper && role.side == LayerSide::Inner) {
            role.side = row == m_top ? LayerSide::Top : row == m_bottom ? LayerSide::Bottom : LayerSide::Inner;
        }
        return role;
    }

    void add(std::size_t row) {
        const ReadFile& file = m_files[row];
        const FileRole role = placedRole(row);
        formats::DrawnLayer layer;
        const std::size_t copper = m_result.copper.size();
        const bool isOfStack = file.role.kind == Kind::Copper && m_usesStack;
        const bool hasStackName = isOfStack && !m_copperRows[copper]->name.empty();
        layer.name = unique(hasStackName ? m_copperRows[copper]->name : layerName(file, role, sharedName(file)));
        layer.file = file.path;
        layer.type = typeOf(file.role.kind);
        layer.context = isOfBoard(file.role.kind) ? LayerContext::Board : LayerContext::Misc;
        layer.side = role.side;
        layer.isNegative = file.role.kind == Kind::Copper && (file.role.isNegative != file.image.isNegative);
        layer.tools = file.image.tools;
        if (layer.isNegative) {
            layer.type = LayerType::PowerGround;
        }
        if (file.image.isNegative && file.role.kind != Kind::Copper) {
            m_diagnostics.report(Severity::Warning, file.path, 0,
                                 "a negative image (IPNEG) of a layer that is not copper "
                                 "is drawn as it is");
        }
        describeGuess(file, role);
        if (isOfStack) {
            layer.facts = factsOf(*m_copperRows[copper]);
        }
        const bool isBottom = file.role.side == LayerSide::Bottom;
        const JobStackRow* mask = isBottom ? m_bottomMask : m_topMask;
        const JobStackRow* legend = isBottom ? m_bottomLegend : m_topLegend;
        if (file.role.kind == Kind::Legend && legend != nullptr) {
            layer.facts = factsOf(*legend);
        }
        if (file.role.kind == Kind::SolderMask && mask != nullptr) {
            layer.facts = factsOf(*mask);
        }
        if (file.role.kind == Kind::Copper) {
            m_result.copper.push_back(static_cast<std::int32_t>(m_result.layers.size()));
        }
        m_result.files.push_back(static_cast<std::int32_t>(row));
        m_result.layers.push_back(std::move(layer));
        if (file.role.kind == Kind::Copper && m_usesStack && copper + 1 < m_copperRows.size()) {
            for (const JobStackRow* dielectric : m_between[copper]) {
                addDielectric(*dielectric);
            }
        }
    }

    void addDielectric(const JobStackRow& row) {
        formats::DrawnLayer layer;
        layer.name = unique(row.name.empty() ? "dielectric" : row.name);
        layer.type = LayerType::Dielectric;
        layer.side = LayerSide::Inner;
        layer.facts = factsOf(row);
        m_result.layers.push_back(std::move(layer));
        m_result.files.push_back(formats::kNoRow);
    }

    void describeGuess(const ReadFile& file, const FileRole& role) {
        const RoleSource source = role.source;
        if (source == RoleSource::Name || source == RoleSource::Comment || source == RoleSource::Content) {
            const std::string by = source == RoleSource::Name      ? "name"
                                   : source == RoleSource::Comment ? "comments"
                                                                   : "content";
            m_diagnostics.report(Severity::Info, file.path, 0,
                                 "neither an attribute nor a job file says what the file draws; taken as " +
                                     describe(role) + " by its " + by);
        } else if (source == RoleSource::Unknown) {
            m_diagnostics.report(Severity::Warning, file.path, 0,
                                 "nothing tells which layer this file draws; it is shown as a document");
        }
    }

    std::string unique(const std::string& name) {
        std::string result = name;
        for (int i = 2; !m_names.insert(upperCase(result)).second; ++i) {
            result = name + " (" + std::to_string(i) + ")";
        }
        return result;
    }

    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    const std::vector<ReadFile>& m_files;
    const BoardFiles& m_board;
    const JobFileFacts& m_job;
    Diagnostics& m_diagnostics;
    OrderedLayers m_result;
    std::map<std::string, int> m_filesOfName;  ///< by what stands before the layer in their names
    bool m_areAlone = false;                   ///< there is one image
    std::set<std::string> m_names;
    std::size_t m_top = kNone;                 ///< file of the uppermost copper, if there is more than one
    std::size_t m_bottom = kNone;              ///< of the lowest
    std::map<std::size_t, int> m_namedOrders;  ///< of files, by the numbers in their names
    std::vector<const JobStackRow*> m_copperRows;
    std::vector<std::vector<const JobStackRow*>> m_between;  ///< dielectrics below each copper row
    const JobStackRow* m_topMask = nullptr;
    const JobStackRow* m_bottomMask = nullptr;
    const JobStackRow* m_topLegend = nullptr;
    const JobStackRow* m_bottomLegend = nullptr;
    bool m_usesStack = false;
};

}  // namespace

OrderedLayers orderedLayers(const std::vector<ReadFile>& files, const BoardFiles& board, const JobFileFacts& job,
                            Diagnostics& diagnostics) {
    return LayerMaker(files, board, job, diagnostics).run();
}

}  // namespace model::gerber
