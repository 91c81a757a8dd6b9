#include "model/export/solids/step_export.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>
#include <vector>

#include "model/export/solids/step_assembly.h"
#include "model/export/solids/step_solid_text.h"
#include "model/text/file_writer.h"

namespace model {

namespace {

/// Text is handed to the file in pieces of about this size.
constexpr std::size_t kPiece = 1U << 18U;

StepEdges edgesOf(const StepOptions& options) {
    return options.hasPolylines ? StepEdges::Polylines : StepEdges::Single;
}

/// Writes the steps of a plan into one text.
class StepWriter {
public:
    StepWriter(const SolidPlan& plan, const StepOptions& options, FileWriter& file, base::Progress& progress)
        : m_plan(plan), m_options(options), m_file(file), m_progress(progress) {}

    base::Status write() {
        m_file.write(stepHeader(m_options.name, m_options.time, "Copperscope"));
        std::vector<StepProduct> steps;
        for (std::size_t i = 0; i < m_plan.steps.size(); ++i) {
            m_shapes.clear();
            m_step = static_cast<std::uint32_t>(i);
            steps.push_back(m_plan.choice.isOnePart ? addOnePart(m_plan.steps[i]) : addTree(m_plan.steps[i]));
        }
        placeCopies(steps);
        if (!isStopped()) {
            RETURN_IF_ERROR(checkAnyWritten(report.solids));
        }
        m_assembly.finish();
        passOn(0);
        m_file.write(stepFooter());
        if (m_progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
        }
        return m_file.commit();
    }

    SolidReport report;

private:
    /// A shape that is placed often.
    struct WrittenShape {
        StepId id = 0;             ///< 0: it has no solid
        std::string_view problem;  ///< ElementShells::problem
    };

    [[nodiscard]] bool isStopped() const { return m_progress.isCancelled() || !m_file.status().ok(); }

    void passOn(std::size_t atLeast) {
        if (m_text.text().size() >= atLeast) {
            m_file.write(m_text.text());
            m_text.clear();
        }
    }

    [[nodiscard]] std::string stepName(const StepSolids& step) const {
        const bool isBoard = m_step == 0;
        return (isBoard && !m_options.name.empty() ? m_options.name : step.document->job.step) +
               (step.isFlipped ? " (flipped)" : "") + (step.isMirrored != step.isFlipped ? " (mirrored)" : "");
    }

    StepProduct addTree(const StepSolids& step) {
        const StepProduct board = m_assembly.addGroup(stepName(step));
        StepProduct layer;
        LayerId current;
        for (const SolidGroup& group : step.groups) {
            if (group.layer != current) {
                current = group.layer;
                layer = m_assembly.addGroup(step.document->layer(current).name);
                m_assembly.place(layer, board, step.document->layer(current).name, m_solids.origin());
            }
            m_items.clear();
            addGroup(step, group);
            if (!m_items.empty()) {
                const std::string name = m_plan.nameOf(step, group);
                m_assembly.place(m_assembly.addPart(name, m_items), layer, name, m_solids.origin());
            }
        }
        return board;
    }

    StepProduct addOnePart(const StepSolids& step) {
        m_items.clear();
        for (const SolidGroup& group : step.groups) {
            addGroup(step, group);
        }
        return m_assembly.addPart(stepName(step), m_items);
    }

    /// Its items go to m_items.
    void addGroup(const StepSolids& step, const SolidGroup& group) {
        const StepColour colour = colourOf(step, group.layer);
        m_done += group.elements.count;
        m_progress.setFraction(static_cast<float>(m_done) / static_cast<float>(m_plan.elements));
        if (const auto merged = m_plan.mergedShellsOf(step, group)) {
            addMerged(step, group, *merged, colour);
            return;
        }
        for (std::uint32_t i = group.elements.first; i < group.elements.first + group.elements.count; ++i) {
            if (isStopped()) {
                return;
            }
            addElement(step, step.elements[i], colour);
            passOn(kPiece);
        }
    }

    void addMerged(const StepSolids& step, const SolidGroup& group, const MergedShells& merged,
                   const StepColour& colour) {
        const std::vector<StepId> solids = addShells(merged.shells, colour);
        m_items.insert(m_items.end(), solids.begin(), solids.end());
        if (merged.apart > 0 || merged.problems > 0) {
            report.missing.push_back({m_step, step.elements[group.elements.first],
                                      merged.problems > 0 ? "not all of the net's copper on this layer is solid"
                                                          : "not all of the net's copper on this layer was united"});
        }
    }

    void addElement(const StepSolids& step, ElementId element, const StepColour& colour) {
        const auto shared = m_options.isWrittenOut ? std::nullopt : m_plan.sharedShapeOf(step, element);
        if (shared) {
            addPlaced(step, element, *shared, colour);
            return;
        }
        const ElementShells made = m_plan.shellsOf(step, element);
        const std::vector<StepId> solids = addShells(made.shells, colour);
        m_items.insert(m_items.end(), solids.begin(), solids.end());
        if (!made.problem.empty()) {
            report.missing.push_back({m_step, element, made.problem});
        }
    }

    void addPlaced(const StepSolids& step, ElementId element, const SharedShape& shared, const StepColour& colour) {
        const auto [found, isNew] = m_shapes[shared.key].try_emplace(colour);
        if (isNew) {
            const ElementShells made = m_plan.shellsOf(step, shared.key);
            found->second.problem = made.problem;
            found->second.id = made.shells.empty() ? 0 : m_assembly.addShape(addShells(made.shells, colour));
        }
        if (found->second.id != 0) {
            m_items.push_back(m_assembly.addCopy(found->second.id, m_solids.placementOf(shared.placement)));
            ++report.copies;
        }
        if (!found->second.problem.empty()) {
            report.missing.push_back({m_step, element, found->second.problem});
        }
    }

    std::vector<StepId> addShells(const std::vector<Shell>& shells, const StepColour& colour) {
        std::vector<StepId> solids;
        for (const Shell& shell : shells) {
            for (EdgeLoops& piece : splitLarge(shell.outline, m_options.limits)) {
                solids.push_back(m_solids.add({std::move(piece), shell.z}));
                m_assembly.colour(solids.back(), colour);
                ++report.solids;
                passOn(kPiece);
            }
        }
        return solids;
    }

    /// The board is the first step and the root; all others are placed in it.
    void placeCopies(const std::vector<StepProduct>& steps) {
        for (std::size_t i = 1; i < m_plan.copies.size(); ++i) {
            const SolidCopy& copy = m_plan.copies[i];
            const std::string name = m_plan.steps[copy.step].document->job.step + " " + std::to_string(i);
            m_assembly.place(steps[copy.step], steps.front(), name, m_solids.placementOf(copy.placement));
        }
    }

    [[nodiscard]] StepColour colourOf(const StepSolids& step, LayerId layer) const {
        const std::size_t row = step.document->layerOfCopy(layer, step.isFlipped).row();
        return row < m_options.looks.size() ? StepColour{m_options.looks[row].rgb, m_options.looks[row].opacity}
                                            : StepColour{};
    }

    const SolidPlan& m_plan;
    const StepOptions& m_options;
    FileWriter& m_file;
    base::Progress& m_progress;
    StepText m_text;
    StepSolidText m_solids{m_text, edgesOf(m_options)};
    StepAssembly m_assembly{m_text, m_solids.origin()};
    /// Of the step that is being written: its solids have their colour, so there is one for each.
    std::unordered_map<ShapeKey, std::map<StepColour, WrittenShape>, ShapeKeyHash> m_shapes;
    std::uint32_t m_step = 0;
    std::vector<StepId> m_items;
    std::uint64_t m_done = 0;
};

/// Measured on boards of all kinds.
constexpr double kBytesOfSolid = 47.0;
constexpr double kBytesOfCopy = 180.0;
constexpr double kBytesOfGroup = 900.0;
constexpr double kBytesPerSecond = 150e6;
/// Numbers of entities are longer in a whole file than in a sample.
constexpr double kLongerNumbers = 1.1;
/// Solids that are made for an estimate of a step, at most about so many.
constexpr double kSampled = 1000.0;
/// What a track or a pad counts, in corners.
constexpr double kCornersOfPlain = 4.0;

/// How much of the file an element may be: its corners as they were drawn, and what may be drilled through it.
double cornersOf(const StepSolids& step, ElementId element) {
    const Document& document = *step.document;
    if (document.elements.kind[element.row()] != ElementKind::Area) {
        return kCornersOfPlain;
    }
    const LayerId layer = document.elements.layer[element.row()];
    const auto holes = static_cast<double>(step.holes->countNear(layer, document.boxOf(element)));
    const ShapeId shape = document.areas[document.elements.geometry[element.row()]].shape;
    double corners = kCornersOfPlain + holes;
    for (const Contour& contour : document.shapes.contoursOf(shape)) {
        corners += contour.nodeCount;
    }
    return corners;
}

/// How large a step becomes: what is placed often is written to be measured, and of the rest a sample.
class StepSizes {
public:
    StepSizes(const SolidPlan& plan, const StepOptions& options, const base::Progress& progress)
        : m_plan(plan), m_options(options), m_progress(progress) {}

    [[nodiscard]] bool isStopped() const { return m_progress.isCancelled(); }

    double of(const StepSolids& step) {
        double bytes = kBytesOfGroup * static_cast<double>(step.groups.size());
        std::vector<ElementId> single;
        for (std::size_t i = 0; i < step.elements.size() && !isStopped(); ++i) {
            const ElementId element = step.elements[i];
            if (!m_options.isWrittenOut && m_plan.sharedShapeOf(step, element)) {
                bytes += kBytesOfCopy;
            } else {
                single.push_back(element);
            }
        }
        return bytes + sharedBytes(step) + sampledBytes(step, single);
    }

private:
    double bytesOf(const std::vector<Shell>& shells) {
        double bytes = 0.0;
        for (const Shell& shell : shells) {
            for (EdgeLoops& piece : splitLarge(shell.outline, m_options.limits)) {
                m_text.clear();
                m_solids.add({std::move(piece), shell.z});
                bytes += kBytesOfSolid + kLongerNumbers * static_cast<double>(m_text.text().size());
            }
        }
        return bytes;
    }

    double sharedBytes(const StepSolids& step) {
        double bytes = 0.0;
        for (const auto& [key, uses] : step.uses) {
            const bool isShared = uses > 1 && !m_options.isWrittenOut && !isStopped();
            bytes += isShared ? bytesOf(m_plan.shellsOf(step, key).shells) : 0.0;
        }
        return bytes;
    }

    /// A sample in which each element appears as often as it has corners, so that planes, which are most of a file, are
    /// all in it.
    double sampledBytes(const StepSolids& step, std::span<const ElementId> elements) {
        std::vector<double> corners;
        corners.reserve(elements.size());
        for (std::size_t i = 0; i < elements.size() && !isStopped(); ++i) {
            corners.push_back(cornersOf(step, elements[i]));
        }
        const double stride = std::max(std::accumulate(corners.begin(), corners.end(), 0.0) / kSampled, 1.0);
        double bytes = 0.0;
        double next = stride / 2;
        for (std::size_t i = 0; i < elements.size() && !isStopped(); ++i) {
            next -= corners[i];
            if (next < 0) {
                const double picks = std::floor(-next / stride) + 1;
                next += picks * stride;
                bytes += picks * stride / corners[i] * bytesOf(m_plan.shellsOf(step, elements[i]).shells);
            }
        }
        return bytes;
    }

    const SolidPlan& m_plan;
    const StepOptions& m_options;
    const base::Progress& m_progress;
    StepText m_text;
    StepSolidText m_solids{m_text, edgesOf(m_options)};
};

}  // namespace

base::Result<StepEstimate> estimateStep(const SolidPlan& plan, const StepOptions& options,
                                        const base::Progress& progress) {
    StepEstimate estimate;
    StepSizes sizes(plan, options, progress);
    for (const StepSolids& step : plan.steps) {
        estimate.bytes += sizes.of(step);
        if (sizes.isStopped()) {
            return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
        }
    }
    estimate.seconds = estimate.bytes / kBytesPerSecond;
    return estimate;
}

base::Status checkAnyWritten(std::uint64_t count) {
    if (count == 0) {
        return base::Error{base::ErrorCode::OutputFailed, "nothing useful came out: no element has a solid"};
    }
    return base::Done{};
}

base::Result<SolidReport> exportStep(const SolidPlan& plan, const StepOptions& options,
                                     const std::filesystem::path& path, base::Progress& progress) {
    progress.beginPhase("Writing solids");
    FileWriter file(path, options.isPacked ? FileWriter::Packing::Gzip : FileWriter::Packing::None);
    StepWriter writer(plan, options, file, progress);
    RETURN_IF_ERROR(writer.write());
    writer.report.bytes = file.packedSize();
    return std::move(writer.report);
}

}  // namespace model
