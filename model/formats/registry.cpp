#include "model/formats/registry.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "model/formats/file_kinds.h"
#include "model/formats/gerber/gerber_reader.h"
#include "model/formats/ipc2581/ipc_reader.h"
#include "model/formats/kicad/kicad_reader.h"
#include "model/formats/kicad/text/tree.h"
#include "model/formats/odb/odb_reader.h"
#include "model/formats/paper/paper_reader.h"
#include "model/nets/net_inference.h"
#include "model/text/whole_file.h"

namespace model {

namespace {

namespace fs = std::filesystem;
using Board = base::Result<std::shared_ptr<const Document>>;

constexpr std::size_t kHeadBytes = 4096;

base::Error badInput(const fs::path& path, const std::string& text) {
    return {base::ErrorCode::BadInput, path.string() + ": " + text};
}

// ---- the rows ----

bool isOdb(const BoardInput& input) {
    return input.archive && odb::holdsJob(*input.archive);
}

Board readOdb(const BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    return odb::readJob(*input.archive, input.path, options, input.unpacking, progress, input.reading);
}

bool isIpc(const BoardInput& input) {
    return input.archive ? ipc2581::holdsIpc2581(*input.archive) : ipc2581::looksLikeIpc2581(input.head);
}

Board readIpc(const BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    if (input.archive) {
        return ipc2581::readJob(*input.archive, input.path, options, input.unpacking, progress, input.reading);
    }
    ASSIGN_OR_RETURN(const std::string text, readWholeFile(input.path));
    return ipc2581::readJob(text, input.path, options, input.unpacking, progress, input.reading);
}

bool isGerber(const BoardInput& input) {
    return input.archive ? gerber::holdsJob(*input.archive) : gerber::looksLikeFile(input.head, input.path);
}

Board readGerber(const BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    return input.archive
               ? gerber::readJob(*input.archive, input.path, options, input.unpacking, progress, input.reading)
               : gerber::readFileAlone(input.path, options, progress, input.reading);
}

bool isKicad(const BoardInput& input) {
    return kicad::looksLikeBoard(input.head) || (input.archive && kicad::holdsBoard(*input.archive));
}

Board readKicad(const BoardInput& input, const ReadOptions&, base::Progress& progress) {
    return input.archive ? kicad::readBoard(*input.archive, input.path, input.unpacking, progress, input.reading)
                         : kicad::readBoard(input.path, progress, input.reading);
}

bool isPaper(const BoardInput& input) {
    return paper::looksLikeModel(input.head);
}

Board readPaper(const BoardInput& input, const ReadOptions&, base::Progress& progress) {
    ASSIGN_OR_RETURN(std::string text, readWholeFile(input.path));
    return paper::readModel(std::move(text), input.path, progress);
}

// ---- choosing one ----

using Formats = std::vector<const BoardFormat*>;

/// What is there in forms that may be read, the richest first.
Formats formatsOf(const BoardInput& input) {
    Formats found;
    for (const BoardFormat& format : knownFormats()) {
        if (format.probe(input)) {
            found.push_back(&format);
        }
    }
    return found;
}

std::string namesOf(const Formats& formats) {
    std::string names;
    for (const BoardFormat* format : formats) {
        names += (names.empty() ? "" : ", ") + std::string(format->name) + " (" + std::string(format->key) + ")";
    }
    return names;
}

/// The one to read; what else is there is said in its messages. Errors: BadInput if it is not there in that form.
base::Result<const BoardFormat*> choose(const Formats& found, const std::string& wanted, BoardInput& input) {
    const auto chosen =
        wanted.empty() ? found.begin() : std::ranges::find(found, std::string_view(wanted), &BoardFormat::key);
    if (chosen == found.end()) {
        return badInput(input.path, "there is no board of format " + wanted + ", but " + namesOf(found));
    }
    Formats others = found;
    std::erase(others, *chosen);
    if (!others.empty()) {
        input.unpacking.report(
            Severity::Info, "", 0,
            "read as " + std::string((*chosen)->name) + "; it is there in other formats too: " + namesOf(others));
    }
    return *chosen;
}

std::string readHead(const fs::path& path) {
    std::error_code error;
    std::string head(fs::is_regular_file(path, error) ? kHeadBytes : 0, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

bool isArchive(std::string_view head) {
    return likelyKind(head).ends_with("archive");
}

base::Error unknown(const BoardInput& input) {
    std::error_code error;
    const bool isFolder = fs::is_directory(input.path, error);
    std::string kind = isFolder                                  ? "a folder"
                       : isArchive(input.head) || !input.archive ? likelyKind(input.head)
                                                                 : "an archive";
    for (const BoardFormat& format : knownFormats()) {
        const bool isMissed = input.archive && !format.part.empty();
        kind += isMissed
                    ? (kind.find(" without ") == std::string::npos ? " without " : " or ") + std::string(format.part)
                    : "";
    }
    const std::string begin = input.head.empty() ? "" : ", which begins with " + firstBytes(input.head);
    return badInput(input.path, "this is " + kind + begin + "; what can be read: " + describeFormats());
}

/// Unpacks what may be a folder or archive. Errors: what stops it from being one.
base::Status unpack(BoardInput& input, base::Progress& progress) {
    progress.beginPhase("Unpacking the job");
    base::Result<formats::Archive> archive = formats::Archive::open(input.path, {}, progress, input.unpacking);
    std::error_code error;
    const bool isBroken = !archive && (archive.error().code == base::ErrorCode::Cancelled ||
                                       !fs::is_regular_file(input.path, error) || isArchive(input.head));
    if (isBroken) {
        return archive.error();
    }
    if (archive) {
        input.archive = std::move(*archive);
    }
    return base::Done{};
}

base::Result<ReadBoard> readAsItIs(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    std::error_code error;
    if (!fs::exists(path, error)) {
        return badInput(path, "there is no such file or folder");
    }
    BoardInput input{path, readHead(path), {}, {}, {}};
    Formats found = formatsOf(input);
    if (found.empty()) {
        RETURN_IF_ERROR(unpack(input, progress));
        found = formatsOf(input);
    }
    if (found.empty()) {
        return unknown(input);
    }
    ASSIGN_OR_RETURN(const BoardFormat* format, choose(found, options.format, input));
    if (!options.layerMap.empty() && format->read != readGerber) {
        input.unpacking.report(Severity::Warning, options.layerMap.filename().string(), 0,
                               "the layer map is not used: only Gerber jobs need one");
    }
    ASSIGN_OR_RETURN(auto document, format->read(input, options, progress));
    return ReadBoard{std::move(document), format};
}

}  // namespace

std::span<const BoardFormat> knownFormats() {
    static const std::array kFormats = {
        BoardFormat{"ODB++ job", {".tgz", ".tar.gz", ".tar", ".zip"}, "an ODB++ matrix", isOdb, readOdb, "odb"},
        BoardFormat{"IPC-2581", {".xml", ".cvg"}, "an IPC-2581 file", isIpc, readIpc, "ipc2581"},
        BoardFormat{"KiCad board", {".kicad_pcb"}, "a KiCad board", isKicad, readKicad, "kicad"},
        BoardFormat{"Gerber job",
                    {".zip", ".gbrjob", ".gbr", ".ger", ".gtl", ".gbl", ".art", ".pho", ".gdo", ".drl", ".xln"},
                    "Gerber images",
                    isGerber,
                    readGerber,
                    "gerber"},
        BoardFormat{"model of the paper", {".txt"}, "", isPaper, readPaper, "paper"},
    };
    return kFormats;
}

std::string namePatterns(std::span<const BoardFormat> formats) {
    std::string patterns;
    for (const BoardFormat& format : formats) {
        for (const std::string_view extension : format.extensions) {
            patterns += (patterns.empty() ? "*" : " *") + std::string(extension);
        }
    }
    return patterns;
}

std::string describeFormats() {
    std::string text;
    for (const BoardFormat& format : knownFormats()) {
        text += (text.empty() ? "" : ", ") + std::string(format.name) + " (";
        std::string endings = format.part.empty() ? "" : "folder";
        for (const std::string_view extension : format.extensions) {
            endings += (endings.empty() ? "" : ", ") + std::string(extension);
        }
        text += endings + ")";
    }
    return text;
}

bool isNamedLikeBoard(const fs::path& path) {
    std::error_code error;
    const std::string name = formats::lowerCase(path.filename().string());
    return fs::is_directory(path, error) || std::ranges::any_of(knownFormats(), [&](const BoardFormat& format) {
               return std::ranges::any_of(format.extensions, [&](std::string_view e) { return name.ends_with(e); });
           });
}

std::vector<std::string> formatKeys() {
    std::vector<std::string> keys;
    for (const BoardFormat& format : knownFormats()) {
        keys.emplace_back(format.key);
    }
    return keys;
}

base::Result<ReadBoard> readAnyBoard(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    const std::vector<std::string> keys = formatKeys();
    if (!options.format.empty() && std::ranges::find(keys, options.format) == keys.end()) {
        return base::Error{base::ErrorCode::BadUsage, "there is no format " + options.format};
    }
    ASSIGN_OR_RETURN(ReadBoard board, readAsItIs(path, options, progress));
    if (options.inferNets) {
        ASSIGN_OR_RETURN(board.document, withInferredNets(*board.document, progress));
    }
    return board;
}

Board readBoard(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    ASSIGN_OR_RETURN(ReadBoard board, readAnyBoard(path, options, progress));
    return std::move(board.document);
}

}  // namespace model
