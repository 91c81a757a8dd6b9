#include "model/clearance/clearance.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "model/base/parallel.h"
#include "model/geometry/box_index.h"
#include "model/geometry/distance.h"
#include "model/geometry/figures.h"

namespace model {

namespace {

constexpr double kFirstReach = 100e3;  ///< 0.1 mm: what most boards are made with
/// Figures per task: small enough to share out one heavy layer, large enough to be worth a task.
constexpr std::size_t kFiguresPerTask = 512;

/// By layer and nets.
using Narrowest = std::map<std::tuple<LayerId, NetId, NetId>, Clearance>;

bool isNarrower(const Clearance& a, const Clearance& b) {
    const auto rank = [](const Clearance& c) { return std::tuple(c.gap.distance, c.layer, c.netA, c.netB, c.a, c.b); };
    return rank(a) < rank(b);
}

/// Keeps the narrower one of two for the same nets and layer.
void keep(Narrowest& narrowest, const Clearance& found) {
    const auto [place, isFirst] = narrowest.try_emplace({found.layer, found.netA, found.netB}, found);
    if (!isFirst && isNarrower(found, place->second)) {
        place->second = found;
    }
}

/// The copper of one layer, and the plated holes through it.
class Sheet {
public:
    Sheet(const Document& document, LayerId layer) : m_document(document), m_layer(layer) {
        add(document.layer(layer), [](ElementId) { return true; });
        for (const Layer& drill : document.layers) {
            if (drill.spans(layer)) {
                add(drill, [&](ElementId hole) {
                    return isPlatedHole(document.elements.flags[hole.row()]) &&
                           document.platedSpanOf(hole).joins(layer);
                });
            }
        }
        for (std::size_t i = 0; i < m_figures.size(); ++i) {
            m_boxes.push_back(m_figures.box(i));
        }
        m_index.emplace_back(m_boxes);
    }

    [[nodiscard]] std::size_t size() const { return m_figures.size(); }
    [[nodiscard]] Box extent() const {
        Box extent;
        std::ranges::for_each(m_boxes, [&](const Box& box) { extent.include(box); });
        return extent;
    }

    /// The narrowest places between figures first … end - 1 and those behind them, at most `reach` wide.
    void search(std::size_t first, std::size_t end, double reach, const ClearanceQuestion& question,
                Narrowest& found) const {
        std::vector<std::uint32_t> near;
        for (std::size_t i = first; i < end; ++i) {
            near.clear();
            m_index.front().visit(m_boxes[i].grownBy(static_cast<Nm>(reach) + 1), [&](std::uint32_t j) {
                if (j > i && isWanted(netOf(i), netOf(j), question)) {
                    near.push_back(j);
                }
            });
            std::ranges::sort(near);
            for (const std::uint32_t j : near) {
                measure(i, j, reach, found);
            }
        }
    }

private:
    template <class IsWanted>
    void add(const Layer& layer, const IsWanted& isWanted) {
        for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
            if (isWanted(ElementId{i})) {
                m_figures.add(m_document, ElementId{i});
            }
        }
    }

    [[nodiscard]] NetId netOf(std::size_t figure) const {
        return m_document.elements.net[m_figures[figure].element.row()];
    }

    static bool isWanted(NetId a, NetId b, const ClearanceQuestion& question) {
        const auto [x, y] = question.between;
        const bool isAny = !x.isValid() && !y.isValid();
        return a != b && (isAny || (a == x && b == y) || (a == y && b == x));
    }

    void measure(std::size_t i, std::size_t j, double reach, Narrowest& found) const {
        const auto [first, second] = netOf(i) < netOf(j) ? std::pair(i, j) : std::pair(j, i);
        const auto known = found.find({m_layer, netOf(first), netOf(second)});
        const double limit = known == found.end() ? reach : known->second.gap.distance;
        const std::optional<Gap> gap = gapBetween(m_figures, first, m_figures, second, limit);
        const bool isTouchingNobody = gap && gap->distance <= kTouchNm && !netOf(second).isValid();
        if (gap && !isTouchingNobody) {
            keep(found,
                 {m_layer, netOf(first), netOf(second), m_figures[first].element, m_figures[second].element, *gap});
        }
    }

    const Document& m_document;
    LayerId m_layer;
    FigureTable m_figures;
    std::vector<Box> m_boxes;
    std::vector<BoxIndex> m_index;  ///< one, or none before it is made
};

struct Task {
    const Sheet* sheet = nullptr;
    std::size_t first = 0;
    std::size_t end = 0;
};

class Search {
public:
    Search(const Document& document, const ClearanceQuestion& question, base::Progress& progress)
        : m_question(question), m_progress(progress) {
        std::vector<LayerId> layers;
        for (std::size_t row = 0; row < document.layers.size(); ++row) {
            const bool isAsked = !question.layer.isValid() || question.layer == LayerId{row};
            if (document.layers[row].isCopper() && isAsked) {
                layers.emplace_back(row);
            }
        }
        std::vector<std::optional<Sheet>> sheets(layers.size());
        base::parallelFor(layers.size(), [&](std::size_t i) { sheets[i].emplace(document, layers[i]); });
        for (std::optional<Sheet>& sheet : sheets) {
            m_sheets.push_back(std::move(*sheet));
        }
        for (const Sheet& sheet : m_sheets) {
            m_extent.include(sheet.extent());
            for (std::size_t first = 0; first < sheet.size(); first += kFiguresPerTask) {
                m_tasks.push_back({&sheet, first, std::min(first + kFiguresPerTask, sheet.size())});
            }
        }
    }

    /// All nets that come closer than a reach which is doubled until they are enough. Empty after a cancel.
    [[nodiscard]] Narrowest run() const {
        const double farthest =
            std::hypot(static_cast<double>(m_extent.width()), static_cast<double>(m_extent.height()));
        const double last = std::min(m_question.below, farthest);
        for (double reach = std::min(kFirstReach, last);; reach = std::min(2 * reach, last)) {
            Narrowest found = within(reach);
            if (found.size() >= m_question.count || reach >= last || m_progress.isCancelled()) {
                return found;
            }
        }
    }

private:
    [[nodiscard]] Narrowest within(double reach) const {
        std::vector<Narrowest> found(m_tasks.size());
        std::atomic<std::size_t> done{0};
        base::parallelFor(m_tasks.size(), [&](std::size_t i) {
            if (!m_progress.isCancelled()) {
                m_tasks[i].sheet->search(m_tasks[i].first, m_tasks[i].end, reach, m_question, found[i]);
                m_progress.setFraction(static_cast<float>(++done) / static_cast<float>(m_tasks.size()));
            }
        });
        Narrowest all;
        for (const Narrowest& part : found) {
            for (const auto& [nets, clearance] : part) {
                keep(all, clearance);
            }
        }
        return all;
    }

    const ClearanceQuestion& m_question;
    base::Progress& m_progress;
    std::vector<Sheet> m_sheets;
    std::vector<Task> m_tasks;
    Box m_extent;
};

}  // namespace

base::Result<std::vector<Clearance>> narrowestClearances(const Document& document, const ClearanceQuestion& question,
                                                         base::Progress& progress) {
    progress.beginPhase("Measuring clearances");
    const Narrowest found = Search(document, question, progress).run();
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    std::vector<Clearance> clearances;
    for (const auto& [nets, clearance] : found) {
        if (clearance.gap.distance < question.below) {
            clearances.push_back(clearance);
        }
    }
    std::ranges::sort(clearances, isNarrower);
    clearances.resize(std::min(clearances.size(), question.count));
    return clearances;
}

}  // namespace model
