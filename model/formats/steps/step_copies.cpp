#include "model/formats/steps/step_copies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "model/base/parallel.h"
#include "model/board/copies.h"
#include "model/board/holes.h"
#include "model/formats/steps/cleared_neighbours.h"

namespace model::formats {

namespace {

bool hasElements(const Layer& layer) {
    return std::ranges::any_of(layer.countsWithCopies, [](std::uint64_t count) { return count > 0; });
}

bool isBeyondRange(const Box& box, const Placement& placement) {
    constexpr double kReach = base::kMaxCoordinate;
    for (const Point corner : {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}) {
        const PointD placed = placement.apply(base::toDouble(corner));
        if (!box.isEmpty() && (std::abs(placed.x) > kReach || std::abs(placed.y) > kReach)) {
            return true;
        }
    }
    return false;
}

}  // namespace

bool buildCopiedSteps(const std::vector<CopyPlan>& plans, StepDocuments& documents,
                      const std::function<std::shared_ptr<const Document>(std::size_t step)>& build) {
    for (int height = 0; height < plans[0].height; ++height) {
        std::vector<std::size_t> rows;
        for (std::size_t step = 1; step < plans.size(); ++step) {
            if (plans[step].height == height) {
                rows.push_back(step);
            }
        }
        base::parallelFor(rows.size(), [&](std::size_t i) { documents[rows[i]] = build(rows[i]); });
        if (std::ranges::any_of(rows, [&](std::size_t row) { return documents[row] == nullptr; })) {
            return false;
        }
    }
    return true;
}

void StepCopies::add() {
    std::map<std::size_t, std::uint32_t> rows;
    for (const PlannedCopy& copy : m_plan.copies) {
        const std::shared_ptr<const Document>& step = m_documents[copy.step];
        if (!isInRange(copy, *step)) {
            continue;
        }
        const auto [location, isNew] = rows.try_emplace(copy.step);
        if (isNew) {
            location->second = m_builder.addStep(step);
        }
        m_builder.addInstance({location->second, copy.placement, copy.isFlipped});
        m_lines.push_back(copy.line);
        if (copy.isFlipped) {
            reportOneSided(copy, *step);
        }
    }
}

bool StepCopies::isInRange(const PlannedCopy& copy, const Document& step) {
    if (!isBeyondRange(step.extent, copy.placement) && !isBeyondRange(step.board, copy.placement)) {
        return true;
    }
    m_builder.diagnostics().report(Severity::Error, m_path, copy.line,
                                   "a panel copy lies outside of the coordinate range of ±1.07 m; it was left out");
    return false;
}

/// What a flipped copy has on a layer without a counterpart lies on no layer of the panel.
void StepCopies::reportOneSided(const PlannedCopy& copy, const Document& step) {
    for (const Layer& layer : step.layers) {
        const bool isStacked = layer.side == LayerSide::Top || layer.side == LayerSide::Bottom || isHoles(layer.type);
        if (hasElements(layer) && isStacked && !layer.opposite.isValid() && layer.context == LayerContext::Board) {
            m_builder.diagnostics().report(Severity::Warning, m_path, copy.line,
                                           "layer " + layer.name +
                                               " has no counterpart on the other side; in flipped copies it lies "
                                               "mirrored through the board");
        }
    }
}

/// Boxes of the copies with elements on this layer.
std::vector<Box> StepCopies::copiesOn(LayerId layer, bool withNegatives) const {
    std::vector<Box> boxes;
    for (const PlannedCopy& copy : m_plan.copies) {
        const LayerId from = m_builder.soFar().layerOfCopy(layer, copy.isFlipped);
        const Document& step = *m_documents[copy.step];
        if (withNegatives ? m_hasNegatives(copy.step, from) : hasElements(step.layer(from))) {
            boxes.push_back(copy.placement.boxOf(step.extent));
        }
    }
    return boxes;
}

void StepCopies::reportOwnNegatives(LayerId layer, std::string_view file, const Document& painted,
                                    std::span<const std::uint8_t> negatives) {
    const std::vector<Box> copies = copiesOn(layer, false);
    for (std::size_t i = 0; i < negatives.size() && !copies.empty(); ++i) {
        const Box box = painted.boxOf(ElementId{i});
        if (negatives[i] != 0 && std::ranges::any_of(copies, [&](const Box& copy) { return box.meets(copy); })) {
            return m_builder.diagnostics().report(
                Severity::Warning, file, painted.elements.line[i],
                "a negative feature reaches over a copy of another step; it takes nothing away from the copy");
        }
    }
}

void StepCopies::reportNegativesOfCopies(LayerId layer, std::string_view file) {
    const std::vector<Box> copies = copiesOn(layer, true);
    const Document& own = m_builder.soFar();
    const Range range = own.layer(layer).elements;
    for (std::uint32_t i = range.first; i < range.first + range.count && !copies.empty(); ++i) {
        const Box box = own.boxOf(ElementId{i});
        if (std::ranges::any_of(copies, [&](const Box& copy) { return box.meets(copy); })) {
            return m_builder.diagnostics().report(
                Severity::Warning, file, own.elements.line[i],
                "a copy of another step with negative features lies over this one; they take nothing away from it");
        }
    }
}

void StepCopies::reportClearedNeighbours(LayerId layer) {
    const Document& board = m_builder.soFar();
    if (const std::optional<std::size_t> copy = firstClearingNeighbours(board, layer)) {
        m_builder.diagnostics().report(
            Severity::Warning, m_path, m_lines[*copy],
            "layer " + board.layer(layer).name +
                " is negative: what a copy clears around it lies over copper of the copy beside it and is not taken "
                "away there");
    }
}

Diagnostics messagesOfCopies(const Document& step, const Document& board) {
    const StepTree tree = unfoldCopies(board);
    const auto first =
        std::ranges::find_if(tree.copies, [&](const StepCopy& copy) { return tree.steps[copy.step] == &step; });
    Diagnostics messages = step.diagnostics;
    for (std::size_t i = 0; i < messages.entries().size(); ++i) {
        const Diagnostic& message = messages.entries()[i];
        std::optional<Point> location = message.location;
        if (message.element.isValid()) {
            location = step.boxOf(message.element).middle();
        }
        const bool isPlaced = location && first != tree.copies.end();
        messages.locate(i, {}, isPlaced ? std::optional(first->placement.apply(*location)) : std::nullopt);
    }
    return messages;
}

}  // namespace model::formats
