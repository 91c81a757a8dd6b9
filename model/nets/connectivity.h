#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/figures/figures.h"
#include "model/geometry/box_index.h"

namespace model {

/// Two pieces of copper that touch.
struct Contact {
    std::uint32_t a = 0;  ///< pieces
    std::uint32_t b = 0;
    PointD location;  ///< a point both cover
    LayerId layer;    ///< the copper layer where they touch
};

/// What copper of a document is connected, by geometry alone: copper of one layer that touches (spacing 0, arcs and
/// areas taken exactly), and plated holes that touch copper of the layers they pass.
///
/// The unit is the piece: an element, one island of an area that has several, or one part of a track that holes sever
/// (SeveringHoles). Pieces are numbered layer by layer in document order, element by element; those of plated holes
/// come last. Copper without width, and what else holes without plating and cut-outs take away, is left out of account.
/// Copies of other steps are not part of it: they have a document of their own.
class Connectivity {
public:
    /// Errors: Cancelled.
    [[nodiscard]] static base::Result<Connectivity> of(const Document& document, base::Progress& progress);

    [[nodiscard]] std::size_t pieceCount() const { return m_start.back(); }
    [[nodiscard]] ElementId element(std::uint32_t piece) const;
    /// A point of the piece.
    [[nodiscard]] PointD point(std::uint32_t piece) const;
    /// Connected pieces have one island; islands are numbered by their first piece.
    [[nodiscard]] std::uint32_t island(std::uint32_t piece) const { return m_island[piece]; }
    [[nodiscard]] std::size_t islandCount() const { return m_islandCount; }
    /// All touching pairs, each once and where it was found first, in an order that does not depend on threads.
    [[nodiscard]] std::span<const Contact> contacts() const { return m_contacts; }
    /// The pieces on copper layer `layer` that cover a point or touch it within `reach` nm, rising.
    [[nodiscard]] std::vector<std::uint32_t> piecesAt(LayerId layer, Point p, double reach) const;

private:
    /// A copper layer, or (last) all plated holes.
    struct LayerGeometry {
        LayerId layer;
        FigureTable figures;
        std::vector<Box> boxes;
        std::vector<BoxIndex> index;  ///< one, or none before it is made
    };

    void makeLayers(const Document& document, const base::Progress& progress);
    [[nodiscard]] bool findContacts(const Document& document, base::Progress& progress);
    void touchWithin(std::size_t plane, std::size_t first, std::size_t end, std::vector<Contact>& found) const;
    void touchHoles(const Document& document, std::size_t first, std::size_t end, std::vector<Contact>& found) const;
    void joinIslands();
    [[nodiscard]] std::size_t geometryOf(std::uint32_t piece) const;

    std::vector<LayerGeometry> m_layers;
    std::vector<std::uint32_t> m_start;  ///< pieces of layer s: m_start[s] .. m_start[s + 1]
    std::vector<Contact> m_contacts;
    std::vector<std::uint32_t> m_island;
    std::size_t m_islandCount = 0;
};

}  // namespace model
