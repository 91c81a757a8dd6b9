#include "model/formats/gerber/layer_proposals.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "model/formats/gerber/assigned_files.h"
#include "model/formats/gerber/layer_order.h"
#include "model/formats/gerber/missing_layers.h"

namespace model::gerber {

namespace {

using Kind = FileRole::Kind;

std::string contentOf(const ReadFile& file) {
    switch (file.kind) {
        case ReadFile::Kind::Gerber: return "image";
        case ReadFile::Kind::Drills: return "drills";
        case ReadFile::Kind::Netlist: return "netlist";
        case ReadFile::Kind::Job: return "job file";
        case ReadFile::Kind::Placements: return "placements";
        case ReadFile::Kind::LayerPairs: return "layer pairs";
        default: return "other";
    }
}

/// Does the ending alone say it, as with CAD systems whose endings are a standard?
bool isKnownEnding(const ReadFile& file) {
    const std::size_t point = file.name().rfind('.');
    const std::optional<FileRole> role =
        point == std::string_view::npos ? std::nullopt : roleOfName(file.name().substr(point));
    return role && role->kind == file.role.kind && (role->side != LayerSide::None || role->kind == Kind::Profile);
}

std::string whyOf(const ReadFile& file) {
    switch (file.role.source) {
        case RoleSource::Told: return "the layer map";
        case RoleSource::Attribute: return "its attribute .FileFunction";
        case RoleSource::JobFile: return "the job file";
        case RoleSource::Comment: return "comments of the CAD system in it";
        case RoleSource::Name: return isKnownEnding(file) ? "its name, as of a known CAD system" : "words in its name";
        case RoleSource::Content: return "its content, a guess";
        default: return "nothing tells";
    }
}

bool isSure(const ReadFile& file) {
    const FileRole& role = file.role;
    const bool isSided = role.kind == Kind::Copper || role.kind == Kind::SolderMask || role.kind == Kind::Paste ||
                         role.kind == Kind::Legend;
    const bool isPlaced = !isSided || role.side == LayerSide::Top || role.side == LayerSide::Bottom ||
                          (role.kind == Kind::Copper && role.order > 0);
    return isPlaced && (role.source <= RoleSource::Comment || (role.source == RoleSource::Name && isKnownEnding(file)));
}

class Proposer {
public:
    explicit Proposer(const AssignedFiles& job) : m_job(job), m_isListed(job.files.size(), false) {}

    std::vector<LayerProposal> run() {
        for (const BoardFiles& board : m_job.boards) {
            addBoard(board);
        }
        for (const bool isIgnored : {true, false}) {
            for (std::size_t row = 0; row < m_job.files.size(); ++row) {
                if (!m_isListed[row] && (m_job.files[row].role.kind == Kind::Ignored) == isIgnored) {
                    add(row, m_job.files[row].role, "");
                }
            }
        }
        return std::move(m_proposals);
    }

private:
    /// As the board's layers will lie, from the top.
    void addBoard(const BoardFiles& board) {
        Diagnostics unused;
        const OrderedLayers ordered = orderedLayers(m_job.files, board, {}, unused);
        const std::vector<std::size_t> behindGaps = innerBehindGaps(m_job.files, board);
        int copper = 0;
        std::set<std::tuple<Kind, LayerSide, int>> claims;
        std::map<std::tuple<Kind, LayerSide, int>, std::size_t> first;
        for (std::size_t layer = 0; layer < ordered.layers.size(); ++layer) {
            const auto row = static_cast<std::size_t>(ordered.files[layer]);
            FileRole role = m_job.files[row].role;
            const std::tuple claim{role.kind, role.side, role.order};
            if (role.kind == Kind::Copper) {
                role.order = ++copper;
                role.isCountedFromTop = true;
                role.side = ordered.layers[layer].side;
            }
            if (m_isListed[row]) {
                continue;
            }
            const bool isOfAll = m_job.boards.size() < 2 || isShared(row);
            const std::size_t made = add(row, role, isOfAll ? "" : board.name);
            const bool isAlone = role.kind == Kind::Copper;
            const auto [other, isNew] = first.try_emplace(claim, made);
            if (isAlone && !isNew) {
                doubt(m_proposals[made], "another file claims the same layer");
                doubt(m_proposals[other->second], "another file claims the same layer");
            }
            if (std::ranges::find(behindGaps, row) != behindGaps.end()) {
                doubt(m_proposals[made], "no file has the number before it");
            }
        }
    }

    static void doubt(LayerProposal& proposal, const char* why) {
        proposal.why += proposal.isSure ? std::string(", but ") + why : "";
        proposal.isSure = false;
    }

    [[nodiscard]] bool isShared(std::size_t row) const {
        return std::ranges::count_if(m_job.boards, [&](const BoardFiles& board) {
                   return std::ranges::find(board.files, row) != board.files.end();
               }) > 1;
    }

    std::size_t add(std::size_t row, const FileRole& role, const std::string& board) {
        const ReadFile& file = m_job.files[row];
        m_isListed[row] = true;
        LayerProposal proposal{file.path, contentOf(file), role, "", "", board, true};
        if (proposal.isImage()) {
            proposal.draws = describe(role);
            proposal.why = whyOf(file);
            proposal.isSure = isSure(file);
        } else {
            proposal.why = "its content";
        }
        m_proposals.push_back(std::move(proposal));
        return m_proposals.size() - 1;
    }

    const AssignedFiles& m_job;
    std::vector<bool> m_isListed;
    std::vector<LayerProposal> m_proposals;
};

}  // namespace

base::Result<std::vector<LayerProposal>> proposeLayers(const std::filesystem::path& path,
                                                       const formats::ReadOptions& options, base::Progress& progress) {
    ASSIGN_OR_RETURN(std::vector<ReadFile> files, readFilesAt(path, progress));
    ASSIGN_OR_RETURN(const AssignedFiles job, assignFiles(std::move(files), path, options));
    return Proposer(job).run();
}

base::Result<std::vector<LayerProposal>> proposeWithoutMap(const std::filesystem::path& path,
                                                           base::Progress& progress) {
    ASSIGN_OR_RETURN(std::vector<ReadFile> files, readFilesAt(path, progress));
    ASSIGN_OR_RETURN(const AssignedFiles job, assignWithoutMap(std::move(files), path));
    return Proposer(job).run();
}

LayerMap mapOf(const std::vector<LayerProposal>& proposals) {
    LayerMap map;
    for (const LayerProposal& proposal : proposals) {
        if (proposal.isImage() || proposal.role.kind == Kind::Ignored) {
            map.set(proposal.path, proposal.role);
        }
    }
    return map;
}

std::string explainedMapText(const std::vector<LayerProposal>& proposals) {
    std::string text = layerMapText({});
    for (const LayerProposal& proposal : proposals) {
        const LayerMap one = mapOf({proposal});
        if (!one.isEmpty()) {
            text += (proposal.isSure ? "# " : "# not sure: ") + proposal.why + "\n" + layerMapRow(one.rows()[0]);
        }
    }
    return text;
}

}  // namespace model::gerber
