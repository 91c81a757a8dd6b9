#include "model/formats/gerber/gerber_reader.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "model/board/holes.h"
#include "model/formats/drawing/assembly.h"
#include "model/formats/gerber/assigned_files.h"
#include "model/formats/gerber/board_groups.h"
#include "model/formats/gerber/board_maker.h"
#include "model/formats/gerber/job_files.h"
#include "model/formats/gerber/text/words.h"
#include "model/nets/net_inference.h"
#include "model/text/whole_file.h"

namespace model::gerber {

namespace {

using Board = base::Result<std::shared_ptr<const Document>>;

std::string nameOf(const BoardFiles& board) {
    return board.name.empty() ? "board" : board.name;
}

base::Result<std::size_t> choose(const std::vector<BoardFiles>& boards, const std::string& wanted) {
    std::string list;
    for (std::size_t i = 0; i < boards.size(); ++i) {
        if (!wanted.empty() && equalsIgnoringCase(nameOf(boards[i]), wanted)) {
            return i;
        }
        list += (list.empty() ? "" : ", ") + nameOf(boards[i]);
    }
    if (!wanted.empty()) {
        return base::Error{base::ErrorCode::BadUsage, "the job has no board \"" + wanted + "\"; it has: " + list};
    }
    return std::size_t{0};
}

void reportOthers(const std::vector<BoardFiles>& boards, std::size_t chosen, const std::string& name,
                  Diagnostics& diagnostics) {
    std::string others;
    for (std::size_t i = 0; i < boards.size(); ++i) {
        if (i != chosen) {
            others += (others.empty() ? "" : ", ") + nameOf(boards[i]);
        }
    }
    if (!others.empty()) {
        diagnostics.report(
            Severity::Info, name, 0,
            "the job holds several boards; " + nameOf(boards[chosen]) +
                " is shown, which has most copper layers or was requested, and these are not: " + others);
    }
}

/// A hole that may join copper layers.
bool hasPlatedHole(const formats::DrawnJob& job) {
    const auto mayBePlated = [](const formats::DrawnFeature& feature) { return feature.plating != Plating::NonPlated; };
    for (std::size_t row = 0; row < job.layers.size(); ++row) {
        if (isHoles(job.layers[row].type) && std::ranges::any_of(job.steps.front().features[row], mayBePlated)) {
            return true;
        }
    }
    return false;
}

/// A drill file left out is a common mistake, and nothing else tells that copper is meant to be joined.
void reportMissingDrills(const BoardFiles& board, const MadeBoard& made, const std::string& name,
                         Diagnostics& diagnostics) {
    if (board.copperLayers < 2 || hasPlatedHole(made.job)) {
        return;
    }
    const bool isAny = std::ranges::any_of(made.job.layers, [](const auto& layer) { return isHoles(layer.type); });
    diagnostics.report(Severity::Warning, name, 0,
                       std::string(isAny ? "no file of drills has a hole that may be plated"
                                         : "no file of drills is there: the board has no holes") +
                           ", and nothing joins its " + std::to_string(board.copperLayers) + " copper layers");
}

std::shared_ptr<const Document> withBoards(const std::shared_ptr<const Document>& document,
                                           const std::vector<BoardFiles>& boards, std::size_t chosen) {
    if (boards.size() < 2) {
        return document;
    }
    auto result = std::make_shared<Document>(*document);
    result->job.steps.clear();
    for (const BoardFiles& board : boards) {
        result->job.steps.push_back(nameOf(board));
    }
    result->job.step = nameOf(boards[chosen]);
    return result;
}

Board makeDocument(std::vector<ReadFile> files, const std::filesystem::path& path, const formats::ReadOptions& options,
                   const Diagnostics& unpacking, base::Progress& progress, const base::Stopwatch& reading) {
    const std::string name = path.filename().string();
    ASSIGN_OR_RETURN(AssignedFiles assigned, assignFiles(std::move(files), path, options));
    const std::vector<BoardFiles>& boards = assigned.boards;
    ASSIGN_OR_RETURN(const std::size_t chosen, choose(boards, options.step));
    MadeBoard made = makeBoard(assigned.files, boards[chosen], path.stem().string());
    Diagnostics all = unpacking;
    all.append(assigned.diagnostics);
    all.append(made.job.diagnostics);
    for (const ReadFile& file : assigned.files) {
        if (file.kind == ReadFile::Kind::Other || file.isIgnored()) {
            all.append(file.diagnostics);
        }
    }
    reportOthers(boards, chosen, name, all);
    const bool hasCopper = boards[chosen].copperLayers > 0;
    reportMissingDrills(boards[chosen], made, name, all);
    if (!made.hasNets && hasCopper && made.job.steps.front().netlists.empty()) {
        all.report(Severity::Info, name, 0, "the images name no nets; nets follow from the copper");
    }
    made.job.diagnostics = std::move(all);
    assigned.files.clear();
    ASSIGN_OR_RETURN(std::shared_ptr<const Document> document,
                     formats::assemble(std::move(made.job), reading.milliseconds(), progress));
    if (!made.hasNets && hasCopper && !options.inferNets) {
        ASSIGN_OR_RETURN(document, withInferredNets(*document, progress));
    }
    return withBoards(document, boards, chosen);
}

using Counts = std::map<ReadFile::Kind, std::size_t>;

/// So many files are looked into even where none is named like one of a Gerber job.
constexpr std::size_t kFewFiles = 64;

/// Names under which a job's images, drills and netlists lie.
bool isNamedLikeJobFile(std::string_view name) {
    constexpr std::array<std::string_view, 3> kOthers = {".drl", ".xln", ".txt"};
    return isNamedLikeGerber(name) ||
           std::ranges::any_of(kOthers, [name](std::string_view ending) { return name.ends_with(ending); });
}

/// How many files of each kind there are, by their content.
Counts countFiles(const formats::Archive& archive, bool (*isCandidate)(std::string_view name)) {
    Counts counts;
    for (const auto& [path, row] : archive.rows()) {
        const base::Result<formats::Bytes> bytes = isCandidate(path) ? archive.bytes(row) : formats::Bytes();
        ++counts[bytes ? kindOf(bytes->view(), path) : ReadFile::Kind::Other];
    }
    return counts;
}

std::string textOf(std::size_t count, const std::string& one) {
    return count == 0 ? "" : ", " + std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

}  // namespace

std::vector<formats::FormPart> jobsIn(const formats::Archive& archive) {
    const bool isNamedSo =
        std::ranges::any_of(archive.rows(), [](const auto& row) { return isNamedLikeGerber(row.first); });
    Counts counts = isNamedSo ? countFiles(archive, isNamedLikeJobFile) : Counts{};
    const bool isFound = counts[ReadFile::Kind::Gerber] + counts[ReadFile::Kind::Drills] > 0;
    if (!isFound && (isNamedSo || archive.rows().size() <= kFewFiles)) {
        counts = countFiles(archive, [](std::string_view name) { return !isForeign(name); });
    }
    if (!isNamedSo && counts[ReadFile::Kind::Gerber] == 0) {
        return {};  // drills alone are too easily taken for such
    }
    std::string contents =
        textOf(counts[ReadFile::Kind::Gerber], "image") + textOf(counts[ReadFile::Kind::Drills], "drill file");
    if (contents.empty()) {
        return {};
    }
    contents += textOf(counts[ReadFile::Kind::Netlist], "netlist");
    return {{"", contents.substr(2)}};
}

bool looksLikeFile(std::string_view head, const std::filesystem::path& path) {
    const ReadFile::Kind kind = kindOf(head, path.filename().string());
    return kind == ReadFile::Kind::Gerber || kind == ReadFile::Kind::Drills || kind == ReadFile::Kind::Job;
}

Board readJob(const formats::Archive& archive, const std::filesystem::path& name, const formats::ReadOptions& options,
              const Diagnostics& diagnostics, base::Progress& progress, const base::Stopwatch& reading) {
    progress.beginPhase("Reading images and drills");
    ASSIGN_OR_RETURN(std::vector<ReadFile> files, readFiles(archive, progress));
    return makeDocument(std::move(files), name, options, diagnostics, progress, reading);
}

Board readFileAlone(const std::filesystem::path& path, const formats::ReadOptions& options, base::Progress& progress,
                    const base::Stopwatch& reading) {
    ASSIGN_OR_RETURN(std::string text, readWholeFile(path));
    ReadFile file = readFile(path.filename().string(), formats::Bytes(std::move(text)));
    if (file.kind == ReadFile::Kind::Job) {
        Diagnostics diagnostics;
        const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
        ASSIGN_OR_RETURN(const formats::Archive archive, formats::Archive::open(folder, {}, progress, diagnostics));
        return readJob(archive, path, options, diagnostics, progress, reading);
    }
    std::vector<ReadFile> files;
    files.push_back(std::move(file));
    return makeDocument(std::move(files), path, options, {}, progress, reading);
}

}  // namespace model::gerber
