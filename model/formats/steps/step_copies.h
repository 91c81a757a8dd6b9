#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "model/board/document_builder.h"

/// Copies of steps on the step that holds them (panels), whatever the job is written in.
namespace model::formats {

/// A copy of a step as the job lays it down.
struct PlannedCopy {
    std::size_t step = 0;  ///< row of the job's steps
    Placement placement;
    bool isFlipped = false;
    std::uint32_t line = 0;  ///< where the job says so
};

/// What one step holds.
struct CopyPlan {
    std::vector<PlannedCopy> copies;
    std::size_t total = 1;  ///< the step itself and all copies below it
    int height = 0;         ///< 0 for a step without copies, else one more than the highest of those it holds
};

/// By step; those whose copies a step holds are there before it.
using StepDocuments = std::vector<std::shared_ptr<const Document>>;

/// Builds the steps that step 0 holds copies of, each once: those without copies first, then those that hold only
/// these, and so on; steps of one height side by side. `build` makes the document of a step; false as soon as it made
/// none (cancelled).
[[nodiscard]] bool buildCopiedSteps(const std::vector<CopyPlan>& plans, StepDocuments& documents,
                                    const std::function<std::shared_ptr<const Document>(std::size_t step)>& build);

/// The copies of one step while its document is built.
class StepCopies {
public:
    /// Has the layer of a step negative features?
    using HasNegatives = std::function<bool(std::size_t step, LayerId layer)>;

    /// `path` is where the job says what copies there are. All must live as long as this.
    StepCopies(DocumentBuilder& builder, const CopyPlan& plan, const StepDocuments& documents, std::string_view path,
               HasNegatives hasNegatives)
        : m_builder(builder),
          m_plan(plan),
          m_documents(documents),
          m_path(path),
          m_hasNegatives(std::move(hasNegatives)) {}

    /// Adds them to the document. Those that leave the coordinate range are reported and left out; what a flipped copy
    /// has on a layer without a counterpart on the other side is reported.
    void add();

    /// Paint order holds within a step only; what lies over a copy is reported: own negative features (`painted` and
    /// `negatives` as in painting.h), and own elements under negative features of a copy.
    void reportOwnNegatives(LayerId layer, std::string_view file, const Document& painted,
                            std::span<const std::uint8_t> negatives);
    void reportNegativesOfCopies(LayerId layer, std::string_view file);
    /// Copies of a step share its document, so what a negative layer of a copy clears around it is not taken away from
    /// the copy beside it; where it lies over copper there, that is reported.
    void reportClearedNeighbours(LayerId layer);

private:
    [[nodiscard]] bool isInRange(const PlannedCopy& copy, const Document& step);
    void reportOneSided(const PlannedCopy& copy, const Document& step);
    [[nodiscard]] std::vector<Box> copiesOn(LayerId layer, bool withNegatives) const;

    DocumentBuilder& m_builder;
    const CopyPlan& m_plan;
    const StepDocuments& m_documents;
    std::string_view m_path;
    HasNegatives m_hasNegatives;
    std::vector<std::uint32_t> m_lines;  ///< by Document::instances: where the job says so
};

/// The messages of a step that is placed as copies, as they read on the board: its elements are not the board's, so
/// each message points to where its element lies in the first copy.
[[nodiscard]] Diagnostics messagesOfCopies(const Document& step, const Document& board);

}  // namespace model::formats
