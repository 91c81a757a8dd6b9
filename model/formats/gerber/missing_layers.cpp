#include "model/formats/gerber/missing_layers.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "model/base/ascii.h"

namespace model::gerber {

namespace {

constexpr std::size_t kListed = 5;  ///< names in a message
constexpr int kMostCopper = 200;    ///< numbers above say nothing

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), kListed); ++i) {
        list += (i == 0 ? "" : ", ") + names[i];
    }
    return list + (names.size() > kListed ? ", …" : "");
}

void reportCopper(const std::vector<ReadFile>& files, const BoardFiles& board, Diagnostics& diagnostics) {
    std::set<int> numbers;
    const ReadFile* last = nullptr;
    for (const std::size_t row : board.files) {
        const FileRole& role = files[row].role;
        const bool isCopper = files[row].isImage() && role.kind == FileRole::Kind::Copper;
        if (isCopper && role.isCountedFromTop && role.order > 0 && role.order <= kMostCopper) {
            last = last == nullptr || role.order > last->role.order ? &files[row] : last;
            numbers.insert(role.order);
        } else if (isCopper && role.side == LayerSide::Top) {
            numbers.insert(1);  // its name says where it is, without a number
        }
    }
    std::vector<std::string> missing;
    for (int i = 1; last != nullptr && i < last->role.order; ++i) {
        if (!numbers.contains(i)) {
            missing.push_back(std::to_string(i));
        }
    }
    if (!missing.empty()) {
        diagnostics.report(Severity::Error, last->path, 0,
                           "the file draws copper layer " + std::to_string(last->role.order) +
                               ", but no file draws copper layer " + listed(missing));
    }
}

void reportGaps(const std::vector<ReadFile>& files, const BoardFiles& board, Diagnostics& diagnostics) {
    for (const std::size_t row : innerBehindGaps(files, board)) {
        const int number = files[row].role.order;
        diagnostics.report(Severity::Warning, files[row].path, 0,
                           "the file is taken as inner copper " + std::to_string(number) +
                               ", but no file as inner copper " + std::to_string(number - 1) +
                               ": the order of copper layers is doubtful, or this is none of the board");
    }
}

/// Is the board less without it: what would be held against limits? Fabricators often get no paste, and drawings are no
/// part of the board.
bool isOfBoard(const FileRole& role) {
    using Kind = FileRole::Kind;
    return role.kind == Kind::Copper || role.kind == Kind::SolderMask || role.kind == Kind::Legend ||
           role.kind == Kind::Profile || role.kind == Kind::Drill || role.kind == Kind::Rout;
}

/// Does a file draw it under another name than the job file knows?
bool isDrawn(const FileRole& listed, const std::vector<ReadFile>& files, const BoardFiles& board) {
    return std::ranges::any_of(board.files, [&](std::size_t row) {
        const FileRole& role = files[row].role;
        const bool isSamePlace = role.side == listed.side && role.plating == listed.plating;
        const bool isSameCopper = role.order == listed.order || role.order == 0 || !role.isCountedFromTop;
        return role.kind == listed.kind && isSamePlace && (role.kind != FileRole::Kind::Copper || isSameCopper);
    });
}

void reportListed(const ReadFile& jobFile, const std::vector<ReadFile>& files, const BoardFiles& board,
                  Diagnostics& diagnostics) {
    std::vector<std::string> missing;
    bool isBoardLess = false;
    for (const auto& [name, function] : jobFile.job.functions) {
        const bool isThere = std::ranges::any_of(
            files, [&, &name = name](const ReadFile& file) { return base::equalsIgnoringCase(file.name(), name); });
        if (isThere) {
            continue;
        }
        const std::optional<FileRole> role = roleOfFunction(function);
        isBoardLess = isBoardLess || (role && isOfBoard(*role) && !isDrawn(*role, files, board));
        missing.push_back(name);
    }
    if (!missing.empty()) {
        diagnostics.report(isBoardLess ? Severity::Error : Severity::Warning, jobFile.path, 0,
                           "the job file lists images that the job does not hold: " + listed(missing));
    }
}

}  // namespace

std::vector<std::size_t> innerBehindGaps(const std::vector<ReadFile>& files, const BoardFiles& board) {
    const auto isCopper = [&](std::size_t row) {
        return files[row].isImage() && files[row].role.kind == FileRole::Kind::Copper;
    };
    std::set<int> numbers = {0, 1};
    for (const std::size_t row : board.files) {
        if (isCopper(row)) {
            numbers.insert(files[row].role.order);
        }
    }
    std::vector<std::size_t> found;
    for (const std::size_t row : board.files) {
        const FileRole& role = files[row].role;
        const bool isNumbered = isCopper(row) && role.side == LayerSide::Inner && role.order > 0 &&
                                !role.isCountedFromTop && !role.mayLeaveOutNumbers;
        if (isNumbered && !numbers.contains(role.order - 1)) {
            found.push_back(row);
        }
    }
    return found;
}

void reportMissingLayers(const std::vector<ReadFile>& files, const BoardFiles& board, Diagnostics& diagnostics) {
    reportCopper(files, board, diagnostics);
    reportGaps(files, board, diagnostics);
    for (const std::size_t row : board.files) {
        if (files[row].kind == ReadFile::Kind::Job) {
            reportListed(files[row], files, board, diagnostics);
        }
    }
}

}  // namespace model::gerber
