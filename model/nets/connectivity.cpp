#include "model/nets/connectivity.h"

#include <algorithm>
#include <atomic>

#include "model/base/disjoint_sets.h"
#include "model/base/parallel.h"
#include "model/figures/distance.h"
#include "model/figures/severed_tracks.h"

namespace model {

namespace {

/// Pieces per task: small enough to share out one heavy layer, large enough to be worth a task.
constexpr std::size_t kPiecesPerTask = 512;

struct Task {
    std::size_t plane = 0;
    std::size_t first = 0;
    std::size_t end = 0;
};

}  // namespace

base::Result<Connectivity> Connectivity::of(const Document& document, base::Progress& progress) {
    progress.beginPhase("Following the copper");
    Connectivity connectivity;
    connectivity.makeLayers(document, progress);
    if (progress.isCancelled() || !connectivity.findContacts(document, progress)) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    connectivity.joinIslands();
    return connectivity;
}

void Connectivity::makeLayers(const Document& document, const base::Progress& progress) {
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        if (document.layers[row].isCopper()) {
            m_layers.emplace_back().layer = LayerId{row};
        }
    }
    m_layers.emplace_back();
    const SeveringHoles holes(document);
    base::parallelFor(m_layers.size(), [&](std::size_t row) {
        LayerGeometry& plane = m_layers[row];
        const auto add = [&](const Layer& layer, auto isWanted) {
            for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
                if (!progress.isCancelled() && isWanted(document.elements.flags[i])) {
                    holes.addTo(plane.figures, ElementId{i});
                }
            }
        };
        if (plane.layer.isValid()) {
            add(document.layer(plane.layer), [](std::uint8_t) { return true; });
        } else {
            std::ranges::for_each(document.layers, [&](const Layer& layer) { add(layer, isPlatedHole); });
        }
        plane.boxes = plane.figures.outerBoxes();
        plane.index.emplace_back(plane.boxes);
    });
    m_start.push_back(0);
    for (const LayerGeometry& plane : m_layers) {
        m_start.push_back(m_start.back() + static_cast<std::uint32_t>(plane.figures.size()));
    }
}

bool Connectivity::findContacts(const Document& document, base::Progress& progress) {
    std::vector<Task> tasks;
    for (std::size_t plane = 0; plane < m_layers.size(); ++plane) {
        for (std::size_t first = 0; first < m_layers[plane].figures.size(); first += kPiecesPerTask) {
            tasks.push_back({plane, first, std::min(first + kPiecesPerTask, m_layers[plane].figures.size())});
        }
    }
    std::vector<std::vector<Contact>> found(tasks.size());
    std::atomic<std::size_t> done{0};
    base::parallelFor(tasks.size(), [&](std::size_t i) {
        if (progress.isCancelled()) {
            return;
        }
        const auto [plane, first, end] = tasks[i];
        m_layers[plane].layer.isValid() ? touchWithin(plane, first, end, found[i])
                                        : touchHoles(document, first, end, found[i]);
        progress.setFraction(static_cast<float>(++done) / static_cast<float>(tasks.size()));
    });
    for (const std::vector<Contact>& part : found) {
        m_contacts.insert(m_contacts.end(), part.begin(), part.end());
    }
    return !progress.isCancelled();
}

void Connectivity::touchWithin(std::size_t row, std::size_t first, std::size_t end, std::vector<Contact>& found) const {
    const LayerGeometry& plane = m_layers[row];
    std::vector<std::uint32_t> near;
    for (std::size_t i = first; i < end; ++i) {
        near.clear();
        plane.index.front().visit(plane.boxes[i], [&](std::uint32_t j) {
            if (j > i) {
                near.push_back(j);
            }
        });
        std::ranges::sort(near);
        for (const std::uint32_t j : near) {
            if (const auto spacing = spacingBetween(plane.figures, i, plane.figures, j, kTouchNm)) {
                found.push_back(
                    {m_start[row] + static_cast<std::uint32_t>(i), m_start[row] + j, spacing->from, plane.layer});
            }
        }
    }
}

void Connectivity::touchHoles(const Document& document, std::size_t first, std::size_t end,
                              std::vector<Contact>& found) const {
    const LayerGeometry& holes = m_layers.back();
    const std::uint32_t start = m_start[m_layers.size() - 1];
    for (std::size_t hole = first; hole < end; ++hole) {
        const PlatedSpan span = document.platedSpanOf(holes.figures[hole].element);
        for (std::size_t row = 0; row + 1 < m_layers.size(); ++row) {
            const LayerGeometry& plane = m_layers[row];
            if (!span.joins(plane.layer)) {
                continue;
            }
            std::vector<std::uint32_t> near;
            plane.index.front().visit(holes.boxes[hole], [&](std::uint32_t i) { near.push_back(i); });
            std::ranges::sort(near);
            for (const std::uint32_t i : near) {
                if (const auto spacing = spacingBetween(plane.figures, i, holes.figures, hole, kTouchNm)) {
                    found.push_back(
                        {m_start[row] + i, start + static_cast<std::uint32_t>(hole), spacing->from, plane.layer});
                }
            }
        }
    }
}

void Connectivity::joinIslands() {
    DisjointSets sets(pieceCount());
    for (const Contact& contact : m_contacts) {
        sets.join(contact.a, contact.b);
    }
    m_island.resize(pieceCount());
    for (std::uint32_t piece = 0; piece < pieceCount(); ++piece) {
        const std::uint32_t root = sets.find(piece);
        m_island[piece] = root == piece ? static_cast<std::uint32_t>(m_islandCount++) : m_island[root];
    }
}

std::size_t Connectivity::geometryOf(std::uint32_t piece) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(m_start, piece) - m_start.begin()) - 1;
}

ElementId Connectivity::element(std::uint32_t piece) const {
    const std::size_t plane = geometryOf(piece);
    return m_layers[plane].figures[piece - m_start[plane]].element;
}

PointD Connectivity::point(std::uint32_t piece) const {
    const std::size_t plane = geometryOf(piece);
    return m_layers[plane].figures[piece - m_start[plane]].anchor;
}

std::vector<std::uint32_t> Connectivity::piecesAt(LayerId layer, Point p, double reach) const {
    std::vector<std::uint32_t> pieces;
    FigureTable disc;
    disc.addDisc(p, reach);
    for (std::size_t row = 0; row + 1 < m_layers.size(); ++row) {
        if (m_layers[row].layer != layer) {
            continue;
        }
        m_layers[row].index.front().visit(disc.box(0), [&](std::uint32_t i) {
            if (spacingBetween(m_layers[row].figures, i, disc, 0, kTouchNm)) {
                pieces.push_back(m_start[row] + i);
            }
        });
    }
    std::ranges::sort(pieces);
    return pieces;
}

}  // namespace model
