#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/board/copies.h"

/// Selections that outlive the ids of their elements: another version of the board, or of the reader, numbers them
/// anew. Nets are known by their names, elements by where they are.
namespace model::session {

/// An element by its layer, kind and box in the coordinates of the board.
struct SavedElement {
    std::string layer;
    ElementKind kind = ElementKind::Line;
    Box box;  ///< nm
    bool operator==(const SavedElement&) const = default;
};

struct NetName {
    std::string step;  ///< the one whose net it is, of the board or placed on it
    std::string name;
    bool operator==(const NetName&) const = default;
};

struct SavedSelection {
    std::vector<NetName> nets;
    std::vector<SavedElement> elements;
    bool operator==(const SavedSelection&) const = default;
};

/// No selection with more elements is saved: a session is to stay a small file.
inline constexpr std::size_t kMostSavedElements = 4000;

[[nodiscard]] SavedSelection saveSelection(const StepTree& board, std::span<const BoardElement> elements,
                                           std::span<const BoardNet> nets);

/// What of a selection is on the board, in rising order, and what is not.
struct FoundSelection {
    std::vector<BoardElement> elements;
    std::vector<BoardNet> nets;
    std::size_t missingElements = 0;
    std::vector<std::string> missingNets;
};

/// Elements that lie where another one of the same kind lies are found as often as they were saved. Visits every
/// element of the board once.
[[nodiscard]] FoundSelection findSelection(const StepTree& board, const SavedSelection& saved);

/// Of its name, as toString has it.
[[nodiscard]] std::optional<ElementKind> kindOf(const std::string& word);

}  // namespace model::session
