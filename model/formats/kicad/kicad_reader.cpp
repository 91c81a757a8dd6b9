#include "model/formats/kicad/kicad_reader.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "model/formats/drawing/assembly.h"
#include "model/formats/kicad/board_drawing.h"
#include "model/formats/kicad/project.h"
#include "model/text/whole_file.h"

namespace model::kicad {

namespace {

namespace fs = std::filesystem;
using Board = base::Result<std::shared_ptr<const Document>>;

constexpr std::string_view kBoard = ".kicad_pcb";
constexpr std::string_view kProject = ".kicad_pro";

/// Rows of the boards, those with a project beside them first.
std::vector<int> boardsIn(const formats::Archive& archive) {
    std::vector<int> boards;
    for (const auto& [path, row] : archive.rows()) {
        const std::size_t slash = path.rfind('/');
        const std::string_view name = std::string_view(path).substr(slash == std::string::npos ? 0 : slash + 1);
        // KiCad's own safety copies
        const bool isCopy =
            name.starts_with("_autosave-") || name.starts_with("._") || path.find("-backups/") != std::string::npos;
        if (path.ends_with(kBoard) && !isCopy) {
            boards.push_back(row);
        }
    }
    std::stable_partition(boards.begin(), boards.end(), [&](int row) {
        std::string path = archive.path(row);
        return archive.find(path.replace(path.size() - kBoard.size(), kBoard.size(), kProject)) >= 0;
    });
    return boards;
}

struct Source {
    fs::path path;     ///< for errors
    std::string file;  ///< for messages
    std::string_view text;
    Project project;
    Diagnostics diagnostics;
};

Board make(Source source, base::Progress& progress, const base::Stopwatch& reading) {
    progress.beginPhase("Reading the board");
    base::Result<formats::DrawnJob> job = drawBoard(source.text, source.file, source.project, progress);
    if (!job) {
        return base::Error{job.error().code, source.path.string() + ": " + job.error().text};
    }
    source.diagnostics.append(job->diagnostics);
    job->diagnostics = std::move(source.diagnostics);
    job->info.name = fs::path(source.file).stem().string();
    return formats::assemble(std::move(*job), reading.milliseconds(), progress);
}

/// The value of an item "(key value)" of the text, without its quotes; empty if there is none.
std::string_view valueOf(std::string_view text, std::string_view key) {
    const std::string item = "(" + std::string(key) + " ";
    const std::size_t at = text.find(item);
    if (at == std::string_view::npos) {
        return {};
    }
    std::string_view value = text.substr(at + item.size());
    const bool isQuoted = value.starts_with('"');
    value.remove_prefix(isQuoted ? 1 : 0);
    return value.substr(0, value.find_first_of(isQuoted ? "\"" : " )\n"));
}

/// Has it no item that draws anything? Layers, plot settings and the like fill a few kilobytes of such a board; longer
/// ones are taken for drawn without a look at them.
bool isEmpty(std::string_view text) {
    constexpr std::size_t kMostBytes = 64'000;
    constexpr std::string_view kItems[] = {"(footprint", "(module", "(segment", "(arc",    "(via",       "(zone",
                                           "(dimension", "(image",  "(table",   "(target", "(generated", "(barcode"};
    const auto isThere = [text](std::string_view item) {
        constexpr std::string_view kBehind = " \t\r\n)";  // "(via_size" is a setting
        for (std::size_t at = text.find(item); at != std::string_view::npos; at = text.find(item, at + 1)) {
            const std::size_t end = at + item.size();
            if (end < text.size() && kBehind.find(text[end]) != std::string_view::npos) {
                return true;
            }
        }
        return false;
    };
    return text.size() < kMostBytes && text.find("(gr_") == std::string_view::npos &&
           std::ranges::none_of(kItems, isThere);
}

/// "by KiCad 9.0, format 20241229"; older versions do not say themselves which they are.
std::string contentsOf(std::string_view text) {
    constexpr std::size_t kHeadBytes = 1000;
    const std::string_view head = text.substr(0, kHeadBytes);
    const std::string version(valueOf(head, "generator_version"));
    const std::string format(valueOf(head, "version"));
    return (version.empty() ? "" : "by KiCad " + version + ", ") + "format " + (format.empty() ? "unknown" : format);
}

}  // namespace

std::vector<formats::FormPart> boardsOf(const formats::Archive& archive) {
    std::vector<formats::FormPart> boards;
    for (const int row : boardsIn(archive)) {
        const base::Result<formats::Bytes> bytes = archive.bytes(row);
        if (!bytes) {
            boards.push_back({archive.path(row), "cannot be read"});
            continue;
        }
        const bool hasNothing = isEmpty(bytes->view());
        boards.push_back({archive.path(row), (hasNothing ? "empty, " : "") + contentsOf(bytes->view()), hasNothing});
    }
    return boards;
}

Board readBoard(const fs::path& path, const Diagnostics& before, base::Progress& progress,
                const base::Stopwatch& reading) {
    ASSIGN_OR_RETURN(const std::string text, readWholeFile(path));
    Source source{path, path.filename().string(), text, {}, before};
    fs::path beside = path;
    beside.replace_extension(kProject);
    std::error_code error;
    if (fs::is_regular_file(beside, error)) {
        const base::Result<std::string> project = readWholeFile(beside, base::kMostSettingBytes);
        if (project) {
            source.project = readProject(*project, beside.filename().string(), source.diagnostics);
        } else {
            source.diagnostics.report(Severity::Warning, beside.filename().string(), 0,
                                      "the project beside the board cannot be read");
        }
    }
    return make(std::move(source), progress, reading);
}

Board readBoard(const formats::Archive& archive, const fs::path& name, const Diagnostics& unpacking,
                base::Progress& progress, const base::Stopwatch& reading) {
    const std::vector<int> boards = boardsIn(archive);
    if (boards.empty()) {
        return base::Error{base::ErrorCode::BadInput, name.string() + ": there is no board of KiCad in it"};
    }
    const std::string file = archive.path(boards[0]);
    ASSIGN_OR_RETURN(const formats::Bytes bytes, archive.bytes(boards[0]));
    Source source{name / file, file, bytes.view(), {}, {}};
    source.diagnostics.append(unpacking);
    std::string beside = file;
    const int row = archive.find(beside.replace(beside.size() - kBoard.size(), kBoard.size(), kProject));
    if (row >= 0) {
        ASSIGN_OR_RETURN(const formats::Bytes project, archive.bytes(row));
        source.project = readProject(project.view(), beside, source.diagnostics);
    }
    for (std::size_t i = 1; i < boards.size(); ++i) {
        source.diagnostics.report(Severity::Warning, archive.path(boards[i]), 0,
                                  "this is another board beside the one that is shown; it was not read");
    }
    return make(std::move(source), progress, reading);
}

}  // namespace model::kicad
