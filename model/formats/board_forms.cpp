#include "model/formats/board_forms.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <tuple>
#include <utility>

#include "model/base/ascii.h"
#include "model/base/limits.h"
#include "model/formats/gerber/gerber_reader.h"
#include "model/formats/gerber/job_files.h"
#include "model/formats/odb/text/job_tree.h"

namespace model {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostListed = 8;

/// What KiCad packs from time to time by itself.
bool isSafetyCopy(std::string_view path) {
    return path.find("-backups/") != std::string_view::npos;
}

/// Those that lie open in the archive. `path` and `member` say where the archive is.
std::vector<BoardForm> openForms(const formats::Archive& archive, const fs::path& path, const std::string& member) {
    std::vector<BoardForm> forms;
    for (const BoardFormat& format : knownFormats()) {
        if (format.parts == nullptr) {
            continue;
        }
        for (formats::FormPart& part : format.parts(archive)) {
            forms.push_back({&format, path, member.empty() ? std::move(part.member) : member, std::move(part.contents),
                             part.isEmpty});
            if (!member.empty()) {
                break;  // its reader chooses among them
            }
        }
    }
    return forms;
}

/// Those in the file `row` of the input, an archive.
std::vector<BoardForm> packedForms(BoardInput& input, int row, base::Progress& progress) {
    const std::string& member = input.archive->path(row);
    const base::Result<formats::Bytes> bytes = input.archive->bytes(row);
    Diagnostics ignored;  // reading the board reports them
    const base::Result<formats::Archive> inner =
        bytes ? formats::Archive::unpack(bytes->view(), member, input.limits, progress, ignored) : bytes.error();
    if (!inner) {
        input.unpacking.report(Severity::Warning, member, 0, "the archive was not looked into: " + inner.error().text);
        return {};
    }
    std::error_code error;
    const bool isFile = fs::is_directory(input.path, error);
    return isFile ? openForms(*inner, input.path / member, {}) : openForms(*inner, input.path, member);
}

/// How a file begins; nothing of what is none or cannot be read.
std::string headOf(const fs::path& path) {
    std::error_code error;
    std::string head(fs::is_regular_file(path, error) ? std::size_t{4096} : 0, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

bool isGerberFile(const fs::path& path) {
    return gerber::looksLikeFile(headOf(path), path);
}

/// Rules and net classes, which lie beside a board of KiCad.
bool isNamedLikeProject(std::string_view path) {
    return path.ends_with(".kicad_pro") || path.ends_with(".kicad_dru");
}

gerber::ReadFile::Kind gerberKindOf(const fs::path& file) {
    return gerber::kindOf(headOf(file), file.filename().string());
}

/// May a file of a folder be read for a board there?
bool isRead(const formats::Archive& folder, const fs::path& file, const std::string& path) {
    if (isNamedLikeArchive(path) || isNamedLikeProject(path) || odb::isOfJob(folder, path)) {
        return true;
    }
    const BoardInput input{file, headOf(file), {}, {}, {}};
    const auto isBoard = [&](const BoardFormat& format) { return format.probe != nullptr && format.probe(input); };
    return std::ranges::any_of(knownFormats(), isBoard) || gerberKindOf(file) != gerber::ReadFile::Kind::Other;
}

bool isSameFile(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return fs::equivalent(a, b, error) && !error;
}

/// May the file be read for a board in the folder, or only for the Gerber job there?
bool isReadIn(const fs::path& folder, const fs::path& file, bool isOfGerber) {
    base::Progress progress;
    Diagnostics ignored;
    const base::Result<formats::Archive> files = formats::Archive::open(folder, {}, progress, ignored);
    if (!files) {
        return false;
    }
    return std::ranges::any_of(files->rows(), [&](const auto& entry) {
        const std::string& path = files->path(entry.second);
        return isSameFile(folder / path, file) &&
               (isOfGerber ? gerberKindOf(folder / path) != gerber::ReadFile::Kind::Other
                           : isRead(*files, folder / path, path));
    });
}

}  // namespace

fs::path sourceOf(const fs::path& path) {
    std::error_code error;
    return gerberKindOf(path) == gerber::ReadFile::Kind::Job ? fs::absolute(path, error).parent_path() : path;
}

std::vector<fs::path> filesBeside(const fs::path& path) {
    if (path.extension() != ".kicad_pcb") {
        return {};
    }
    return {fs::path(path).replace_extension(".kicad_pro"), fs::path(path).replace_extension(".kicad_dru")};
}

bool isReadFor(const fs::path& path, const fs::path& file) {
    const auto isFile = [&file](const fs::path& read) { return isSameFile(read, file); };
    if (isFile(path) || std::ranges::any_of(filesBeside(path), isFile)) {
        return true;
    }
    std::error_code error;
    const fs::path source = sourceOf(path);
    return fs::is_regular_file(file, error) && fs::is_directory(source, error) &&
           isReadIn(source, file, source != path);
}

fs::path jobOfFiles(std::span<const fs::path> files) {
    const fs::path folder = files.empty() ? fs::path() : files.front().parent_path();
    const bool isOneFolder =
        std::ranges::all_of(files, [&](const fs::path& file) { return file.parent_path() == folder; });
    return isOneFolder && std::ranges::count_if(files, isGerberFile) > 1 ? folder : fs::path();
}

bool isNamedLikeArchive(std::string_view name) {
    constexpr std::array<std::string_view, 4> kEndings = {".tgz", ".tar.gz", ".tar", ".zip"};
    const std::string lower = base::lowerCase(name);
    return std::ranges::any_of(kEndings, [&lower](std::string_view ending) { return lower.ends_with(ending); });
}

base::Result<std::vector<BoardForm>> formsIn(BoardInput& input, base::Progress& progress) {
    std::vector<BoardForm> forms = openForms(*input.archive, input.path, {});
    std::size_t archives = 0;
    for (const auto& [path, row] : input.archive->rows()) {
        if (progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "cancelled"};
        }
        if (!isNamedLikeArchive(path) || isSafetyCopy(path)) {
            continue;
        }
        if (++archives <= base::kMostInnerArchives) {
            std::ranges::move(packedForms(input, row, progress), std::back_inserter(forms));
        }
    }
    if (archives > base::kMostInnerArchives) {
        input.unpacking.report(Severity::Info, "", 0,
                               "there are " + std::to_string(archives) + " archives in it; the first " +
                                   std::to_string(base::kMostInnerArchives) + " were looked into, the limit");
    }
    std::error_code error;
    if (forms.size() > 1 && fs::is_directory(input.path, error)) {
        for (BoardForm& form : forms) {
            const bool isFile = form.path == input.path && !form.member.empty();
            form.path = isFile ? form.path / std::exchange(form.member, {}) : form.path;
        }
    }
    std::ranges::stable_sort(forms, {}, [](const BoardForm& form) {
        return std::tuple(form.isEmpty, !form.format->isDesign, form.format);  // rows of one table
    });
    return forms;
}

std::string fileOf(const BoardForm& form, const fs::path& path) {
    const std::string below = form.path == path ? std::string() : form.path.lexically_relative(path).generic_string();
    return below + (below.empty() || form.member.empty() ? "" : ": ") + form.member;
}

std::string othersOf(std::span<const BoardForm> forms, const fs::path& path) {
    std::string list;
    const std::size_t end = std::min(forms.size(), kMostListed + 1);
    for (std::size_t i = 1; i < end; ++i) {
        const BoardForm& form = forms[i];
        std::string how = fileOf(form, path);
        const std::span<const BoardForm> before = forms.first(i);
        if (std::ranges::find(before, form.format, &BoardForm::format) == before.end()) {
            how += (how.empty() ? "" : ", ") + ("--input-format " + std::string(form.format->key));
        }
        list += (i == 1 ? "" : ", ") + std::string(form.format->name) + (how.empty() ? "" : " (" + how + ")");
    }
    return list + (end < forms.size() ? " and " + std::to_string(forms.size() - end) + " more" : "");
}

std::string choiceText(std::span<const BoardForm> forms, const fs::path& path) {
    const std::string file = fileOf(forms.front(), path);
    return "read as " + std::string(forms.front().format->name) + (file.empty() ? "" : ", " + file) +
           "; what else is there: " + othersOf(forms, path);
}

}  // namespace model
