#include "model/formats/registry.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>

#include "model/base/ascii.h"
#include "model/base/limits.h"
#include "model/board/diagnostic_facts.h"
#include "model/formats/board_forms.h"
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

Board readOdb(const BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    return odb::readJob(*input.archive, input.path, options, input.unpacking, progress, input.reading);
}

bool isIpc(const BoardInput& input) {
    return ipc2581::looksLikeIpc2581(input.head);
}

Board readIpc(const BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    if (input.archive) {
        return ipc2581::readJob(*input.archive, input.path, options, input.unpacking, progress, input.reading);
    }
    ASSIGN_OR_RETURN(const std::string text, readWholeFile(input.path));
    return ipc2581::readJob(text, input.path, options, input.unpacking, progress, input.reading);
}

bool isGerber(const BoardInput& input) {
    return gerber::looksLikeFile(input.head, input.path);
}

Board readGerber(const BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    return input.archive
               ? gerber::readJob(*input.archive, input.path, options, input.unpacking, progress, input.reading)
               : gerber::readFileAlone(input.path, options, progress, input.reading);
}

bool isKicad(const BoardInput& input) {
    return kicad::looksLikeBoard(input.head);
}

/// Of formats whose boards are one step.
Board ofStep(Board board, const std::string& wanted) {
    if (!board || wanted.empty() || base::equalsIgnoringCase((*board)->job.step, wanted)) {
        return board;
    }
    return base::Error{base::ErrorCode::BadUsage,
                       "the job has no step \"" + wanted + "\"; it has: " + (*board)->job.step};
}

Board readKicad(const BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    return ofStep(input.archive ? kicad::readBoard(*input.archive, input.path, input.unpacking, progress, input.reading)
                                : kicad::readBoard(input.path, input.unpacking, progress, input.reading),
                  options.step);
}

bool isPaper(const BoardInput& input) {
    return paper::looksLikeModel(input.head);
}

Board readPaper(const BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    ASSIGN_OR_RETURN(std::string text, readWholeFile(input.path));
    return ofStep(paper::readModel(std::move(text), input.path, progress), options.step);
}

// ---- choosing one ----

using Forms = std::vector<BoardForm>;

bool isOf(const BoardFormat& format, const BoardInput& file) {
    return format.probe != nullptr && format.probe(file);
}

/// What a file is by its own bytes.
const BoardFormat* formatOf(const BoardInput& input) {
    const auto found =
        std::ranges::find_if(knownFormats(), [&input](const BoardFormat& format) { return isOf(format, input); });
    return found == knownFormats().end() ? nullptr : &*found;
}

std::string namesOf(const Forms& forms) {
    std::string names;
    for (const BoardFormat& format : knownFormats()) {
        if (std::ranges::find(forms, &format, &BoardForm::format) != forms.end()) {
            names += (names.empty() ? "" : ", ") + std::string(format.name) + " (" + std::string(format.key) + ")";
        }
    }
    return names;
}

/// Puts the one to read first. Errors: BadInput if it is not there as the options want it.
base::Status putChosenFirst(Forms& forms, const ReadOptions& options, const fs::path& path) {
    const auto chosen = std::ranges::find_if(forms, [&options](const BoardForm& form) {
        return (options.format.empty() || form.format->key == options.format) &&
               (options.member.empty() || form.member == options.member);
    });
    if (chosen == forms.end()) {
        return badInput(path, "there is no board of format " + options.format +
                                  (options.member.empty() ? "" : " in " + options.member) + ", but " + namesOf(forms));
    }
    std::rotate(forms.begin(), chosen, chosen + 1);
    return base::Done{};
}

/// How a file begins; nothing of a folder. Errors: BadInput for a file that cannot be read.
base::Result<std::string> readHead(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return std::string();
    }
    std::string head(kHeadBytes, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (!in.is_open() || in.bad()) {
        return badInput(path, "the file cannot be read");
    }
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

bool isArchive(std::string_view head) {
    return likelyKind(head).ends_with("archive");
}

/// Why one of the first files of a folder cannot be read: it may have been the board.
std::optional<base::Error> unreadFileOf(const formats::Archive& folder) {
    constexpr std::size_t kFirst = 64;
    constexpr std::uint64_t kMostBytes = 16 * base::kMiB;
    std::size_t count = 0;
    for (const auto& [path, row] : folder.rows()) {
        if (++count > kFirst) {
            break;
        }
        const base::Result<formats::Bytes> bytes =
            folder.storedSize(row) <= kMostBytes ? folder.bytes(row) : formats::Bytes();
        if (!bytes) {
            return bytes.error();
        }
    }
    return std::nullopt;
}

/// What of the input could not be read, which may have been the board.
std::string leftOutOf(const BoardInput& input) {
    const Diagnostic* error = firstError(input.unpacking);
    return error != nullptr ? ", of which not all could be read (" + placeOf(*error) + ": " + error->text + ")" : "";
}

base::Error unknown(const BoardInput& input) {
    if (const auto unread = input.archive ? unreadFileOf(*input.archive) : std::nullopt) {
        return *unread;
    }
    std::error_code error;
    const bool isFolder = fs::is_directory(input.path, error);
    if (isFolder && fs::is_empty(input.path, error)) {
        return badInput(input.path, "the folder is empty");
    }
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
    return badInput(input.path,
                    "this is " + kind + begin + leftOutOf(input) + "; what can be read: " + describeFormats());
}

/// Unpacks what may be a folder or archive. Errors: what stops it from being one.
base::Status unpack(BoardInput& input, base::Progress& progress) {
    progress.beginPhase("Unpacking the job");
    base::Result<formats::Archive> archive =
        formats::Archive::open(input.path, input.limits, progress, input.unpacking);
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

/// A board that is one file lacks nothing where others of its project cannot be read.
void warnOfOthers(const BoardFormat& format, BoardInput& input) {
    if (format.isDesign) {
        input.unpacking.soften(Severity::Warning);
    }
}

/// What else lies there is said in the messages of the board.
void reportOthers(const Forms& forms, BoardInput& input) {
    input.unpacking.report(Severity::Info, "", 0, choiceText(forms, input.path));
}

/// The archive in the archive of the input becomes the input. Errors: BadInput if it is none; Cancelled.
base::Status enter(BoardInput& input, const std::string& member, base::Progress& progress) {
    const int row = input.archive->find(member);
    if (row < 0) {
        return badInput(input.path, "there is no " + member + " in it");
    }
    ASSIGN_OR_RETURN(const formats::Bytes bytes, input.archive->bytes(row));
    input.path /= member;
    ASSIGN_OR_RETURN(formats::Archive inner,
                     formats::Archive::unpack(bytes.view(), input.path, input.limits, progress, input.unpacking));
    input.archive = std::move(inner);
    return base::Done{};
}

/// What lies open in the archive of the input, without other files of the same format.
base::Result<std::shared_ptr<const Document>> readPart(BoardInput& input, const BoardForm& form,
                                                       const ReadOptions& options, base::Progress& progress) {
    for (const formats::FormPart& part : form.format->parts(*input.archive)) {
        if (!form.member.empty() && part.member != form.member) {
            input.archive->leaveOut(input.archive->find(part.member));
        }
    }
    return form.format->read(input, options, progress);
}

base::Result<std::shared_ptr<const Document>> readForm(BoardInput& input, const BoardForm& form,
                                                       const ReadOptions& options, base::Progress& progress) {
    if (form.path != input.path) {
        ASSIGN_OR_RETURN(std::string head, readHead(form.path));
        BoardInput inner{form.path, std::move(head), {}, std::move(input.unpacking), input.reading, input.limits};
        if (isOf(*form.format, inner)) {
            return form.format->read(inner, options, progress);
        }
        RETURN_IF_ERROR(unpack(inner, progress));
        return inner.archive ? readPart(inner, form, options, progress) : unknown(inner);
    }
    if (isNamedLikeArchive(form.member)) {
        RETURN_IF_ERROR(enter(input, form.member, progress));
        return form.format->read(input, options, progress);
    }
    return readPart(input, form, options, progress);
}

void reportUnusedMap(const ReadOptions& options, const BoardFormat& format, BoardInput& input) {
    if (!options.layerMap.empty() && format.read != readGerber) {
        input.unpacking.report(Severity::Warning, options.layerMap.filename().string(), 0,
                               "the layer map is not used: only Gerber jobs need one");
    }
}

/// What can be read there, never nothing, the one to read first. Unpacks the input unless it is the board itself.
base::Result<Forms> findForms(BoardInput& input, const ReadOptions& options, base::Progress& progress) {
    std::error_code error;
    const fs::file_status status = fs::status(input.path, error);
    if (!fs::exists(status)) {
        return badInput(input.path, formats::noneThere(status, error));
    }
    if (!fs::is_regular_file(status) && !fs::is_directory(status)) {
        return badInput(input.path, "a board must be a file or folder, and this is a pipe or device");
    }
    Forms forms;
    if (const BoardFormat* format = formatOf(input)) {
        forms.push_back({format, input.path});
    } else {
        RETURN_IF_ERROR(unpack(input, progress));
        if (input.archive) {
            ASSIGN_OR_RETURN(forms, formsIn(input, progress));
        }
    }
    if (forms.empty()) {
        return unknown(input);
    }
    RETURN_IF_ERROR(putChosenFirst(forms, options, input.path));
    return forms;
}

base::Result<BoardInput> inputAt(const fs::path& path, const ReadOptions& options) {
    ASSIGN_OR_RETURN(std::string head, readHead(path));
    return BoardInput{path, std::move(head), {}, {}, {}, options.limits};
}

base::Status checkFormat(const ReadOptions& options) {
    const std::vector<std::string> keys = formatKeys();
    if (!options.format.empty() && std::ranges::find(keys, options.format) == keys.end()) {
        return base::Error{base::ErrorCode::BadUsage, "there is no format " + options.format};
    }
    return base::Done{};
}

base::Result<ReadBoard> readAsItIs(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    ASSIGN_OR_RETURN(BoardInput input, inputAt(path, options));
    ASSIGN_OR_RETURN(Forms forms, findForms(input, options, progress));
    const BoardForm chosen = forms.front();
    if (!input.archive) {
        reportUnusedMap(options, *chosen.format, input);
        ASSIGN_OR_RETURN(auto document, chosen.format->read(input, options, progress));
        return ReadBoard{std::move(document), chosen.format};
    }
    if (forms.size() == 1) {
        forms.clear();
    } else if (options.onlyAsks && options.format.empty() && options.member.empty()) {
        return ReadBoard{nullptr, chosen.format, std::move(forms)};
    } else {
        reportOthers(forms, input);
    }
    warnOfOthers(*chosen.format, input);
    reportUnusedMap(options, *chosen.format, input);
    ASSIGN_OR_RETURN(auto document, readForm(input, chosen, options, progress));
    return ReadBoard{std::move(document), chosen.format, std::move(forms)};
}

}  // namespace

std::span<const BoardFormat> knownFormats() {
    static const std::array kFormats = {
        BoardFormat{
            "ODB++ job", {".tgz", ".tar.gz", ".tar", ".zip"}, "an ODB++ matrix", nullptr, readOdb, "odb", odb::jobsIn},
        BoardFormat{"IPC-2581",
                    {".xml", ".cvg", ".xml.gz", ".cvg.gz"},
                    "an IPC-2581 file",
                    isIpc,
                    readIpc,
                    "ipc2581",
                    ipc2581::filesIn},
        BoardFormat{"KiCad board", {".kicad_pcb"}, "a KiCad board", isKicad, readKicad, "kicad", kicad::boardsOf, true},
        BoardFormat{"Gerber job",
                    {".zip", ".gbrjob", ".gbr", ".ger", ".gtl", ".gbl", ".art", ".pho", ".gdo", ".drl", ".xln"},
                    "Gerber images",
                    isGerber,
                    readGerber,
                    "gerber",
                    gerber::jobsIn},
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
    const std::string name = base::lowerCase(path.filename().string());
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

base::Result<const BoardFormat*> formatAt(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    RETURN_IF_ERROR(checkFormat(options));
    ASSIGN_OR_RETURN(BoardInput input, inputAt(path, options));
    ASSIGN_OR_RETURN(const Forms forms, findForms(input, options, progress));
    return forms.front().format;
}

base::Result<ReadBoard> readAnyBoard(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    RETURN_IF_ERROR(checkFormat(options));
    ASSIGN_OR_RETURN(ReadBoard board, readAsItIs(path, options, progress));
    if (board.document && options.inferNets) {
        ASSIGN_OR_RETURN(board.document, withInferredNets(*board.document, progress));
    }
    return board;
}

Board readBoard(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    ASSIGN_OR_RETURN(ReadBoard board, readAnyBoard(path, options, progress));
    return std::move(board.document);
}

}  // namespace model
