#include "model/export/drawings/drawing.h"

#include <algorithm>
#include <set>

#include "model/base/parallel.h"
#include "model/board/layers.h"
#include "model/solids/shells/area_shell.h"
#include "model/solids/shells/drawn_outlines.h"

namespace model {

namespace {

constexpr const char* kOutlineName = "board outline";
constexpr std::uint32_t kAtOnce = 8192;  // elements whose outlines are found side by side, then drawn one by one

bool hasContours(const Layer& layer) {
    const LayerGroup group = groupOf(layer);
    return group == LayerGroup::Mechanical || group == LayerGroup::Components || group == LayerGroup::Dielectric;
}

/// What a pen drew is as wide as the pen: a line along its edge would make it wider.
RegionPaint paintOf(const Document& document, ElementId element, const DrawnLayer& drawn) {
    return drawn.hasContours && document.elements.kind[element.row()] == ElementKind::Area ? RegionPaint::Contour
                                                                                           : RegionPaint::Filled;
}

/// As large as there is room for it along the longer side of its body, but no larger than print on boards.
DrawnName nameIn(const Box& body, const std::string& text) {
    constexpr double kMost = 1.5e6;
    constexpr double kOfLength = 0.9;
    constexpr double kOfWidth = 0.7;
    constexpr double kTall = 1.2;  // nearly square bodies are read to the right
    const auto width = static_cast<double>(body.width());
    const auto height = static_cast<double>(body.height());
    const double letters = kNameLetterWidth * static_cast<double>(text.size());
    DrawnName name;
    name.text = text;
    name.centre = {static_cast<double>(body.min.x) + 0.5 * width, static_cast<double>(body.min.y) + 0.5 * height};
    name.isUpright = height > kTall * width;
    const double along = name.isUpright ? height : width;
    const double across = name.isUpright ? width : height;
    name.height = std::min({kMost, kOfWidth * across, kOfLength * along / letters});
    return name;
}

/// Draws what of a document's layer lies on a layer of the board.
class Drawer {
public:
    Drawer(const Document& board, DrawingForm& form, const FileWriter& file, base::Progress& progress)
        : m_form(form), m_file(file), m_progress(progress), m_tree(unfoldCopies(board)) {
        for (const StepCopy& copy : m_tree.copies) {
            m_placements[placementsRow(copy.step, copy.isFlipped)].push_back(copy.placement);
        }
    }

    [[nodiscard]] Box boxOf(const DrawnLayer& drawn) const {
        Box box;
        forEachSource(drawn, [&](std::uint32_t step, LayerId layer, const std::vector<Placement>& placements) {
            const Box own = boxIn(*m_tree.steps[step], layer);
            for (const Placement& placement : placements) {
                box.include(own.isEmpty() ? own : placement.boxOf(own));
            }
        });
        return box;
    }

    base::Status draw(const DrawnLayer& drawn) {
        m_form.beginLayer(drawn);
        base::Status status = base::Done{};
        forEachSource(drawn, [&](std::uint32_t step, LayerId layer, const std::vector<Placement>& placements) {
            if (status && !layer.isValid()) {
                drawOutline(step, placements);
            } else if (status) {
                status = drawElements(drawn, step, layer, placements);
            }
        });
        m_form.endLayer();
        return status ? stateOfWork() : status;
    }

    DrawingReport report;

private:
    static std::size_t placementsRow(std::uint32_t step, bool isFlipped) { return 2 * step + (isFlipped ? 1 : 0); }

    [[nodiscard]] base::Status stateOfWork() const {
        if (m_progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
        }
        return m_file.status();
    }

    /// The layers of steps that end up on a layer, and where their step is placed so.
    template <class Visit>
    void forEachSource(const DrawnLayer& drawn, const Visit& visit) const {
        for (std::uint32_t step = 0; step < m_tree.steps.size(); ++step) {
            for (const bool isFlipped : {false, true}) {
                const std::vector<Placement>& placements = m_placements[placementsRow(step, isFlipped)];
                if (placements.empty()) {
                    continue;
                }
                if (!drawn.layer.isValid()) {
                    visit(step, LayerId{}, placements);
                }
                const Document& document = *m_tree.steps[step];
                for (std::size_t row = 0; drawn.layer.isValid() && row < document.layers.size(); ++row) {
                    if (document.layerOfCopy(LayerId{row}, isFlipped) == drawn.layer) {
                        visit(step, LayerId{row}, placements);
                    }
                }
            }
        }
    }

    static Box boxIn(const Document& document, LayerId layer) {
        Box box;
        if (!layer.isValid()) {
            return document.profile.isValid() ? document.shapes.shapes[document.profile.row()].box : box;
        }
        const Range range = document.layer(layer).elements;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            box.include(document.boxOf(ElementId{i}));
        }
        return box;
    }

    void add(const std::vector<EdgeLoops>& regions, const std::vector<Placement>& placements, RegionPaint paint) {
        for (const Placement& placement : placements) {
            for (const EdgeLoops& region : regions) {
                if (isIdentity(placement)) {
                    m_form.addRegion(region, paint);
                } else {
                    m_form.addRegion(placed(region, placement), paint);
                }
            }
        }
        report.regions += regions.size() * placements.size();
    }

    void drawOutline(std::uint32_t step, const std::vector<Placement>& placements) {
        const Document& document = *m_tree.steps[step];
        if (document.profile.isValid()) {
            add(areaOutlines(document.shapes, document.profile), placements, RegionPaint::Contour);
        }
    }

    base::Status drawElements(const DrawnLayer& drawn, std::uint32_t step, LayerId layer,
                              const std::vector<Placement>& placements) {
        const Range range = m_tree.steps[step]->layer(layer).elements;
        for (std::uint32_t i = 0; i < range.count; i += kAtOnce) {
            drawSome(drawn, step, {range.first + i, std::min(kAtOnce, range.count - i)}, placements);
            RETURN_IF_ERROR(stateOfWork());
        }
        addNames(step, layer, placements);
        return base::Done{};
    }

    /// Those of the components whose bodies lie on a layer of a step.
    void addNames(std::uint32_t step, LayerId layer, const std::vector<Placement>& placements) {
        const Document& document = *m_tree.steps[step];
        for (const Body& body : document.bodies) {
            const bool isHere = body.component.isValid() && document.elements.layer[body.element.row()] == layer;
            const std::string refdes = isHere ? document.components[body.component.row()].refdes : "";
            for (std::size_t i = 0; i < placements.size() && !refdes.empty(); ++i) {
                m_form.addName(nameIn(placements[i].boxOf(document.boxOf(body.element)), refdes));
            }
        }
    }

    void drawSome(const DrawnLayer& layer, std::uint32_t step, Range elements,
                  const std::vector<Placement>& placements) {
        std::vector<ElementOutlines> drawn(elements.count);
        base::parallelFor(elements.count, [&](std::size_t i) {
            if (!m_progress.isCancelled()) {
                drawn[i] = drawnOutlinesOf(*m_tree.steps[step], ElementId{elements.first + i});
            }
        });
        for (std::uint32_t i = 0; i < elements.count && !m_progress.isCancelled(); ++i) {
            const ElementId element{elements.first + i};
            if (drawn[i].regions.empty() && !drawn[i].problem.empty()) {
                note(step, element, drawn[i].problem);
            }
            add(drawn[i].regions, placements, paintOf(*m_tree.steps[step], element, layer));
        }
    }

    void note(std::uint32_t step, ElementId element, std::string_view reason) {
        if (m_noted.emplace(step, element).second) {
            const Document& document = *m_tree.steps[step];
            const Layer& layer = document.layer(document.elements.layer[element.row()]);
            report.notDrawn.push_back(
                {layer.name, element, layer.file, document.elements.line[element.row()], reason, step});
        }
    }

    DrawingForm& m_form;
    const FileWriter& m_file;
    base::Progress& m_progress;
    StepTree m_tree;
    std::vector<std::vector<Placement>> m_placements{2 * m_tree.steps.size()};  ///< see placementsRow
    std::set<std::pair<std::uint32_t, ElementId>> m_noted;
};

std::vector<DrawnLayer> chosenLayers(const Document& board, const DrawingOptions& options) {
    std::vector<DrawnLayer> chosen;
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        const Layer& layer = board.layers[row];
        const bool isChosen =
            options.layers.empty() ? !layer.isSynthetic : row < options.layers.size() && options.layers[row];
        if (isChosen) {
            const std::uint32_t colour = row < options.colours.size() ? options.colours[row] : 0;
            chosen.push_back({LayerId{row}, layer.name, colour, hasContours(layer), layer.side == LayerSide::Bottom});
        }
    }
    if (options.hasOutline) {
        chosen.push_back({{}, kOutlineName, options.outlineColour, true, false});
    }
    return chosen;
}

void sortBottomFirst(const Document& board, std::vector<DrawnLayer>& layers) {
    const auto rank = [&](const DrawnLayer& drawn) {
        return !drawn.layer.isValid() ? 2 : groupOf(board.layer(drawn.layer)) == LayerGroup::Drill ? 1 : 0;
    };
    std::ranges::reverse(layers);
    std::ranges::stable_sort(layers, {}, rank);
}

}  // namespace

base::Result<DrawingReport> drawLayers(const Document& board, const DrawingOptions& options, DrawingOrder order,
                                       DrawingForm& form, const FileWriter& file, base::Progress& progress) {
    progress.beginPhase("Drawing layers");
    Drawer drawer(board, form, file, progress);
    Drawing drawing{board.job.name, {}, {}};
    for (DrawnLayer& layer : chosenLayers(board, options)) {
        const Box box = drawer.boxOf(layer);
        if (!box.isEmpty()) {
            drawing.box.include(box);
            drawing.layers.push_back(std::move(layer));
        }
    }
    // The outline is there whatever is chosen.
    const bool isLeft = std::ranges::any_of(drawing.layers, [](const DrawnLayer& one) { return one.layer.isValid(); });
    if (drawing.layers.empty() || (!isLeft && !options.layers.empty())) {
        return base::Error{base::ErrorCode::BadUsage,
                           "nothing on the board is left to export with these choices: the layers are empty"};
    }
    if (order == DrawingOrder::BottomFirst) {
        sortBottomFirst(board, drawing.layers);
    }
    form.begin(drawing);
    for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
        RETURN_IF_ERROR(drawer.draw(drawing.layers[i]));
        progress.setFraction(static_cast<float>(i + 1) / static_cast<float>(drawing.layers.size()));
    }
    form.end();
    RETURN_IF_ERROR(file.status());
    drawer.report.layers = std::move(drawing.layers);
    return std::move(drawer.report);
}

}  // namespace model
