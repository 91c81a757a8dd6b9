#include "model/formats/gerber/board_groups.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

bool isCopper(const ReadFile& file) {
    return file.isImage() && file.role.kind == FileRole::Kind::Copper;
}

/// How many files of a group claim an outer copper layer, or an inner one by its number, that another one has.
std::size_t conflictsIn(const std::vector<ReadFile>& files, const std::vector<std::size_t>& group) {
    std::size_t count = 0;
    std::set<std::tuple<LayerSide, int>> seen;
    for (const std::size_t row : group) {
        const FileRole& role = files[row].role;
        const bool isOuter = role.side == LayerSide::Top || role.side == LayerSide::Bottom;
        const bool isTold = isCopper(files[row]) && (isOuter || role.order > 0);
        count += isTold && !seen.emplace(role.side, isOuter ? 0 : role.order).second ? 1 : 0;
    }
    return count;
}

using Groups = std::map<std::string, std::vector<std::size_t>>;

template <class Key>
Groups groupedBy(const std::vector<ReadFile>& files, Key key) {
    Groups groups;
    for (std::size_t row = 0; row < files.size(); ++row) {
        if (files[row].kind != ReadFile::Kind::Other && !files[row].isIgnored()) {
            groups[key(files[row])].push_back(row);
        }
    }
    return groups;
}

std::size_t conflicts(const std::vector<ReadFile>& files, const Groups& groups) {
    std::size_t count = 0;
    for (const auto& [key, group] : groups) {
        count += conflictsIn(files, group);
    }
    return count;
}

std::string folderOf(const ReadFile& file) {
    return upperCase(file.folder());
}

std::string boardKey(const ReadFile& file) {
    if (file.isImage()) {
        return boardOfName(file.name());
    }
    return upperCase(file.name().substr(0, file.name().find_last_of('.')));
}

/// The first way of telling boards apart that leaves no two files for one layer; else the one that leaves fewest.
Groups separated(const std::vector<ReadFile>& files) {
    const std::vector<Groups> ways = {
        groupedBy(files, [](const ReadFile&) { return std::string(); }),
        groupedBy(files, folderOf),
        groupedBy(files, boardKey),
        groupedBy(files, [](const ReadFile& file) { return folderOf(file) + "/" + boardKey(file); }),
    };
    const auto best = std::ranges::min_element(ways, {}, [&](const Groups& way) { return conflicts(files, way); });
    return *best;
}

std::size_t copperOf(const std::vector<ReadFile>& files, const std::vector<std::size_t>& group) {
    return static_cast<std::size_t>(
        std::ranges::count_if(group, [&](std::size_t row) { return isCopper(files[row]); }));
}

/// A group without copper belongs to the boards whose name its own begins with, or to all.
void attach(const std::string& key, const std::vector<std::size_t>& group, std::vector<BoardFiles>& boards) {
    const bool isAnyNamed = std::ranges::any_of(boards, [&](const BoardFiles& board) {
        return !board.name.empty() && key.find(board.name) != std::string::npos;
    });
    for (BoardFiles& board : boards) {
        if (!isAnyNamed || (!board.name.empty() && key.find(board.name) != std::string::npos)) {
            board.files.insert(board.files.end(), group.begin(), group.end());
            std::ranges::sort(board.files);
        }
    }
}

}  // namespace

std::vector<BoardFiles> boardsOf(const std::vector<ReadFile>& files) {
    const Groups groups = separated(files);
    std::vector<BoardFiles> boards;
    for (const auto& [key, group] : groups) {
        const std::size_t copper = copperOf(files, group);
        if (copper > 0 || groups.size() == 1) {
            boards.push_back({key, group, copper});
        }
    }
    if (boards.empty()) {
        // No copper at all: everything that can be drawn is one board.
        boards.push_back({});
        for (const auto& [key, group] : groups) {
            boards[0].files.insert(boards[0].files.end(), group.begin(), group.end());
        }
        std::ranges::sort(boards[0].files);
        return boards;
    }
    for (const auto& [key, group] : groups) {
        if (copperOf(files, group) == 0 && groups.size() > 1) {
            attach(key, group, boards);
        }
    }
    const auto objects = [&](const BoardFiles& board) {
        std::size_t count = 0;
        for (const std::size_t row : board.files) {
            count += isCopper(files[row]) ? files[row].image.features.size() : 0;
        }
        return count;
    };
    std::ranges::stable_sort(boards, [&](const BoardFiles& a, const BoardFiles& b) {
        return std::tuple(b.copperLayers, objects(b)) < std::tuple(a.copperLayers, objects(a));
    });
    return boards;
}

}  // namespace model::gerber
